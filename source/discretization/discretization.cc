#include <rift/base/check.h>
#include <rift/discretization/discretization.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    /** A node, named by the first of its cells. */
    struct NodeRecord
    {
      GlobalCellIndex cell;
      std::uint32_t   corner;

      /** m and m/s. */
      std::array<double, dim> displacement, velocity;
    };

    /** A face that has been cut. */
    struct CutFaceRecord
    {
      FaceName      face;
      std::uint32_t state;
    };
  } // namespace

  template <>
  struct HasPlainBytes<NodeRecord> : std::true_type
  {
    static_assert(sizeof(NodeRecord) == 2 * 4 + 2 * dim * 8);
  };

  namespace
  {
    /** The owned nodes, each by the first cell and corner that has it. */
    std::vector<NodeRecord>
    node_records(const Topology &topology, const State &state)
    {
      std::vector<NodeRecord>   records;
      std::vector<std::uint8_t> is_known(topology.n_nodes(), 0);
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < n_corners && !topology.is_padding(cell);
             ++c)
          {
            const NodeIndex node = topology.node(cell, c);
            if (is_known[node] || !topology.owns_node(node))
              continue;
            is_known[node] = 1;
            NodeRecord record{topology.cell_global_indices[cell], c, {}, {}};
            for (unsigned int d = 0; d < dim; ++d)
              {
                record.displacement[d] = state.displacement[node][d];
                record.velocity[d]     = state.velocity[node][d];
              }
            records.push_back(record);
          }
      rift_check(records.size() == topology.n_owned_nodes());
      return records;
    }

    void
    move_nodes(const std::vector<NodeRecord> &records,
               const Topology                &topology,
               State                         &state,
               Activity                      &activity)
    {
      for (const NodeRecord &record : records)
        {
          const CellIndex cell = topology.find_cell(record.cell);
          if (cell == invalid_index)
            continue;
          // Where a vertex is incomplete, the first cell of the node may not
          // be here; the exchange brings those.
          const NodeIndex node = topology.node(cell, record.corner);
          if (!topology.is_complete(topology.node_vertices[node]))
            continue;
          bool moves = false;
          for (unsigned int d = 0; d < dim; ++d)
            {
              state.displacement[node][d] = record.displacement[d];
              state.velocity[node][d]     = record.velocity[d];
              moves |= record.displacement[d] != 0 || record.velocity[d] != 0;
            }
          if (moves)
            activity.wake_node(topology, node);
        }
    }

    /** Whether these nodes have a mass each, which sum to that of the node
     * that they have come from. */
    bool
    keep_mass(const State                  &state,
              const std::vector<NodeIndex> &parts,
              const double                  mass)
    {
      double sum = 0;
      for (const NodeIndex part : parts)
        {
          if (!(state.mass[part] > 0))
            return false;
          sum += state.mass[part];
        }
      return std::abs(sum - mass) <= 1e-12 * mass;
    }

    /** Whether all nodes of batches that are awake are so. */
    bool
    are_nodes_awake(const Topology &topology, const Activity &activity)
    {
      for (std::size_t batch = 0; batch < topology.n_batches(); ++batch)
        for (const auto &corner : topology.batches[batch].corner)
          for (const NodeIndex node : corner)
            if (activity.is_awake(batch) &&
                !activity.is_block_awake(node / Activity::block_size))
              return false;
      return true;
    }

    /** Whether there is one record, with finite numbers, for each node at a
     * complete vertex. */
    bool
    are_of_all_nodes(const std::vector<NodeRecord> &records,
                     const Topology                &topology)
    {
      std::vector<unsigned int> n_records(topology.n_nodes(), 0);
      for (const NodeRecord &record : records)
        {
          if (const CellIndex cell = topology.find_cell(record.cell);
              cell != invalid_index)
            ++n_records[topology.node(cell, record.corner)];
          for (unsigned int d = 0; d < dim; ++d)
            if (!std::isfinite(record.displacement[d]) ||
                !std::isfinite(record.velocity[d]))
              return false;
        }
      for (NodeIndex node = 0; node < topology.n_nodes(); ++node)
        if (topology.is_complete(topology.node_vertices[node]) &&
            n_records[node] != 1)
          return false;
      return true;
    }
  } // namespace

  std::int64_t
  count_bodies(const Discretization &body)
  {
    std::int64_t number = 0;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      if (body.topology.owns_cell(cell) &&
          body.topology.cell_global_indices[cell] == body.bodies[cell])
        ++number;
    return body.communicator.sum(number);
  }

  std::vector<VertexIndex>
  vertices_of(const Topology &topology, const std::vector<NodeSplit> &splits)
  {
    std::vector<VertexIndex> vertices;
    for (const NodeSplit &split : splits)
      vertices.push_back(topology.node_vertices[split.parts[0]]);
    return vertices;
  }

  TopologyChange
  Discretization::cut(const std::vector<FaceIndex> &faces)
  {
    if (faces.empty())
      return {};
    TopologyChange change = split_nodes(topology, faces);
    state.grow(change);
    rift_check(state.n_nodes() == topology.n_nodes());
    for (const NodeSplit &split : change.splits)
      {
        const double old_mass = state.mass[split.parts[0]];
        for (const NodeIndex part : split.parts)
          state.mass[part] = lumped_mass(topology, reference, densities, part);
        rift_check(keep_mass(state, split.parts, old_mass));
      }
    activity.grow(topology.n_nodes());
    rift_check(are_nodes_awake(topology, activity));
    return change;
  }

  std::vector<VertexIndex>
  Discretization::follow_owners(const std::vector<NodeSplit> &splits,
                                std::vector<OpeningCorner>   &openings,
                                std::vector<CornerNews>      &news)
  {
    exchange.send(topology, state, splits, openings, news);
    auto change = exchange.receive(topology, state, activity);
    openings.insert(openings.end(),
                    change.openings.begin(),
                    change.openings.end());
    news = std::move(change.news);
    return std::move(change.vertices);
  }

  void
  Discretization::save(Archive &archive) const
  {
    archive.write_list("nodes", node_records(topology, state));
    std::vector<CutFaceRecord> faces;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (topology.owns_face(face) &&
          topology.face_states[face] != FaceState::intact)
        faces.push_back(
          {topology.face_name(face),
           static_cast<std::uint32_t>(topology.face_states[face])});
    archive.write_list("cut faces", faces);
  }

  std::vector<VertexIndex>
  Discretization::load(const Archive &archive)
  {
    const auto records = archive.read_list<CutFaceRecord>("cut faces");
    // In the intrinsic model they have been cut already.
    std::vector<FaceIndex> faces;
    for (const CutFaceRecord &record : records)
      if (const FaceIndex face = topology.find_face(record.face);
          face != invalid_index &&
          topology.face_states[face] == FaceState::intact)
        faces.push_back(face);
    std::sort(faces.begin(), faces.end());

    const TopologyChange change = cut(faces);
    for (const CutFaceRecord &record : records)
      if (const FaceIndex face = topology.find_face(record.face);
          face != invalid_index)
        {
          const auto next = static_cast<FaceState>(record.state);
          rift_check(next > FaceState::intact && next <= FaceState::released);
          topology.face_states[face] = next;
        }
    const auto nodes = archive.read_list<NodeRecord>("nodes");
    rift_check(are_of_all_nodes(nodes, topology));
    move_nodes(nodes, topology, state, activity);
    std::vector<OpeningCorner> no_openings;
    std::vector<CornerNews>    no_news;
    auto       vertices = follow_owners(change.splits, no_openings, no_news);
    const auto split    = vertices_of(topology, change.splits);
    vertices.insert(vertices.end(), split.begin(), split.end());
    return vertices;
  }
} // namespace rift
