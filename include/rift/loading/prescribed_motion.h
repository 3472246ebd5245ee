#ifndef rift_loading_prescribed_motion_h
#define rift_loading_prescribed_motion_h

#include <rift/discretization/activity.h>
#include <rift/loading/loading_parameters.h>
#include <rift/loading/time_function.h>
#include <rift/mesh/surface.h>
#include <rift/module/module_with_work.h>

#include <optional>
#include <vector>

namespace rift
{
  /**
   * Components of the velocity that are prescribed on named surfaces. Where
   * surfaces meet, the first one in the .prm that prescribes a component
   * counts.
   */
  class PrescribedMotion : public ModuleWithWork
  {
  public:
    /** A surface and what is said of it. */
    struct Boundary
    {
      /** The faces, and the velocities of their nodes. */
      Surface            surface;
      BoundaryParameters parameters;
    };

    /** Reads the functions of time. The topology must outlive this object. */
    PrescribedMotion(const Topology       &topology,
                     std::vector<Boundary> boundaries);

    /** Whether a component of the velocity is prescribed. */
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

    /**
     * Replaces the forces on prescribed components by those that make the
     * velocity after the kick the prescribed one, and counts the work of the
     * reactions.
     */
    void
    impose(State &state, Activity &activity, double time_step);

    /** Takes in nodes that a crack has made. */
    void
    update_nodes();

    /** Whether a component of the velocity of a node is prescribed. */
    bool
    prescribes(const NodeIndex    node,
               const unsigned int component) const override
    {
      return function_of[node][component] != no_function;
    }

    /**
     * Acceleration of a component of a node during the step from t_n, m/s^2,
     * where its velocity is prescribed.
     */
    std::optional<double>
    prescribed_acceleration(const State &state,
                            double       time_step,
                            NodeIndex    node,
                            unsigned int component) const override;

    /** Of velocities that the steps do not resolve, and of those that count at
     * no node since boundaries that come first say otherwise. Collective. */
    std::vector<std::string>
    warnings(const Discretization &body,
             double                time_step,
             std::uint64_t         n_steps) const override;

    /** Of velocities that count at no node. Collective. */
    std::vector<std::string>
    doubts_of_order(const Communicator &communicator) const;

  private:
    static constexpr std::uint16_t no_function = 0xffff;

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

    /** By boundary, function and node. */
    std::vector<Condition> conditions;

    /** The function of each component of each node, or no_function. */
    std::vector<std::array<std::uint16_t, dim>> function_of;
  };
} // namespace rift

#endif
