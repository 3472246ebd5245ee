#ifndef rift_bonds_bonds_h
#define rift_bonds_bonds_h

#include <rift/base/plain_bytes.h>
#include <rift/bonds/bond_law.h>
#include <rift/bonds/crack_faces.h>
#include <rift/bonds/crack_planes.h>
#include <rift/bonds/node_strengths.h>
#include <rift/discretization/prescribed_acceleration.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>

#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

namespace rift
{
  /** Energy that bonds have used, J. */
  struct BondEnergy
  {
    /** By damage, by sliding under pressure, and by closing of open bonds, which
     * is an inelastic impact. */
    double fracture = 0, friction = 0, closing = 0;
  };

  /**
   * What holds two nodes together that a crack has parted at a vertex: all cut
   * faces between their cells are one bond, whose area and traction are those of
   * its crack plane (doc/theory.md, eq. O6 to O13).
   */
  struct Bond
  {
    /** Its nodes among those of the vertex; the first has the smaller cell. */
    std::uint32_t parts[2];

    /** Unit normal of the crack plane, from the first node to the second, in
     * the undeformed body and now; projected area, m^2. */
    Vector3<double> plane, normal;
    double          area;

    /** Root of the mean area of its faces, m. */
    double size;

    /** Strength of the plane, and what is left of it. */
    FaceStrength    strength;
    BondLaw::Memory memory;

    /** What the second node does to the first, per projected area, Pa. */
    Vector3<double> traction;

    /** Up to t_n. */
    BondEnergy energy;

    /** Whether it has yet to go through its first step, which sets its excess;
     * whether its energy up to t_n is known already; whether its nodes have
     * moved as one since the last step. */
    bool is_new, is_counted, is_tied;

    /** Whether contact has taken over all of its faces: it bears nothing. */
    bool is_released;

    /** Its faces: a range of VertexBonds::fan. */
    std::uint32_t fan_begin, fan_end;
  };

  /** The bonds at one vertex. */
  struct VertexBonds
  {
    /** Where, and whether the surface of the body is there. */
    VertexIndex vertex;
    bool        is_on_surface;

    /** The nodes, by their smallest cells, and the bonds between them. */
    std::vector<NodeIndex> parts;
    std::vector<Bond>      bonds;

    /** A face of a bond. */
    struct FanFace
    {
      /** Index in CrackFaces, and the corner of the face at this vertex. */
      std::uint32_t face;
      std::uint8_t  corner;

      /** Crack plane in the frame of the undeformed face, times its area. */
      Vector3<double> plane;
    };
    std::vector<FanFace> fan;

    /** For each part the first of those that bonds connect it to; and for the
     * others the inverse of the Laplacian of the bonds with their areas as
     * weights, 1/m^2, row by row. */
    std::vector<std::uint32_t> root;
    std::vector<double>        inverse;
  };

  /** A bond in a checkpoint. */
  struct BondRecord
  {
    /** The first cell of its nodes, and their corners. */
    GlobalCellIndex cells[2];
    std::uint32_t   corners[2];

    /** Bond::is_tied. */
    std::uint64_t is_tied, is_released;

    /** See Bond. */
    Vector3<double> plane, normal, traction;
    double          damage, excess, fracture, friction, closing;
  };

  template <>
  struct HasPlainBytes<BondRecord> : std::true_type
  {
    static_assert(sizeof(BondRecord) == 4 * 8 + 14 * sizeof(double));
  };

  /** The bonds at all complete vertices. */
  class Bonds
  {
  public:
    /** All must outlive this object. */
    Bonds(const Topology          &topology,
          const ReferenceCellData &reference,
          const NodeStrengths     &strengths,
          const CrackPlanes       &planes);

    /**
     * Makes the bonds at vertices where nodes have split. A bond between parts
     * of two nodes that had one goes on as that was, with an area of its own.
     */
    void
    rebuild(const State                  &state,
            const std::vector<NodeSplit> &splits,
            double                        time_step);

    /** What the bonds of owned vertices remember, for a checkpoint. */
    std::vector<BondRecord>
    records() const;

    /** Goes on with the bonds of the records, of any ranks: the topology has
     * been cut as it was. */
    void
    restore(const State &state, const std::vector<BondRecord> &records);

    /** Slip over the size of a face from which a failed bond leaves pressure to
     * contact, and slip over which it does so. */
    static constexpr double slip_to_contact = .1, slip_of_fading = .05;

    /**
     * Ends bonds all of whose faces have been released and that are open or have
     * faded: contact acts in their place. To be called after faces have been
     * released.
     */
    void
    release(const State &state);

