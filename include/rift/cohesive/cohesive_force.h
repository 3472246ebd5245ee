#ifndef rift_cohesive_cohesive_force_h
#define rift_cohesive_cohesive_force_h

#include <rift/base/exact_sum.h>
#include <rift/cohesive/cohesive_faces.h>
#include <rift/cohesive/face_kinematics.h>
#include <rift/cohesive/face_strengths.h>
#include <rift/discretization/ghost_exchange.h>
#include <rift/discretization/state.h>
#include <rift/material/elasticity.h>

#include <functional>
#include <optional>
#include <vector>

namespace rift
{
  /** Acceleration of a component of a node, m/s^2, if it is prescribed; empty
   * where none is. */
  using PrescribedAcceleration =
    std::function<std::optional<double>(NodeIndex, unsigned int)>;

  /** Energies of the cohesive elements that this rank owns, J. */
  struct CohesiveEnergy
  {
    /** Elastic, less what the faces were given when they began to open. */
    ExactSum recoverable;
    ExactSum fracture;
    ExactSum friction;
  };

  /** Numbers of faces of the whole body. */
  struct FaceCounts
  {
    /** Faces with a cohesive element, and those that have begun to open. */
    std::uint64_t inserted = 0, opened = 0;

    std::uint64_t failed = 0;

    /** Faces that have opened though the mesh is too coarse for their fracture
     * energy; see is_separation_too_short(). */
    std::uint64_t too_short = 0;
  };

  /**
   * The cohesive elements at work. A face that has been cut lies idle while
   * its two sides still share all their nodes; it becomes a member of
   * CohesiveFaces when the first of its corners parts.
   *
   * A face fails when all of its seven points have reached D = 1: nothing is
   * cut off then, so that failing releases no energy and separation has
   * used up the fracture energy times the area. Until contact takes over, a
   * failed face still resists overlap. A face whose sides have moved apart by
   * half of its size has failed in any case and resists nothing.
   */
  class CohesiveForce
  {
  public:
    /**
     * @param stiffnesses, densities of each material, and
     * @param frequency_limit square of the frequency up to which the elastic
     *   branches may take a loose cell, 1/s^2: they are as stiff as that
     *   allows.
     */
    CohesiveForce(Topology                    &topology,
                  const ReferenceCellData     &reference,
                  const FaceStrengths         &strengths,
                  std::vector<StiffnessMatrix> stiffnesses,
                  std::vector<double>          densities,
                  double                       frequency_limit);

    /**
     * Takes in what a split has changed: the nodes of the faces around the
     * split nodes, and the nodes that have parted, which hold_partings() will
     * keep together for this step.
     */
    void
    apply(const TopologyChange &change);

    /** Takes in which nodes the faces around these vertices have now. */
    void
    update_nodes(const std::vector<VertexIndex> &vertices);

    /** Adds the forces of all open faces, after updating their memory. */
    void
    add_to(State &state);

    /**
     * Holds nodes that have parted in this step together for the rest of it:
     * adds to each the bond force m_A a - f_A with the common acceleration a.
     * To be called when all other forces have been summed.
     *
     * @param prescribed where the motion of nodes is prescribed, the
     *   acceleration of a component of one: that is then the common one, and
     *   the grip takes what is left of the balance.
     * @return the bond forces, shared over the faces between the nodes such
     *   that the mean square of traction is smallest: what start_openings() needs at the end of the step.
     */
    std::vector<OpeningCorner>
    hold_partings(State &state, const PrescribedAcceleration &prescribed);

    /**
     * Passes the bond forces to the faces: from the next add_to() on, these
     * hold the sides together. Accelerations then do not jump (doc/theory.md,
     * section 5). To be called once after the drift.
     *
     * @param corners of the faces that this rank needs, in any order.
     */
    void
    start_openings(const State &state, std::vector<OpeningCorner> corners);

    /** The faces that this rank owns, in their order. */
    std::vector<CohesiveFaceRecord>
    records() const;

    /**
     * Goes on with faces of which records() has told, on any ranks; the
     * topology must have been cut as it was. Those that this rank does not
     * need are passed over.
     */
    void
    restore(const State &state, std::vector<CohesiveFaceRecord> records);

    /** Energies at the last add_to(), of the faces that this rank owns. */
    CohesiveEnergy
    energy() const;

    const CohesiveFaces &
    faces() const
    {
      return cohesive_faces;
    }

    /** Collective. */
    FaceCounts
    count_faces(const Communicator &communicator) const;

    /** Jump at a point of a face in its frame, m, and its traction, Pa. */
    struct PointState
    {
      Vector3<double> jump, traction;
    };

    PointState
    point_state(const State &state,
                std::size_t  index,
                unsigned int point) const;

  private:
    /** An opening corner and its two nodes among those of its parting. */
    struct Opening
    {
      FaceIndex    face;
      std::uint8_t corner;
      std::size_t  minus, plus;
    };

    /** Nodes that were one until this step, and what has opened between. */
    struct Parting
    {
      std::vector<NodeIndex> nodes;
      std::vector<Opening>   openings;
    };

    /** Calls f(face, corner of the face, its minus and its plus node) for all
     * faces around a vertex that have been cut. */
    template <typename Function>
    void
    for_each_cut_face(VertexIndex vertex, const Function &f) const;

    void
    activate(FaceIndex face, const State &state);

    /** Slope of the elastic branch of a face, Pa/m. */
    double
    elastic_slope(FaceIndex face, double area) const;

    /** Divides the bond forces of the nodes among the faces that open. */
    void
    share_bond_forces(const Parting               &parting,
                      std::vector<Vector3<double>> bond,
                      std::vector<OpeningCorner>  &shares) const;

    /** m_A a - f_A of each of the nodes that have parted, N. */
    static std::vector<Vector3<double>>
    bond_forces(const State                  &state,
                const Parting                &parting,
                const PrescribedAcceleration &prescribed);

    /** Gives the points of one face the traction that makes these forces. */
    void
    hold(const State         &state,
         const OpeningCorner *first,
         const OpeningCorner *last);

    double
    reference_area(FaceIndex face) const;

    /** Reads the nodes of an open face from the topology. */
    void
    update_face(FaceIndex face);

    static void
    scatter(const CohesiveBatch &batch, const FaceForces &forces, State &state);

    void
    note_failures(std::size_t batch_number, double time);

    /**
     * Lets go of faces whose sides have moved apart by `release_distance`
     * times the root of their area, since an element between them says nothing
     * of overlap once they have turned against each other. What is left of
     * their elastic energy counts as used up. A face let go of has no area.
     */
    void
    release_distant_faces(std::size_t           batch_number,
                          const FaceKinematics &kinematics,
                          double                time);

    static constexpr double release_distance = .5;

    /** Notes that a face has failed, if that is new. */
    void
    fail(CohesiveFaceInfo &info, double time);

    Topology                          &topology;
    const ReferenceCellData           &reference;
    const FaceStrengths               &strengths;
    const std::vector<StiffnessMatrix> stiffnesses;
    const std::vector<double>          densities;
    const double                       frequency_limit;
    const FaceQuadrature               quadrature;
    const MohrCoulomb                  law;

    CohesiveFaces cohesive_faces;

    /** Index in cohesive_faces of each interior face, if it has one. */
    std::vector<std::uint32_t> index_of_face;
    std::vector<Parting>       partings;
  };
} // namespace rift

#endif
