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

    /** A face that has been released since the last look, for a checkpoint. */
    struct FaceRecord
    {
      GlobalCellIndex cell;
      std::uint32_t   local_face;
    };
  } // namespace

  template <>
  struct HasPlainBytes<FaceRecord> : std::true_type
  {
    static_assert(sizeof(FaceRecord) == 2 * 4);
  };

  ContactSurface::ContactSurface(const Topology &topology,
                                 const double    opening,
                                 const FaceState first_free)
    : topology(topology)
    , first_free(first_free)
    , is_member(topology.n_cell_slots())
    , is_surrounded(topology.n_cell_slots())
    , face_states(topology)
    , groups(topology, opening)
  {
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      is_member[cell] =
        topology.owns_cell(cell) && is_on_surface(topology, cell);
  }

  std::vector<CellIndex>
  ContactSurface::look(const State &state, const double path)
  {
    std::vector<CellIndex> news;
    for (const auto &[face, before, now] : face_states.look())
      {
        groups.watch(state, face);
        if (now >= first_free && before < first_free)
          include_beside(face, news);
      }
    for (const VertexIndex vertex : groups.divide(state, path))
      include_around(vertex, news);
    std::sort(news.begin(), news.end());
    news.erase(std::unique(news.begin(), news.end()), news.end());
    return news;
  }

  void
  ContactSurface::include(const CellIndex cell, std::vector<CellIndex> &news)
  {
    if (!topology.owns_cell(cell))
      return;
    is_member[cell] = 1;
    news.push_back(cell);
  }

  void
  ContactSurface::include_around(const VertexIndex       vertex,
                                 std::vector<CellIndex> &news)
  {
    std::for_each(topology.vertex_cells_first(vertex),
                  topology.vertex_cells_last(vertex),
                  [&](const CellIndex cell) { include(cell, news); });
  }

  void
  ContactSurface::include_beside(const FaceIndex         face,
                                 std::vector<CellIndex> &news)
  {
    for (const CellIndex cell : topology.faces[face].cells)
      include(cell, news);
  }

  std::vector<CellIndex>
  ContactSurface::include_behind(const CellIndex cell)
  {
    std::vector<CellIndex> news;
    if (is_surrounded[cell])
      return news;
    is_surrounded[cell] = 1;
    // Where vertices are divided, all of their cells may touch others already.
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        const VertexIndex vertex = topology.vertex(cell, c);
        std::for_each(topology.vertex_cells_first(vertex),
                      topology.vertex_cells_last(vertex),
                      [&](const CellIndex other) {
                        if (!is_member[other])
                          include(other, news);
                      });
      }
    behind.insert(behind.end(), news.begin(), news.end());
    return news;
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
  ContactSurface::describe(const State    &state,
                           const CellIndex cell,
                           const int       owner) const
  {
    ContactCell result{};
    result.cell      = topology.cell_global_indices[cell];
    result.owner     = owner;
    result.material  = topology.material(cell);
    result.positions = positions_of(topology, state, cell);
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        result.groups[c]     = groups.name(cell, c);
        result.behind[c]     = invalid_index;
        const FaceIndex face = topology.cell_faces[cell][c];
        if (face == invalid_index)
          continue;
        result.behind[c] =
          topology.cell_global_indices[topology.neighbour(face, cell)];
        result.is_held[c] = face_states[face] < first_free;
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

  void
  ContactSurface::save(Archive &archive) const
  {
    groups.save(archive);
    std::vector<FaceRecord> records;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (topology.owns_face(face) && face_states[face] < first_free &&
          topology.face_states[face] >= first_free)
        {
          const FaceName name = topology.face_name(face);
          records.push_back({name.cell, name.local_face});
        }
    archive.write_list("contact: faces released since the last look", records);
    std::vector<GlobalCellIndex> names;
    for (const CellIndex cell : behind)
      names.push_back(topology.cell_global_indices[cell]);
    archive.write_list("contact: cells behind others", names);
  }

  void
  ContactSurface::load(const State &state, const Archive &archive)
  {
    groups.load(archive);
    face_states.look();
    for (const FaceRecord &record : archive.read_list<FaceRecord>(
           "contact: faces released since the last look"))
      if (const FaceIndex face =
            topology.find_face({record.cell, record.local_face});
          face != invalid_index)
        face_states.set(face, FaceState::intact);

    std::vector<CellIndex> news;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      {
        if (face_states[face] != FaceState::intact)
          groups.watch(state, face);
        if (face_states[face] >= first_free)
          include_beside(face, news);
      }
    for (const VertexIndex vertex : groups.divided_vertices())
      include_around(vertex, news);
    for (const GlobalCellIndex name :
         archive.read_list<GlobalCellIndex>("contact: cells behind others"))
      if (const CellIndex cell = topology.find_cell(name);
          cell != invalid_index && topology.owns_cell(cell) && !is_member[cell])
        {
          include(cell, news);
          behind.push_back(cell);
        }
  }

  Tetrahedron
  positions_of(const Topology &topology,
               const State    &state,
               const CellIndex cell)
  {
    Tetrahedron positions;
    for (unsigned int c = 0; c < n_corners; ++c)
      positions[c] = state.position(topology.node(cell, c));
    return positions;
  }

  CellMotion
  motion_of(const Topology &topology, const State &state, const CellIndex cell)
  {
    CellMotion motion{positions_of(topology, state, cell), {}};
    for (unsigned int c = 0; c < n_corners; ++c)
      motion.velocities[c] = state.velocity[topology.node(cell, c)].vector();
    return motion;
  }
} // namespace rift
