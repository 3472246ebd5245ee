#include <rift/base/check.h>
#include <rift/base/checked_cast.h>
#include <rift/mesh/topology.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace rift
{
  namespace
  {
    /** Whether cells stand in their order and have vertices that exist. */
    bool
    are_in_order(const std::vector<LocalCell> &cells,
                 const std::size_t             n_vertices)
    {
      for (std::size_t i = 0; i < cells.size(); ++i)
        for (const VertexIndex vertex : cells[i].vertices)
          if (vertex >= n_vertices ||
              (i > 0 && cells[i].global_index <= cells[i - 1].global_index))
            return false;
      return true;
    }

    /** Whether each batch is in one range, and no material has two. */
    bool
    cover_all_batches(const std::vector<MaterialRange> &ranges,
                      const std::size_t                 n_batches)
    {
      std::size_t             end = 0;
      std::set<std::uint16_t> materials;
      for (const MaterialRange &range : ranges)
        {
          if (range.begin != end || range.end <= range.begin ||
              !materials.insert(range.material).second)
            return false;
          end = range.end;
        }
      return end == n_batches;
    }

    /** Whether padding, and nothing else, has no owner; it is at node 0. */
    bool
    is_padding_empty(const Topology &topology)
    {
      std::size_t n_cells = 0;
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        {
          const bool is_padding = topology.is_padding(cell);
          n_cells += is_padding ? 0 : 1;
          if (is_padding != (topology.cell_owners[cell] < 0))
            return false;
          for (unsigned int c = 0; c < n_corners && is_padding; ++c)
            if (topology.node(cell, c) != 0)
              return false;
        }
      return n_cells == topology.n_cells() &&
             topology.n_cell_slots() == topology.n_batches() * batch_size;
    }

    /** Whether the cells around each vertex have it, in ascending order. */
    bool
    are_vertex_cells_right(const Topology &topology)
    {
      for (VertexIndex vertex = 0; vertex < topology.n_vertices(); ++vertex)
        {
          const CellIndex *const first = topology.vertex_cells_first(vertex),
                                 *const last =
                                   topology.vertex_cells_last(vertex);
          for (auto cell = first; cell != last; ++cell)
            if (topology.corner_at_vertex(*cell, vertex) == n_corners ||
                (cell != first && *cell <= *(cell - 1)))
              return false;
        }
      return true;
    }

    /** Whether both cells of a face list it and have its three vertices. */
    bool
    is_between_its_cells(const Topology &topology, const FaceIndex index)
    {
      const Face      &face = topology.faces[index];
      const CellIndex *cell = face.cells;
      for (const unsigned int side : {0, 1})
        if (topology.cell_faces[cell[side]][face.local_faces[side]] != index)
          return false;
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          const unsigned int other =
            topology.corner_at_vertex(cell[1], topology.vertex(cell[0], c));
          if (c != face.local_faces[0] &&
              (other == n_corners || other == face.local_faces[1]))
            return false;
        }
      return topology.cell_global_indices[cell[0]] <
             topology.cell_global_indices[cell[1]];
    }

    /** Whether the faces stand in their order between their cells. */
    bool
    are_faces_right(const Topology &topology)
    {
      for (FaceIndex i = 0; i < topology.faces.size(); ++i)
        {
          const auto name_of = [&](const FaceIndex face) {
            const Face &f = topology.faces[face];
            return std::make_pair(f.cells[0], f.local_faces[0]);
          };
          if (!is_between_its_cells(topology, i) ||
              (i > 0 && !(name_of(i - 1) < name_of(i))))
            return false;
        }
      return true;
    }
  } // namespace

  Topology::Topology(const std::vector<LocalCell> &cells,
                     const std::size_t             n_vertices,
                     const int                     own_rank)
    : own_rank(own_rank)
    , n_real_cells(cells.size())
    , n_owned(std::count_if(
        cells.begin(),
        cells.end(),
        [own_rank](const LocalCell &c) { return c.owner == own_rank; }))
  {
    rift_check(are_in_order(cells, n_vertices));
    node_vertices.resize(n_vertices);
    for (std::size_t i = 0; i < n_vertices; ++i)
      node_vertices[i] = static_cast<VertexIndex>(i);

    make_batches(cells);
    make_vertex_cells(n_vertices);
    make_faces();
    rift_check(cover_all_batches(material_ranges, n_batches()));
    rift_check(is_padding_empty(*this));
    rift_check(are_vertex_cells_right(*this));
    rift_check(are_faces_right(*this));
  }

  void
  Topology::make_batches(const std::vector<LocalCell> &cells)
  {
    const auto fill_batch = [&] {
      cell_global_indices.resize(batches.size() * batch_size, invalid_index);
      cell_owners.resize(batches.size() * batch_size, -1);
    };
    const auto new_range = [&](const std::uint16_t material) {
      const auto begin = static_cast<std::uint32_t>(batches.size());
      material_ranges.push_back({material, begin, begin});
    };

    for (const LocalCell &cell : cells)
      {
        const bool new_material =
          material_ranges.empty() ||
          material_ranges.back().material != cell.material;
        if (new_material)
          {
            fill_batch();
            new_range(cell.material);
          }
        const std::size_t lane = cell_global_indices.size() % batch_size;
        if (lane == 0)
          {
            batches.push_back({});
            batch_materials.push_back(cell.material);
            ++material_ranges.back().end;
          }
        for (unsigned int c = 0; c < n_corners; ++c)
          batches.back().corner[c][lane] = cell.vertices[c];
        cell_global_indices.push_back(cell.global_index);
        cell_owners.push_back(cell.owner);
      }
    fill_batch();
    // Each corner of a cell may come to have a node of its own.
    checked_cast<NodeIndex>(n_corners * batches.size() * batch_size,
                            "corners of cells on a rank");
  }

  void
  Topology::make_vertex_cells(const std::size_t n_vertices)
  {
    vertex_cells_begin.assign(n_vertices + 1, 0);
    for (CellIndex cell = 0; cell < n_cell_slots(); ++cell)
      if (!is_padding(cell))
        for (unsigned int c = 0; c < n_corners; ++c)
          ++vertex_cells_begin[vertex(cell, c) + 1];
    for (std::size_t v = 0; v < n_vertices; ++v)
      vertex_cells_begin[v + 1] += vertex_cells_begin[v];

    vertex_cells.resize(vertex_cells_begin.back());
    vertex_corners.resize(vertex_cells_begin.back());
    std::vector<std::uint32_t> next(vertex_cells_begin.begin(),
                                    vertex_cells_begin.end() - 1);
    for (CellIndex cell = 0; cell < n_cell_slots(); ++cell)
      if (!is_padding(cell))
        for (unsigned int c = 0; c < n_corners; ++c)
          {
            const std::uint32_t place = next[vertex(cell, c)]++;
            vertex_cells[place]       = cell;
            vertex_corners[place]     = static_cast<std::uint8_t>(c);
          }

    vertex_is_complete.assign(n_vertices, 0);
    for (CellIndex cell = 0; cell < n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < n_corners && owns_cell(cell); ++c)
        vertex_is_complete[vertex(cell, c)] = 1;
  }

  void
  Topology::make_faces()
  {
    const std::array<FaceIndex, n_corners> none = {
      {invalid_index, invalid_index, invalid_index, invalid_index}};
    cell_faces.assign(n_cell_slots(), none);

    // The neighbour at a face is the one other cell around the first of its
    // vertices that has the two others as well.
    for (CellIndex cell = 0; cell < n_cell_slots(); ++cell)
      for (unsigned int f = 0; f < n_corners && !is_padding(cell); ++f)
        {
          const VertexIndex a = vertex(cell, (f + 1) % n_corners);
          const VertexIndex b = vertex(cell, (f + 2) % n_corners);
          const VertexIndex c = vertex(cell, (f + 3) % n_corners);
          for (auto other = vertex_cells_first(a);
               other != vertex_cells_last(a);
               ++other)
            {
              if (*other <= cell)
                continue;
              const unsigned int i = corner_at_vertex(*other, a);
              const unsigned int j = corner_at_vertex(*other, b);
              const unsigned int k = corner_at_vertex(*other, c);
              if (j == n_corners || k == n_corners)
                continue;
              const auto opposite =
                static_cast<std::uint8_t>(0 + 1 + 2 + 3 - i - j - k);
              const auto face = static_cast<FaceIndex>(faces.size());
              faces.push_back(
                {{cell, *other}, {static_cast<std::uint8_t>(f), opposite}});
              cell_faces[cell][f]          = face;
              cell_faces[*other][opposite] = face;
              break;
            }
        }
    face_states.assign(faces.size(), FaceState::intact);
  }

  std::size_t
  Topology::n_owned_nodes() const
  {
    std::size_t n = 0;
    for (NodeIndex node = 0; node < n_nodes(); ++node)
      n += owns_node(node) ? 1 : 0;
    return n;
  }

  unsigned int
  Topology::corner_at_vertex(const CellIndex cell, const VertexIndex v) const
  {
    unsigned int c = 0;
    while (c < n_corners && vertex(cell, c) != v)
      ++c;
    return c;
  }

  FaceIndex
  Topology::find_face(const FaceName &name) const
  {
    const CellIndex cell = find_cell(name.cell);
    return cell == invalid_index ? invalid_index :
                                   cell_faces[cell][name.local_face];
  }

  bool
  Topology::needs_face(const FaceIndex face) const
  {
    const Face &f = faces[face];
    for (unsigned int c = 0; c < n_corners; ++c)
      if (c != f.local_faces[0] && is_complete(vertex(f.cells[0], c)))
        return true;
    return false;
  }

  CellIndex
  Topology::find_cell(const GlobalCellIndex global_index) const
  {
    // Ascending within each material; the padding stands at the end of each.
    for (const MaterialRange &range : material_ranges)
      {
        const auto first =
          cell_global_indices.begin() + range.begin * batch_size;
        const auto last = cell_global_indices.begin() + range.end * batch_size;
        const auto it   = std::lower_bound(first, last, global_index);
        if (it != last && *it == global_index)
          return static_cast<CellIndex>(it - cell_global_indices.begin());
      }
    return invalid_index;
  }
} // namespace rift
