#include <rift/loading/prescribed_motion.h>

namespace rift
{
  PrescribedMotion::PrescribedMotion(const Topology       &topology,
                                     std::vector<Boundary> the_boundaries)
    : ModuleWithWork(topology, "prescribed motion", "loads")
    , topology(topology)
    , boundaries(std::move(the_boundaries))
  {
    for (const Boundary &boundary : boundaries)
      for (unsigned int d = 0; d < dim; ++d)
        if (const auto &text = boundary.parameters.velocity[d]; !text.empty())
          functions.emplace_back(text,
                                 "Boundary " + boundary.parameters.name +
                                   " / Velocity " + "xyz"[d],
                                 "m/s");
    update_nodes();
  }

  bool
  PrescribedMotion::is_needed(const BoundaryParameters &parameters)
  {
    const auto &v = parameters.velocity;
    return !v[0].empty() || !v[1].empty() || !v[2].empty();
  }

  void
  PrescribedMotion::update_nodes()
  {
    conditions.clear();
    function_of.assign(topology.n_nodes(),
                       {{no_function, no_function, no_function}});
    std::uint16_t function = 0;
    for (const Boundary &boundary : boundaries)
      {
        const auto nodes = surface_nodes(topology, boundary.surface);
        for (unsigned int d = 0; d < dim; ++d)
          {
            if (boundary.parameters.velocity[d].empty())
              continue;
            for (const NodeIndex node : nodes)
              if (topology.is_complete(topology.node_vertices[node]) &&
                  !prescribes(node, d))
                {
                  function_of[node][d] = function;
                  conditions.push_back(
                    {node, static_cast<std::uint8_t>(d), function});
                }
            ++function;
          }
      }
  }

  std::optional<double>
  PrescribedMotion::prescribed_acceleration(const State       &state,
                                            const double       time_step,
                                            const NodeIndex    node,
                                            const unsigned int component) const
  {
    if (!prescribes(node, component))
      return {};
    const TimeFunction &function = functions[function_of[node][component]];
    return (function.mean_after(state.time, time_step) -
            state.velocity[node][component]) /
           time_step;
  }

  std::vector<std::string>
  PrescribedMotion::warnings(const Discretization &body,
                             const double          time_step,
                             const std::uint64_t   n_steps) const
  {
    std::vector<std::string> result = doubts_of_order(body.communicator);
    if (body.communicator.is_root())
      add_doubts(functions, time_step, n_steps, result);
    return result;
  }

  std::vector<std::string>
  PrescribedMotion::doubts_of_order(const Communicator &communicator) const
  {
    // How many nodes each function counts at, and at how many another one with
    // another text does.
    std::vector<std::int64_t> counts(functions.size()),
      others(functions.size());
    std::uint16_t function = 0;
    for (const Boundary &boundary : boundaries)
      {
        const auto nodes = surface_nodes(topology, boundary.surface);
        for (unsigned int d = 0; d < dim; ++d)
          {
            if (boundary.parameters.velocity[d].empty())
              continue;
            for (const NodeIndex node : nodes)
              if (topology.owns_node(node))
                {
                  const std::uint16_t first = function_of[node][d];
                  counts[function] += first == function ? 1 : 0;
                  others[function] += functions[first].expression() !=
                                          functions[function].expression() ?
                                        1 :
                                        0;
                }
            ++function;
          }
      }
    communicator.sum(counts);
    communicator.sum(others);
    std::vector<std::string> result;
    for (std::size_t i = 0; i < functions.size(); ++i)
      if (counts[i] == 0 && others[i] > 0)
        result.push_back(
          functions[i].name() + ": \"" + functions[i].expression() +
          "\" has no effect, since all its nodes belong to boundaries that "
          "stand before it in the scene and prescribe this component as well. "
          "Remove one of them, or change their order.");
    return result;
  }

  void
  PrescribedMotion::impose(State       &state,
                           Activity    &activity,
                           const double time_step)
  {
    std::vector<double> targets;
    for (const TimeFunction &function : functions)
      targets.push_back(function.mean_after(state.time, time_step));

    work_done.begin_step();
    for (const Condition &c : conditions)
      {
        const double target   = targets[c.function];
        const double v        = state.velocity[c.node][c.component];
        double      &force    = state.force[c.node][c.component];
        const double needed   = state.mass[c.node] * (target - v) / time_step;
        const double reaction = needed - force;
        work_done.add(c.node, reaction * v, reaction * target, time_step);
        force = needed;
        if (target != 0)
          activity.wake_node(topology, c.node);
      }
  }
} // namespace rift
