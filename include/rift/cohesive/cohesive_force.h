#ifndef rift_cohesive_cohesive_force_h
#define rift_cohesive_cohesive_force_h

#include <rift/base/exact_sum.h>
#include <rift/cohesive/cohesive_faces.h>
#include <rift/cohesive/face_kinematics.h>
#include <rift/cohesive/face_slopes.h>
#include <rift/cohesive/face_strengths.h>
#include <rift/discretization/activity.h>
#include <rift/discretization/field_list.h>
#include <rift/discretization/ghost_exchange.h>
#include <rift/discretization/state.h>

#include <functional>
#include <optional>
#include <variant>
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
    /** Elastic, less what the faces were given when they began to open and
     * have not drawn from the body since. */
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
   * The cohesive elements at work.
   *
   * In the extrinsic model a face that has been cut lies idle while its two
   * sides still share all their nodes; it becomes a member of CohesiveFaces
   * when the first of its corners parts. In the intrinsic model all faces are
   * members from the start, and need no memory until the first of a batch
   * leaves the envelope.
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
     * @param model extrinsic or intrinsic.
     * @param slope of the elastic branches.
     * @param least_share of its strength with which a face may begin to open,
     *   see Insertion; faces that bear less than all of it then are as weak as
     *   that (doc/theory.md, eq. 11c).
     */
    CohesiveForce(Topology                 &topology,
                  const ReferenceCellData  &reference,
                  const FaceStrengths      &strengths,
                  CohesiveParameters::Model model,
                  FaceSlope                 slope,
                  double                    least_share = 1);

    /**
     * Intrinsic model: has all faces that have been cut carry a cohesive
     * element. To be called once, before the first step, when all ranks know
     * the nodes of all cells.
     */
    void
    start_all(const State &state);

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

    /**
     * Adds the forces of all faces, after updating their memory. Faces between
     * cells at rest that have no memory are passed over.
     */
    void
    add_to(State &state, const Activity &activity);

    /**
     * Holds nodes that have parted in this step together for the rest of it:
     * adds to each the bond force m_A a - f_A with the common acceleration a.
     * To be called when all other forces have been summed.
     *
     * @param prescribed where the motion of nodes is prescribed, the
     *   acceleration of a component of one: that is then the common one, and
     *   the grip takes what is left of the balance.
     * @return the bond forces, shared over the faces between the nodes such
     *   that the mean square of traction is smallest: what start_openings()
     *   needs at the end of the step.
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

    /** The faces that this rank owns and that have opened, in their order. */
    std::vector<CohesiveFaceRecord>
    records() const;

    /**
     * Goes on with faces of which records() has told, on any ranks; the
     * topology must have been cut as it was. Those that this rank does not
     * need are passed over.
     */
    void
    restore(const State &state, std::vector<CohesiveFaceRecord> records);

    /**
     * Energies of the faces that this rank owns.
     *
     * @param state as at the last add_to().
     */
    CohesiveEnergy
    energy(const State &state) const;

    /**
     * Has failed faces let go as soon as they are open, since contact then
     * resists their overlap; see release_distant_faces().
     *
     * @param interval faces are let go of at the end of so many steps, when
     *   contact looks for pairs.
     */
    void
    leave_failed_faces_to_contact(const std::uint64_t interval)
    {
      contact_interval = interval;
    }

    /** Whether the sides of a face are bonded, or a cohesive element resists
     * their overlap. */
    bool
    holds(FaceIndex face) const;

    /** Rises whenever a face begins to open, fails or is let go of. */
    std::uint64_t
    n_events() const
    {
      return event_counter;
    }

    /** Whether a face has begun to open: in the intrinsic model, whether it
     * has damage. */
    bool
    has_opened(std::size_t index) const;

    const CohesiveFaces &
    faces() const
    {
      return cohesive_faces;
    }

    /** Declares what is known of cohesive faces.
     * @param force null: the names alone. */
    static void
    declare_fields(FieldList &list, const CohesiveForce *force);

    /** Collective. */
    FaceCounts
    count_faces(const Communicator &communicator) const;

    /** Jump at a point of a face in its frame, m, its traction, Pa, its damage
     * and the two parts of that. */
    struct PointState
    {
      Vector3<double> jump, traction;
      double          damage, opening, slip;
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
    activate(FaceIndex face, const State &state, double share);

    /** What the strength of a face is times, by the forces on the corners with
     * which it begins to open. */
    double
    share_at_start(const State         &state,
                   const OpeningCorner *first,
                   const OpeningCorner *last) const;

    /** Strength of a cohesive element, its share included. */
    FaceStrength
    strength_of(const CohesiveFaceInfo &info) const
    {
      return strengths.strength(info.face).times(info.share);
    }

    /** Gives a batch a memory in which nothing has happened yet. */
    void
    make_memory(std::size_t batch_number);

    /** Makes the memory of one face that of an intact one. */
    void
    start_points(std::size_t index);

    /** Whether all cells beside the faces of a batch are at rest. */
    bool
    is_at_rest(std::size_t batch_number, const Activity &activity) const;

    /** Tractions of a batch without memory.
     * @param[out] yields whether any point leaves the envelope. */
    template <typename Law>
    FaceTractions
    intact_tractions(const CohesiveBatch  &batch,
                     const FaceKinematics &kinematics,
                     bool                 &yields) const;

    /** Updates the memory of a batch and returns its tractions. */
    template <typename Law>
    FaceTractions
    update_memory(const Law            &law,
                  std::size_t           batch_number,
                  const FaceKinematics &kinematics,
                  const State          &state);

    template <typename Law>
    void
    add_forces(const Law &law, State &state, const Activity &activity);

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

    /** Reads the nodes of an open face from the topology. */
    void
    update_face(FaceIndex face);

    static void
    scatter(const CohesiveBatch &batch, const FaceForces &forces, State &state);

    /** Elastic energies of the faces of a batch, J. */
    template <typename Law>
    Simd
    elastic_energy(const State &state, const CohesiveBatch &batch) const;

    Simd
    elastic_energy(const State &state, const CohesiveBatch &batch) const;

    /** Debts of the faces of a batch, J; CohesivePoint::debt. */
    Simd
    debt_of(const CohesiveBatch &batch) const;

    void
    note_failures(std::size_t batch_number, double time);

    /**
     * Lets go of faces with damage whose sides have moved apart by
     * `release_distance` times the root of their area (or their least height,
     * where that is less), since an element between them says nothing of
     * overlap once they have turned against each other. What is left of their
     * elastic energy counts as used up. A face let go of has no area.
     */
    void
    release_distant_faces(std::size_t           batch_number,
                          const FaceKinematics &kinematics,
                          const State          &state);

    static constexpr double release_distance = .5;

    /** The failed faces of a batch whose corners are all apart. */
    SimdMask
    is_open_and_failed(std::size_t           batch_number,
                       const FaceKinematics &kinematics) const;

    /** Notes that a face has failed, if that is new. */
    void
    fail(CohesiveFaceInfo &info, double time);

    using AnyLaw =
      std::variant<MohrCoulomb<StraightBranch>, MohrCoulomb<ParabolicBranch>>;

    static AnyLaw
    law_of(CohesiveParameters::Model model);

    Topology                &topology;
    const ReferenceCellData &reference;
    const FaceStrengths     &strengths;
    const FaceSlope          slope;
    const AnyLaw             law;
    const double             part_of_fracture;
    const double             least_share;
    const FaceQuadrature     quadrature;

    CohesiveFaces cohesive_faces;
    std::uint64_t event_counter = 0;

    /** Zero without contact. */
    std::uint64_t contact_interval = 0;

    /** Index in cohesive_faces of each interior face, if it has one. */
    std::vector<std::uint32_t> index_of_face;
    std::vector<Parting>       partings;
  };
} // namespace rift

#endif
