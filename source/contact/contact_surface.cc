#include <rift/base/check.h>
#include <rift/contact/contact_surface.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    bool
    is_on_surface(const Topology &topology, const CellIndex cell)
    {
      const auto &faces = topology.cell_faces[cell];
      return std::find(faces.begin(), faces.end(), invalid_index) !=
             faces.end();
    }

    /** The same on all ranks that know all cells around the vertex. */
    std::uint64_t
    name_of_node(const Topology    &topology,
                 const CellIndex    cell,
                 const unsigned int corner)
    {
      const NodeIndex   node   = topology.node(cell, corner);
      const VertexIndex vertex = topology.node_vertices[node];
      auto              other  = topology.vertex_cells_first(vertex);
      while (topology.node(*other, topology.corner_at_vertex(*other, vertex)) !=
             node)
        {
          ++other;
          rift_check(other != topology.vertex_cells_last(vertex));
        }
      return n_corners * std::uint64_t(topology.cell_global_indices[*other]) +
             topology.corner_at_vertex(*other, vertex);
    }
  } // namespace

  ContactSurface::ContactSurface(const Topology &topology)
    : topology(topology)
    , is_member(topology.n_cell_slots())
  {
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (is_on_surface(topology, cell))
        include_cell(cell);
  }

  void
  ContactSurface::include(const FaceIndex face)
  {
    const Face &f = topology.faces[face];
    for (const unsigned int corner : face_corners[f.local_faces[0]])
      {
        const VertexIndex vertex = topology.vertex(f.cells[0], corner);
        std::for_each(topology.vertex_cells_first(vertex),
                      topology.vertex_cells_last(vertex),
                      [this](const CellIndex cell) { include_cell(cell); });
      }
  }

  void
  ContactSurface::include_cell(const CellIndex cell)
  {
    is_member[cell] = topology.owns_cell(cell);
  }

  std::vector<CellIndex>
  ContactSurface::cells() const
  {
    std::vector<CellIndex> cells;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (is_member[cell])
        cells.push_back(cell);
    return cells;
  }

  ContactCell
  ContactSurface::describe(const CellIndex cell,
                           const int       owner,
                           const IsHeld   &is_held) const
  {
    ContactCell result{};
    result.cell     = topology.cell_global_indices[cell];
    result.owner    = owner;
    result.material = topology.material(cell);
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        result.nodes[c]      = name_of_node(topology, cell, c);
        const FaceIndex face = topology.cell_faces[cell][c];
        result.bonded[c] =
          face != invalid_index && is_held(face) ?
            topology.cell_global_indices[topology.neighbour(face, cell)] :
            invalid_index;
      }
    return result;
  }

  std::vector<int>
  ContactSurface::subscribers(const CellIndex cell) const
  {
    std::vector<int> ranks;
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        const VertexIndex vertex = topology.vertex(cell, c);
        for (auto other = topology.vertex_cells_first(vertex);
             other != topology.vertex_cells_last(vertex);
             ++other)
          ranks.push_back(topology.cell_owners[*other]);
      }
    std::sort(ranks.begin(), ranks.end());
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    return ranks;
  }

  CellMotion
  motion_of(const Topology &topology, const State &state, const CellIndex cell)
  {
    CellMotion motion;
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        const NodeIndex node = topology.node(cell, c);
        motion.positions[c]  = state.position(node);
        motion.velocities[c] = state.velocity[node].vector();
      }
    return motion;
  }
} // namespace rift
