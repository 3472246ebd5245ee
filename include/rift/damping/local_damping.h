#ifndef rift_damping_local_damping_h
#define rift_damping_local_damping_h

#include <rift/material/material_parameters.h>
#include <rift/module/module_with_work.h>

#include <vector>

namespace rift
{
  /**
   * Local, non-viscous damping for quasi-static problems: each component of the
   * force on a node is reduced by a share of itself where it accelerates the
   * node, and raised where it slows it down, F - alpha |F| sign(v) (Cundall
   * 1987; doc/theory.md, eq. 34). A steady state is not changed, and all
   * frequencies are damped alike. Nodes of rigid bodies are left alone.
   *
   * It acts on the sum of all other forces, but not on reactions, and after
   * nodes that part have been held together, which keeps their common
   * acceleration. Velocities are those of half a step ago.
   */
  class LocalDamping : public ModuleWithWork
  {
  public:
    /**
     * @param coefficient alpha, in (0, 1).
     * @param materials by material index.
     */
    LocalDamping(const Topology                        &topology,
                 const std::vector<MaterialParameters> &materials,
                 double                                 coefficient);

    Stage
    stage() const override
    {
      return Stage::loads;
    }

    void
    constrain(StepContext &step) override
    {
      add_to(step.body.state, step.body.activity);
    }

    void
    count_work(const StepContext &step) override
    {
      count_work(step.body.state, step.time_step);
    }

    /** Adds the damping forces to `state.force`. */
    void
    add_to(State &state, const Activity &activity);

    /** Adds up what the step dissipates; between last force and kick. */
    void
    count_work(const State &state, double time_step);

  private:
    const double coefficient;

    /** Nodes of rigid bodies; those that cracks have made are beyond it. */
    std::vector<bool> is_rigid;

    std::vector<NodalVector> forces;
  };
} // namespace rift

#endif
