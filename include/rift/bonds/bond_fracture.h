#ifndef rift_bonds_bond_fracture_h
#define rift_bonds_bond_fracture_h

#include <rift/bonds/bonds.h>
#include <rift/bonds/node_insertion.h>
#include <rift/cohesive/fracture.h>

namespace rift
{
  /**
   * Cracks along planes through nodes, and bonds between the parts of nodes:
   * strength and fracture energy are those of the planes, not of the faces of the
   * mesh (doc/theory.md, section 4).
   */
  class BondFracture : public Fracture
  {
  public:
    /**
     * The body must outlive this object.
     *
     * @param materials by material index.
     * @param internal_force finds the cells near their strength; must outlive
     *   this object.
     * @param seed of the scatter of strength.
     */
    BondFracture(Discretization                        &body,
                 InternalForce                         &internal_force,
                 const std::vector<MaterialParameters> &materials,
                 unsigned int                           seed);

    std::vector<std::string>
    warnings(const Discretization &body,
             double                time_step,
             std::uint64_t         n_steps) const override;

    void
    prepare(Discretization &body, const StepBound &bound) override;

    void
    choose_cuts(const StepContext      &step,
                std::vector<FaceIndex> &faces) override;

    void
    follow_cut(const StepContext &step, const TopologyChange &change) override;

    void
    update_nodes(const std::vector<VertexIndex> &vertices) override
    {
      bonds.update_nodes(vertices);
    }

    void
    hold_partings(StepContext &step) override;

    void
    after_drift(StepContext &step) override;

    void
    account(const Discretization &body, EnergyTable &energies) const override;

    std::size_t
    n_faces() const override
    {
      return bonds.faces().faces.size();
    }

    std::optional<OpenFace>
    open_face(std::size_t index) const override;

    std::vector<NodeIndex>
    nodes_moving_with(const NodeIndex node) const override
    {
      return bonds.nodes_held_with(node);
    }

    std::vector<FaceMeans>
    means(const State &state) const override;

    FaceCounts
    count_faces(const Communicator &communicator) const override
    {
      return rift::count_faces(topology, 0, communicator);
    }

    void
    leave_failed_faces_to_contact(const std::uint64_t interval,
                                  const double        opening) override
    {
      contact_interval = interval;
      contact_opening  = opening;
      bonds.leave_to_contact();
    }

    /** Bonds have no stiffness. */
    double
    share_of_stiffness() const override
    {
      return 0;
    }

    void
    save(const Discretization &body, Archive &archive) const override;

    void
    load(const Discretization &body, const Archive &archive) override;

    void
    count_items(const Topology &topology, WorkItems &items) const override;

  private:
    /** Tells other ranks of corners of faces that have failed. */
    void
    tell_failed(std::vector<CornerNews> &news) const;

    /** Takes in that a corner of a face has failed. */
    void
    fail_corner(std::uint32_t place, unsigned int corner, double time);

    /** Has a face pass on to a state, unless it is there or further already. */
    void
    advance_state(const CrackFaces::Face &face, FaceState next);

    /** Leaves failed faces to contact that are open, or have slid far. */
    void
    release_faces();

    Discretization &body;
    InternalForce  &internal_force;
    NodeStrengths   strengths;
    StressBounds    bounds;
    CrackPlanes     planes;
    Bonds           bonds;
    NodeInsertion   insertion;

    /** See leave_failed_faces_to_contact(). */
    std::uint64_t contact_interval = 0;
    double        contact_opening  = 0;
  };
} // namespace rift

#endif
