#ifndef rift_loading_prescribed_motion_h
#define rift_loading_prescribed_motion_h

#include <rift/discretization/activity.h>
#include <rift/discretization/work.h>
#include <rift/loading/loading_parameters.h>
#include <rift/loading/time_function.h>
#include <rift/mesh/surface.h>
#include <rift/module/module.h>

#include <optional>
#include <vector>

namespace rift
{
  /**
   * Components of the velocity that are prescribed on named surfaces. Where
   * surfaces meet, the first one in the .prm that prescribes a component
   * counts.
   */
  class PrescribedMotion : public Module
  {
  public:
    /** A surface and what is said of it. */
    struct Boundary
    {
      Surface            surface;
      BoundaryParameters parameters;
    };

    PrescribedMotion(const Topology       &topology,
                     std::vector<Boundary> boundaries);

    static bool
    is_needed(const BoundaryParameters &parameters);

    Stage
    stage() const override
    {
      return Stage::loads;
    }

    void
    constrain(StepContext &step) override
    {
      impose(step.body.state, step.body.activity, step.time_step);
    }

    void
    update_nodes(const std::vector<VertexIndex> &) override
    {
      update_nodes();
    }

    void
    account(const Discretization &, EnergyTable &energies) const override
    {
      energies["loads"].add(work_done.sum());
    }

    void
    save(const Discretization &, Archive &archive) const override
    {
      work_done.save("prescribed motion", archive);
    }

    void
    load(const Discretization &, const Archive &archive) override
    {
      work_done.load("prescribed motion", archive);
    }

    /**
     * Replaces the forces on prescribed components by those that make the
     * velocity after the kick the prescribed one, and counts the work of the
     * reactions.
     */
    void
    impose(State &state, Activity &activity, double time_step);

    /** Work of the reactions up to t_n, J, as of the last impose(). */
    Work &
    work()
    {
      return work_done;
    }

    /** Takes in nodes that a crack has made. */
    void
    update_nodes();

    /**
     * Acceleration of a component of a node during the step from t_n, m/s^2,
     * where its velocity is prescribed.
     */
    std::optional<double>
    prescribed_acceleration(const State &state,
                            double       time_step,
                            NodeIndex    node,
                            unsigned int component) const override;

  private:
    struct Condition
    {
      NodeIndex     node;
      std::uint8_t  component;
      std::uint16_t function;
    };

    const Topology             &topology;
    const std::vector<Boundary> boundaries;

    /** A function of time for each prescribed component of each boundary. */
    std::vector<TimeFunction> functions;

    std::vector<Condition>    conditions;
    std::vector<std::uint8_t> prescribed_components;
    Work                      work_done;
  };
} // namespace rift

#endif
