#include <rift/base/check.h>
#include <rift/discretization/activity.h>

#include <algorithm>

namespace rift
{
  Activity::Activity(const Topology &topology)
    : batches(topology.n_batches(), asleep)
    , blocks((topology.n_nodes() + block_size - 1) / block_size, 0)
  {
  }

  void
  Activity::grow(const std::size_t n_nodes)
  {
    // A block may hold old nodes at rest as well: a block too many is harmless.
    rift_check((n_nodes + block_size - 1) / block_size >= blocks.size());
    const std::size_t first_new = blocks.size();
    blocks.resize((n_nodes + block_size - 1) / block_size, 1);
    if (first_new > 0)
      blocks[first_new - 1] = 1;
  }

  void
  Activity::wake_all(const Topology &topology)
  {
    for (std::size_t batch = 0; batch < batches.size(); ++batch)
      {
        wake_batch(topology, batch);
        batches[batch] = awake_and_spread;
      }
  }

  void
  Activity::wake_node(const Topology &topology, const NodeIndex node)
  {
    const VertexIndex vertex = topology.node_vertices[node];
    for (auto cell = topology.vertex_cells_first(vertex);
         cell != topology.vertex_cells_last(vertex);
         ++cell)
      wake_batch(topology, *cell / batch_size);
  }

  void
  Activity::wake_neighbours(const Topology &topology, const std::size_t batch)
  {
    batches[batch] = awake_and_spread;
    for (const auto &corner : topology.batches[batch].corner)
      for (const NodeIndex node : corner)
        wake_node(topology, node);
  }

  void
  Activity::wake_batch(const Topology &topology, const std::size_t batch)
  {
    if (batches[batch] != asleep)
      return;
    batches[batch] = awake;
    for (const auto &corner : topology.batches[batch].corner)
      for (const NodeIndex node : corner)
        blocks[node / block_size] = 1;
  }

  std::size_t
  Activity::n_awake() const
  {
    return batches.size() - std::count(batches.begin(), batches.end(), asleep);
  }
} // namespace rift
