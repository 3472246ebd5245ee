#include <rift/base/check.h>
#include <rift/contact/known_face_states.h>
#include <rift/contact/vertex_groups.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>
#include <limits>

namespace rift
{
  namespace
  {
    constexpr double never = std::numeric_limits<double>::infinity();

    /** The group of a cell at a corner, for a checkpoint. */
    struct GroupRecord
    {
      GlobalCellIndex cell;
      std::uint32_t   corner, group, padding;
    };

    /** The least height of an undeformed cell, m. */
    double
    least_height(const Topology &topology,
                 const State    &state,
                 const CellIndex cell)
    {
      std::array<Vector3<double>, n_corners> x;
      for (unsigned int c = 0; c < n_corners; ++c)
        x[c] = state.reference[topology.node(cell, c)].vector();
      double largest = 0;
      for (const auto &f : face_corners)
        largest =
          std::max(largest, norm(cross(x[f[1]] - x[f[0]], x[f[2]] - x[f[0]])));
      return dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0]) / largest;
    }
  } // namespace

  template <>
  struct HasPlainBytes<GroupRecord> : std::true_type
  {
    static_assert(sizeof(GroupRecord) == 4 * 4);
  };

  VertexGroups::VertexGroups(const Topology &topology, const double distance)
    : topology(topology)
    , distance(distance)
    , watched_at(topology.n_vertices(), invalid_index)
    , begin_at(topology.n_vertices(), invalid_index)
  {
  }

  void
  VertexGroups::watch(const State &state, const FaceIndex face)
  {
    for (const VertexIndex vertex : vertices_of(topology, face))
      {
        if (!topology.is_complete(vertex))
          continue;
        if (watched_at[vertex] == invalid_index)
          {
            double height = never;
            std::for_each(
              topology.vertex_cells_first(vertex),
              topology.vertex_cells_last(vertex),
              [&](const CellIndex cell) {
                height = std::min(height, least_height(topology, state, cell));
              });
            watched_at[vertex] = static_cast<std::uint32_t>(watched.size());
            watched.push_back({vertex, distance * height, 0, {}});
          }
        Watched &w = watched[watched_at[vertex]];
        w.wake     = 0;
        w.nodes.clear();
      }
  }

  std::vector<VertexIndex>
  VertexGroups::divide(const State &state, const double path)
  {
    std::vector<VertexIndex> divided;
    for (Watched &w : watched)
      if (w.wake <= path && divide_at(state, path, w))
        divided.push_back(w.vertex);
    return divided;
  }

  std::vector<VertexGroups::GroupedNode>
  VertexGroups::nodes_at(const VertexIndex vertex) const
  {
    std::vector<GroupedNode> nodes;
    const CellIndex *const   first = topology.vertex_cells_first(vertex);
    const std::uint32_t      begin = begin_at[vertex];
    for (auto cell = first; cell != topology.vertex_cells_last(vertex); ++cell)
      {
        const NodeIndex node =
          topology.node(*cell, topology.corner_at_vertex(*cell, vertex));
        if (std::none_of(
              nodes.begin(),
              nodes.end(),
              [node](const GroupedNode &n) { return n.node == node; }))
          nodes.push_back(
            {node,
             begin == invalid_index ? 0 : groups[begin + (cell - first)]});
      }
    return nodes;
  }

  double
  VertexGroups::divide_group(const std::vector<Member>::iterator first,
                             const std::vector<Member>::iterator last,
                             const double                        limit,
                             std::uint32_t                      &n_groups)
  {
    // Prim's tree: where its next edge is longer than the limit, what has been
    // reached since the edge before hangs together with nothing else.
    double        slack = never;
    std::uint32_t group = first->group;
    for (auto here = first;; ++here)
      {
        here->group = group;
        if (here + 1 == last)
          return slack;
        for (auto other = here + 1; other != last; ++other)
          other->nearest =
            std::min(other->nearest,
                     norm(other->displacement - here->displacement));
        const auto next =
          std::min_element(here + 1, last, [](const auto &a, const auto &b) {
            return a.nearest < b.nearest;
          });
        if (next->nearest <= limit)
          slack = std::min(slack, limit - next->nearest);
        else
          group = n_groups++;
        std::swap(*next, *(here + 1));
      }
  }

  bool
  VertexGroups::divide_at(const State &state, const double path, Watched &w)
  {
    if (w.nodes.empty())
      w.nodes = nodes_at(w.vertex);
    rift_check(w.nodes.size() == nodes_at(w.vertex).size());
    std::uint32_t n_groups = 0;
    members.clear();
    for (const GroupedNode &n : w.nodes)
      {
        members.push_back({n, state.displacement[n.node].vector(), never});
        n_groups = std::max(n_groups, n.group + 1);
      }

    const std::uint32_t n_before = n_groups;
    double              slack    = never;
    for (auto first = members.begin(); first != members.end();)
      {
        const auto last = std::stable_partition(
          first,
          members.end(),
          [group = first->group](const Member &m) { return m.group == group; });
        slack = std::min(slack, divide_group(first, last, w.limit, n_groups));
        first = last;
      }
    // A little earlier, so that rounding decides nothing.
    w.wake = path + .5 * (1 - 1e-9) * slack;
    if (n_groups == n_before)
      return false;
    w.nodes.clear();

    std::uint32_t *group = groups_at(w.vertex);
    std::for_each(
      topology.vertex_cells_first(w.vertex),
      topology.vertex_cells_last(w.vertex),
      [&](const CellIndex cell) {
        const NodeIndex node =
          topology.node(cell, topology.corner_at_vertex(cell, w.vertex));
        *group++ =
          std::find_if(members.begin(), members.end(), [node](const Member &m) {
            return m.node == node;
          })->group;
      });
    return true;
  }

  std::uint32_t *
  VertexGroups::groups_at(const VertexIndex vertex)
  {
    if (begin_at[vertex] == invalid_index)
      {
        begin_at[vertex] = static_cast<std::uint32_t>(groups.size());
        groups.resize(groups.size() + (topology.vertex_cells_last(vertex) -
                                       topology.vertex_cells_first(vertex)));
      }
    return groups.data() + begin_at[vertex];
  }

  std::uint64_t
  VertexGroups::name(const CellIndex cell, const unsigned int corner) const
  {
    const VertexIndex      vertex = topology.vertex(cell, corner);
    const CellIndex *const cells  = topology.vertex_cells_first(vertex);
    std::size_t            first  = 0;
    if (const std::uint32_t begin = begin_at[vertex]; begin != invalid_index)
      {
        const std::uint32_t *const group = groups.data() + begin;
        std::size_t                own   = 0;
        while (cells[own] != cell)
          ++own;
        while (group[first] != group[own])
          ++first;
      }
    return n_corners *
             std::uint64_t(topology.cell_global_indices[cells[first]]) +
           topology.corner_at_vertex(cells[first], vertex);
  }

  std::vector<VertexIndex>
  VertexGroups::divided_vertices() const
  {
    std::vector<VertexIndex> result;
    for (VertexIndex vertex = 0; vertex < topology.n_vertices(); ++vertex)
      if (begin_at[vertex] != invalid_index)
        result.push_back(vertex);
    return result;
  }

  void
  VertexGroups::save(Archive &archive) const
  {
    std::vector<GroupRecord> records;
    for (const VertexIndex vertex : divided_vertices())
      {
        const CellIndex *const first = topology.vertex_cells_first(vertex);
        if (!topology.owns_cell(*first))
          continue;
        for (auto cell = first; cell != topology.vertex_cells_last(vertex);
             ++cell)
          records.push_back({topology.cell_global_indices[*cell],
                             topology.corner_at_vertex(*cell, vertex),
                             groups[begin_at[vertex] + (cell - first)],
                             0});
      }
    archive.write_list("contact: groups at vertices", records);
  }

  void
  VertexGroups::load(const Archive &archive)
  {
    for (const GroupRecord &record :
         archive.read_list<GroupRecord>("contact: groups at vertices"))
      {
        const CellIndex cell = topology.find_cell(record.cell);
        if (cell == invalid_index)
          continue;
        const VertexIndex vertex = topology.vertex(cell, record.corner);
        if (!topology.is_complete(vertex))
          continue;
        const CellIndex *const first = topology.vertex_cells_first(vertex);
        const auto             position =
          std::find(first, topology.vertex_cells_last(vertex), cell) - first;
        groups_at(vertex)[position] = record.group;
      }
  }
} // namespace rift
