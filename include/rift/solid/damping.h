#ifndef rift_solid_damping_h
#define rift_solid_damping_h

#include <rift/discretization/activity.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/module/module_with_work.h>

#include <vector>

namespace rift
{
  /**
   * Viscous stress eta d, with d the rate of deformation (doc/theory.md,
   * eq. 8), taken at the velocity of half a step ago. Only constructed when a
   * material has a viscosity.
   */
  class Damping : public ModuleWithWork
  {
  public:
    /** @param viscosities Pa s, one for each material index. */
    Damping(const Topology          &topology,
            const ReferenceCellData &reference,
            std::vector<double>      viscosities);

    Stage
    stage() const override
    {
      return Stage::loads;
    }

    void
    limit_step(StepLimits &limits) const override
    {
      for (std::size_t i = 0; i < viscosities.size(); ++i)
        limits.materials[i].viscosity = viscosities[i];
    }

    void
    prepare(Discretization &body, const StepBound &) override
    {
      body.exchange.include_velocities();
    }

    void
    add_forces(StepContext &step) override
    {
      add_to(step.body.state, step.body.activity);
    }

    void
    count_work(const StepContext &step) override
    {
      count_work(step.body.state, step.time_step);
    }

    /** Adds the viscous forces of all cells that are awake. */
    void
    add_to(State &state, const Activity &activity);

    /** Adds up what the step dissipates; between last force and kick. */
    void
    count_work(const State &state, double time_step);

  private:
    const Topology           &topology;
    const ReferenceCellData  &reference;
    const std::vector<double> viscosities;

    std::vector<NodalVector> forces;
  };
} // namespace rift

#endif
