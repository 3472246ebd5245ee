#ifndef rift_loading_body_force_h
#define rift_loading_body_force_h

#include <rift/base/number_text.h>
#include <rift/loading/effect_check.h>
#include <rift/module/module.h>

#include <cmath>
#include <numeric>

namespace rift
{
  /** Gravity; not constructed where there is none. */
  class BodyForce : public Module
  {
  public:
    /** @param gravity acceleration, m/s^2. */
    explicit BodyForce(const Vector3<double> &gravity)
      : gravity(gravity)
    {
    }

    Stage
    stage() const override
    {
      return Stage::loads;
    }

    /** Everything moves from the start. */
    void
    prepare(Discretization &body, const StepBound &) override
    {
      body.activity.wake_all(body.topology);
    }

    void
    check_effect(const Discretization &body,
                 const IsPrescribed   &is_prescribed) const override
    {
      std::vector<NodeIndex> nodes(body.state.n_nodes());
      std::iota(nodes.begin(), nodes.end(), NodeIndex{0});
      EffectCheck(body, is_prescribed)
        .refuse_idle("Body force / Gravity",
                     to_text(gravity[0]) + ", " + to_text(gravity[1]) + ", " +
                       to_text(gravity[2]),
                     nodes,
                     [this](std::size_t) { return gravity; });
    }

    void
    add_forces(StepContext &step) override
    {
      add_to(step.body.state);
    }

    void
    account(const Discretization &body, EnergyTable &energies) const override
    {
      energies["loads"].add(work(body.topology, body.state));
    }

    /** Adds its force at t_n to that of each node. */
    void
    add_to(State &state) const
    {
      for (std::size_t i = 0; i < state.n_nodes(); ++i)
        // Where the mass is infinite, other ranks know the motion.
        if (std::isfinite(state.mass[i]))
          for (unsigned int d = 0; d < dim; ++d)
            state.force[i][d] += state.mass[i] * gravity[d];
    }

    /** Work since the start on the nodes that this rank owns, J: that of the
     * displacements. */
    ExactSum
    work(const Topology &topology, const State &state) const
    {
      ExactSum sum;
      for (NodeIndex i = 0; i < state.n_nodes(); ++i)
        if (topology.owns_node(i))
          sum.add(state.mass[i] * dot(gravity, state.displacement[i].vector()));
      return sum;
    }

  private:
    const Vector3<double> gravity;
  };
} // namespace rift

#endif
