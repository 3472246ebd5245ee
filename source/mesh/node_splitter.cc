#include <rift/base/check.h>
#include <rift/base/disjoint_sets.h>
#include <rift/mesh/mesh_data.h>
#include <rift/mesh/node_splitter.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /**
     * The components of `cells`, which all use the node at `vertex`, by their
     * positions in this list.
     */
    DisjointSets
    find_components(const Topology               &topology,
                    const std::vector<CellIndex> &cells,
                    const VertexIndex             vertex)
    {
      DisjointSets sets(cells.size());
      for (std::uint32_t i = 0; i < cells.size(); ++i)
        {
          const unsigned int corner =
            topology.corner_at_vertex(cells[i], vertex);
          for (unsigned int f = 0; f < n_corners; ++f)
            {
              const FaceIndex face = topology.cell_faces[cells[i]][f];
              if (f == corner || face == invalid_index ||
                  topology.face_states[face] != FaceState::intact)
                continue;
              const CellIndex other = topology.neighbour(face, cells[i]);
              const auto      position =
                std::lower_bound(cells.begin(), cells.end(), other);
              rift_check(position != cells.end() && *position == other);
              sets.unite(i, position - cells.begin());
            }
        }
      return sets;
    }

    /** Whether cells that an intact face joins share its node at a vertex. */
    bool
    share_nodes_at_intact_faces(const Topology   &topology,
                                const VertexIndex vertex)
    {
      for (auto cell = topology.vertex_cells_first(vertex);
           cell != topology.vertex_cells_last(vertex);
           ++cell)
        {
          const unsigned int corner = topology.corner_at_vertex(*cell, vertex);
          for (unsigned int f = 0; f < n_corners; ++f)
            {
              const FaceIndex face = topology.cell_faces[*cell][f];
              if (f == corner || face == invalid_index ||
                  topology.face_states[face] != FaceState::intact)
                continue;
              const CellIndex other = topology.neighbour(face, *cell);
              if (topology.node(*cell, corner) !=
                  topology.node(other,
                                topology.corner_at_vertex(other, vertex)))
                return false;
            }
        }
      return true;
    }

    /** Whether all of these nodes are at a vertex, each of them once. */
    bool
    are_at_vertex(const Topology               &topology,
                  const std::vector<NodeIndex> &nodes,
                  const VertexIndex             vertex)
    {
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (topology.node_vertices[nodes[i]] != vertex ||
            std::count(nodes.begin(), nodes.end(), nodes[i]) != 1)
          return false;
      return true;
    }

    /** Whether faces are intact, ascend and occur once. */
    bool
    can_be_cut(const Topology &topology, const std::vector<FaceIndex> &faces)
    {
      for (std::size_t i = 0; i < faces.size(); ++i)
        if (topology.face_states[faces[i]] != FaceState::intact ||
            (i > 0 && faces[i] <= faces[i - 1]))
          return false;
      return true;
    }

    /** Gives each component of cells around a node a node of its own. */
    NodeSplit
    split_node(Topology &topology, const NodeIndex node)
    {
      const VertexIndex      vertex = topology.node_vertices[node];
      std::vector<CellIndex> cells;
      for (auto cell = topology.vertex_cells_first(vertex);
           cell != topology.vertex_cells_last(vertex);
           ++cell)
        if (topology.node(*cell, topology.corner_at_vertex(*cell, vertex)) ==
            node)
          cells.push_back(*cell);

      DisjointSets components = find_components(topology, cells, vertex);

      NodeSplit              split;
      std::vector<NodeIndex> component_node(cells.size());
      for (std::uint32_t i = 0; i < cells.size(); ++i)
        {
          const std::uint32_t first = components.find(i);
          if (first == i)
            {
              component_node[i] = node;
              if (i > 0)
                {
                  component_node[i] =
                    static_cast<NodeIndex>(topology.n_nodes());
                  topology.node_vertices.push_back(vertex);
                }
              split.parts.push_back(component_node[i]);
            }
          const unsigned int corner =
            topology.corner_at_vertex(cells[i], vertex);
          topology.batches[cells[i] / batch_size]
            .corner[corner][cells[i] % batch_size] = component_node[first];
        }
      rift_check(!split.parts.empty() && split.parts[0] == node);
      rift_check(are_at_vertex(topology, split.parts, vertex));
      rift_check(share_nodes_at_intact_faces(topology, vertex));
      return split;
    }
  } // namespace

  TopologyChange
  split_nodes(Topology &topology, const std::vector<FaceIndex> &cut_faces)
  {
    rift_check(can_be_cut(topology, cut_faces));
    std::vector<NodeIndex> affected;
    for (const FaceIndex face : cut_faces)
      {
        topology.face_states[face] = FaceState::cut;
        const Face &f              = topology.faces[face];
        for (const unsigned int corner : face_corners[f.local_faces[0]])
          {
            const NodeIndex node = topology.node(f.cells[0], corner);
            if (topology.is_complete(topology.node_vertices[node]))
              affected.push_back(node);
          }
      }
    std::sort(affected.begin(), affected.end());
    affected.erase(std::unique(affected.begin(), affected.end()),
                   affected.end());

    TopologyChange change;
    change.cut_faces = cut_faces;
    for (const NodeIndex node : affected)
      {
        NodeSplit split = split_node(topology, node);
        if (split.parts.size() > 1)
          change.splits.push_back(std::move(split));
      }
    return change;
  }

  std::size_t
  separate_touching_pieces(Topology &topology)
  {
    const auto n_before = static_cast<NodeIndex>(topology.n_nodes());
    for (NodeIndex node = 0; node < n_before; ++node)
      if (topology.is_complete(topology.node_vertices[node]))
        split_node(topology, node);
    return topology.n_nodes() - n_before;
  }

  void
  separate_materials(Topology &topology, const std::vector<bool> &parted)
  {
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      {
        const auto &cells = topology.faces[face].cells;
        if (parted[topology.material(cells[0])] &&
            parted[topology.material(cells[1])])
          topology.face_states[face] = FaceState::cut;
      }
    separate_touching_pieces(topology);

    // Numbers in the order of the cells, so that those of a cell lie together.
    std::vector<NodeIndex>   numbers(topology.n_nodes(), invalid_index);
    std::vector<VertexIndex> vertices;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < n_corners && !topology.is_padding(cell); ++c)
        if (NodeIndex &number = numbers[topology.node(cell, c)];
            number == invalid_index)
          {
            number = static_cast<NodeIndex>(vertices.size());
            vertices.push_back(topology.vertex(cell, c));
          }
    for (BatchNodes &batch : topology.batches)
      for (auto &corner : batch.corner)
        for (NodeIndex &node : corner)
          {
            rift_check(numbers[node] != invalid_index);
            node = numbers[node];
          }
    topology.node_vertices = std::move(vertices);
  }
} // namespace rift