    /** Takes in which nodes the faces around these vertices have now. */
    void
    update_nodes(const std::vector<VertexIndex> &vertices)
    {
      crack_faces.update_nodes(vertices);
    }

    /**
     * Holds pairs of nodes together as far as their bonds bear it: adds the
     * forces of the bonds to the state's and updates what bonds remember. All
     * other forces are known (eq. O8).
     *
     * @param prescribed where the motion of nodes is prescribed, the
     *   acceleration of a component.
     */
    void
    hold(State                        &state,
         double                        time_step,
         const PrescribedAcceleration &prescribed);

    /** Corners of faces at which all strength has been lost in the last
     * hold(). */
    const std::vector<VertexBonds::FanFace> &
    newly_failed() const
    {
      return failed_corners;
    }

    /** The bonds, vertex by vertex. */
    const std::vector<VertexBonds> &
    vertices() const
    {
      return groups;
    }

    /** The faces that have begun to open. */
    CrackFaces &
    faces()
    {
      return crack_faces;
    }

    /** The faces that have begun to open. */
    const CrackFaces &
    faces() const
    {
      return crack_faces;
    }

  private:
    /** Numbers of the solution at one vertex, kept to save allocations. */
    struct Work
    {
      /** By part: velocity after the kick, inverse mass by component, force that
       * keeps it with the others, and potential of these forces. */
      std::vector<Vector3<double>> velocity, inverse_mass, bond_force,
        potential;

      /** By part: sum of mass and of momentum over those with the same root. */
      std::vector<double>          mass;
      std::vector<Vector3<double>> momentum;

      /** By bond: traction of the step before; traction by component that a
       * relative velocity makes when it is stopped within a step; opening; and
       * the part of the pressure that it bears. */
      std::vector<Vector3<double>> before, stiffness;
      std::vector<double>          gap, pressure_share;
    };

    /** The bond that there was between two nodes, from the first to the second;
     * called once for each pair. */
    using Heritage =
      std::function<std::optional<Bond>(NodeIndex first, NodeIndex second)>;

    /** What the bonds of a vertex leave to those between the parts of its
     * nodes. `old` must outlive the result. */
    static Heritage
    heritage(const VertexBonds &old, const std::vector<NodeSplit> &splits);

    /** The bonds at a vertex as it is now. */
    VertexBonds
    make_group(const State &state, VertexIndex vertex, const Heritage &before);

    /** Sets the area and the faces of a bond, and the plane of a new one. */
    void
    set_geometry(VertexBonds                  &group,
                 Bond                         &bond,
                 const std::vector<CutCorner> &corners,
                 const State                  &state);

    /** Finds the parts that bonds connect, and the inverse of their
     * Laplacian. */
    static void
    set_laplacian(VertexBonds &group);

    /** Part of the pressure that a bond bears: less than 1 once it has failed and
     * slid so far that contact takes over. */
    double
    pressure_share(const VertexBonds &group,
                   const Bond        &bond,
                   const State       &state) const;

    /** Turns the normals with the faces. */
    void
    update_normals(VertexBonds &group, const State &state) const;

    /** Velocities after the kick without bonds; whether a component is
     * prescribed. */
    bool
    kick(const VertexBonds            &group,
         const State                  &state,
         double                        time_step,
         const PrescribedAcceleration &prescribed);

    /**
     * Keeps all parts together, with the smallest mean square of traction.
     *
     * @return whether all bonds bear it; otherwise nothing has changed.
     */
    bool
    tie(VertexBonds &group, const State &state, double time_step);

    /** Prepares solve(), with the tractions of the last step. */
    void
    prepare(VertexBonds &group, const State &state, double time_step);

    /** Changes the velocities of the nodes of a bond by a traction. */
    void
    push(const Bond &bond, const Vector3<double> &traction, double time_step);

    /** Finds the tractions, bond by bond and again until they agree. */
    void
    solve(VertexBonds &group, double time_step);

    /** Adds the forces, and updates what the bonds remember. */
    void
    finish(VertexBonds &group, State &state, double time_step, bool is_tied);

    /** Damages a bond by the motion of its nodes. */
    void
    soften(const VertexBonds &group, Bond &bond, double time_step);

    const Topology          &topology;
    const ReferenceCellData &reference;
    const NodeStrengths     &strengths;
    const CrackPlanes       &planes;
    const BondLaw            law;

    CrackFaces                                     crack_faces;
    std::vector<VertexBonds>                       groups;
    std::unordered_map<VertexIndex, std::uint32_t> group_of_vertex;
    std::vector<VertexBonds::FanFace>              failed_corners;
    Work                                           work;
  };
} // namespace rift

#endif
