#ifndef rift_bonds_bonds_h
#define rift_bonds_bonds_h

#include <rift/base/plain_bytes.h>
#include <rift/bonds/bond_solver.h>
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
  /** A bond in a checkpoint. */
  struct BondRecord
  {
    /** The first cells of its nodes, and their corners. */
    GlobalCellIndex cells[2];
    std::uint32_t   corners[2];

    /** Bond::is_tied and Bond::is_released, VertexBonds::is_yielding. */
    std::uint64_t is_tied, is_released, is_yielding;

    /** See Bond. */
    Vector3<double> plane, normal, traction;
    double          damage, slip_damage, excess, gap, pressure_share;

    /** Of all bonds at the vertex, J. */
    BondEnergy energy;
  };

  template <>
  struct HasPlainBytes<BondRecord> : std::true_type
  {
    static_assert(sizeof(BondRecord) == 5 * 8 + 17 * sizeof(double));
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

    /** Has contact take over from bonds that have failed. */
    void
    leave_to_contact()
    {
      solver.has_contact = true;
    }

    /**
     * Ends bonds all of whose faces have been released and that are open or have
     * faded: contact acts in their place. To be called after faces have been
     * released.
     */
    void
    release();

    /** Takes in which nodes the faces around these vertices have now. */
    void
    update_nodes(const std::vector<VertexIndex> &vertices)
    {
      crack_faces.update_nodes(vertices);
    }

    /**
     * Holds pairs of nodes together as far as their bonds bear it: adds the
     * forces of the bonds to the state's and updates what bonds remember. All
     * other forces are known (eq. 42).
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

    /** The nodes that bonds hold together with a node, with itself, in a step
     * in which no bond at its vertex gives way. */
    std::vector<NodeIndex>
    nodes_held_with(NodeIndex node) const;

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
    /** A bond with its history. */
    struct KnownBond
    {
      Bond        bond{};
      BondHistory history{};
    };

    /** The bond that there was between two nodes, from the first to the
     * second. */
    using Heritage = std::function<std::optional<KnownBond>(NodeIndex first,
                                                            NodeIndex second)>;

    /** What the bonds of a vertex leave to those between the parts of its
     * nodes, which have split there. Both must outlive the result. */
    static Heritage
    heritage(const VertexBonds &old, const std::vector<NodeSplit> &splits);

    /** The bonds at a vertex as it is now. */
    VertexBonds
    make_group(const State &state, VertexIndex vertex, const Heritage &before);

    /** Sets the area and the faces of a bond, and the plane of a new one. */
    void
    set_geometry(VertexBonds                  &group,
                 Bond                         &bond,
                 BondHistory                  &history,
                 const std::vector<CutCorner> &corners,
                 const State                  &state);

    /** Turns the normals with the faces. */
    void
    update_normals(VertexBonds &group, const State &state) const;

    const Topology          &topology;
    const ReferenceCellData &reference;
    const NodeStrengths     &strengths;
    const CrackPlanes       &planes;
    BondSolver               solver;

    CrackFaces                                     crack_faces;
    std::vector<VertexBonds>                       groups;
    std::unordered_map<VertexIndex, std::uint32_t> group_of_vertex;
    std::vector<VertexBonds::FanFace>              failed_corners;
  };
} // namespace rift

#endif
