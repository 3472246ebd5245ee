#include <rift/base/check.h>
#include <rift/time_integration/central_difference.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** Whether the nodes of a block have neither force nor velocity. */
    bool
    is_block_at_rest(const State &state, const std::size_t begin)
    {
      const std::size_t end =
        std::min(begin + Activity::block_size, state.n_nodes());
      for (std::size_t i = begin; i < end; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          if (state.force[i][d] != 0 || state.velocity[i][d] != 0)
            return false;
      return true;
    }
  } // namespace

  void
  advance(State &state, const Activity &activity, const double time_step)
  {
    const std::size_t n_nodes = state.n_nodes();
    for (std::size_t begin = 0; begin < n_nodes; begin += Activity::block_size)
      {
        if (!activity.is_block_awake(begin / Activity::block_size))
          {
            rift_check(is_block_at_rest(state, begin));
            continue;
          }
        const std::size_t end = std::min(begin + Activity::block_size, n_nodes);
        for (std::size_t i = begin; i < end; ++i)
          {
            const double factor = time_step / state.mass[i];
            state.velocity[i].row() += factor * state.force[i].row();
            state.displacement[i].row() += time_step * state.velocity[i].row();
            state.force[i] = NodalVector();
          }
      }
    state.time = ++state.step * time_step;
  }

  void
  start_velocities(State &state, const double time_step)
  {
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      state.velocity[i].row() -=
        .5 * time_step / state.mass[i] * state.force[i].row();
  }

  ExactSum
  kinetic_energy(const Topology &topology,
                 const State    &state,
                 const double    time_step)
  {
    ExactSum sum;
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      if (topology.owns_node(i))
        {
          const Vector3<double> v = state.velocity[i].vector();
          sum.add(.5 * (state.mass[i] * dot(v, v) +
                        time_step * dot(v, state.force[i].vector())));
        }
    return sum;
  }
} // namespace rift
