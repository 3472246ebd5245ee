#include <rift/damping/local_damping.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  LocalDamping::LocalDamping(const Topology                        &topology,
                             const std::vector<MaterialParameters> &materials,
                             const double                           coefficient)
    : ModuleWithWork(topology, "local damping", "local damping")
    , coefficient(coefficient)
    , is_rigid(topology.n_nodes(), false)
  {
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (!topology.is_padding(cell) &&
          materials[topology.material(cell)].is_rigid())
        for (unsigned int c = 0; c < n_corners; ++c)
          is_rigid[topology.node(cell, c)] = true;
  }

  void
  LocalDamping::add_to(State &state, const Activity &activity)
  {
    forces.assign(state.n_nodes(), {});
    is_rigid.resize(state.n_nodes(), false);
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      // Where the mass is infinite, other ranks know the motion.
      if (activity.is_block_awake(i / Activity::block_size) && !is_rigid[i] &&
          std::isfinite(state.mass[i]))
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double v = state.velocity[i][d];
            if (v == 0)
              continue;
            forces[i][d] =
              -coefficient * std::copysign(std::abs(state.force[i][d]), v);
            state.force[i][d] += forces[i][d];
          }
  }

  void
  LocalDamping::count_work(const State &state, const double time_step)
  {
    work_done.begin_step();
    for (NodeIndex i = 0; i < forces.size(); ++i)
      work_done.add(state, i, -1. * forces[i].vector(), time_step);
  }
} // namespace rift
