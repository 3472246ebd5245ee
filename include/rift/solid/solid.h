#ifndef rift_solid_solid_h
#define rift_solid_solid_h

#include <rift/module/module.h>
#include <rift/solid/internal_force.h>

namespace rift
{
  /** The elastic forces of the cells as a module. */
  class Solid : public Module
  {
  public:
    /**
     * @param laws by material index.
     * @param material_names by material index.
     */
    Solid(const Discretization    &body,
          std::vector<Elasticity>  laws,
          std::vector<std::string> material_names)
      : force(body.topology, body.reference, std::move(laws))
      , material_names(std::move(material_names))
    {
    }

    /** The force of the cells, and their stresses. */
    InternalForce &
    internal_force()
    {
      return force;
    }

    Stage
    stage() const override
    {
      return Stage::internal_forces;
    }

    void
    add_forces(StepContext &step) override;

    void
    account(const Discretization &body, EnergyTable &energies) const override
    {
      energies["strain"].add(force.strain_energy(body.state));
    }

    void
    declare_fields(FieldList &list) const override
    {
      InternalForce::declare_fields(list, &force);
    }

    void
    save(const Discretization &body, Archive &archive) const override;

    void
    load(const Discretization &body, const Archive &archive) override;

  private:
    InternalForce                  force;
    const std::vector<std::string> material_names;
  };
} // namespace rift

#endif
