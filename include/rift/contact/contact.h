#ifndef rift_contact_contact_h
#define rift_contact_contact_h

#include <rift/cohesive/fracture.h>
#include <rift/contact/contact_force.h>
#include <rift/contact/contact_parameters.h>
#include <rift/module/module.h>

namespace rift
{
  /** The cells of bodies that do not deform, as contact sees them. */
  struct RigidCells
  {
    /** The body that each cell slot belongs to, or invalid_index; empty where
     * there are none. */
    std::vector<std::uint32_t> body;

    /** Whether nothing but prescribed velocities moves a material. */
    std::vector<bool> is_driven;

    /** Number of bodies, on all ranks the same. */
    std::uint32_t n_bodies = 0;
  };

  /** Contact of surfaces and cracks as a module. */
  class Contact : public Module
  {
  public:
    /**
     * The body, and materials and stiffnesses, both by material index, must
     * outlive this object.
     *
     * @param fracture what breaks; null: nothing does.
     */
    Contact(Discretization                        &body,
            const std::vector<MaterialParameters> &materials,
            const std::vector<StiffnessMatrix>    &stiffnesses,
            const ContactParameters               &parameters,
            Fracture                              *fracture,
            RigidCells                             rigid);

    Stage
    stage() const override
    {
      return Stage::contact;
    }

    void
    limit_step(StepLimits &limits) const override;

    void
    prepare(Discretization &body, const StepBound &bound) override;

    std::string
    description() const override;

    void
    begin(StepContext &step) override
    {
      force->follow(step.body.state, step.body.activity, step.time_step);
      force->refuse_overlaps(step.body.state, materials);
    }

    void
    update_nodes(const std::vector<VertexIndex> &vertices) override
    {
      force->update_nodes(vertices);
    }

    void
    add_forces(StepContext &step) override;

    std::vector<Warning>
    warnings_so_far() const override;

    void
    after_drift(StepContext &step) override
    {
      force->follow(step.body.state, step.body.activity, step.time_step);
    }

    void
    account(const Discretization &body, EnergyTable &energies) const override;

    void
    save(const Discretization &body, Archive &archive) const override;

    void
    load(const Discretization &body, const Archive &archive) override;

    void
    count_items(const Topology &topology, WorkItems &items) const override
    {
      force->count_pairs(topology, items);
    }

    /** Number of pairs of the whole body that touch. Collective. */
    std::uint64_t
    count_touching() const
    {
      return force->count_touching();
    }

    /** Bytes of all ranks by part; see ContactForce::bytes(). Collective. */
    std::vector<std::pair<std::string, double>>
    bytes() const
    {
      return force->bytes();
    }

  private:
    /** Whether nothing moves a cell but prescribed velocities. */
    bool
    is_driven(CellIndex cell) const;

    /** What contact has to know of the cells. */
    std::vector<ContactCellConstants>
    cell_constants() const;

    /** Of each cell slot, the mass at a corner times what contact may add to the
     * square of a frequency of the loose cell, N/m. */
    std::vector<double>
    spare_stiffness(const StepBound &bound) const;

    /** Friction between each two materials. */
    std::vector<std::vector<double>>
    friction_table() const;

    Discretization                        &body;
    const std::vector<MaterialParameters> &materials;
    const std::vector<StiffnessMatrix>    &stiffnesses;
    const ContactParameters                parameters;
    Fracture *const                        fracture;
    const RigidCells                       rigid;
    std::optional<ContactForce>            force;
  };
} // namespace rift

#endif
