#include <rift/loading/prescribed_motion.h>

namespace rift
{
  PrescribedMotion::PrescribedMotion(const Topology       &topology,
                                     std::vector<Boundary> the_boundaries)
    : topology(topology)
    , boundaries(std::move(the_boundaries))
    , work_done(topology)
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
    prescribed_components.assign(topology.n_nodes(), 0);
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
                  !((prescribed_components[node] >> d) & 1))
                {
                  prescribed_components[node] |= 1u << d;
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
    if (!((prescribed_components[node] >> component) & 1))
      return {};
    // Asked for a few nodes of a few steps: a search will do.
    for (const Condition &c : conditions)
      if (c.node == node && c.component == component)
        return (functions[c.function](state.time + .5 * time_step) -
                state.velocity[node][component]) /
               time_step;
    return {};
  }

  void
  PrescribedMotion::impose(State       &state,
                           Activity    &activity,
                           const double time_step)
  {
    std::vector<double> targets;
    for (const TimeFunction &function : functions)
      targets.push_back(function(state.time + .5 * time_step));

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
