#include <rift/bonds/crack_planes.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    struct FaceRecord
    {
      CrackPlanes::FaceSides face;
      Vector3<double>        normal;
    };

    /** Of a cell at a vertex, since a rank may have some of them alone. */
    struct VertexRecord
    {
      /** The cell, its corner there, and the place in the list of the vertex. */
      GlobalCellIndex cell;
      std::uint32_t   corner, place;

      /** See CrackPlanes::Part. */
      Vector3<double> normal;
      double          area;
    };
  } // namespace

  template <>
  struct HasPlainBytes<FaceRecord> : std::true_type
  {
    static_assert(sizeof(FaceRecord) == 16 + 3 * sizeof(double));
  };

  template <>
  struct HasPlainBytes<VertexRecord> : std::true_type
  {
    static_assert(sizeof(VertexRecord) == 16 + 4 * sizeof(double));
  };

  CrackPlanes::FaceSides
  CrackPlanes::sides_of(const Topology &topology, const FaceIndex face)
  {
    const Face &f = topology.faces[face];
    return {{{topology.cell_global_indices[f.cells[0]], f.local_faces[0]},
             {topology.cell_global_indices[f.cells[1]], f.local_faces[1]}}};
  }

  FaceIndex
  CrackPlanes::find(const Topology &topology, const FaceSides &sides)
  {
    for (const FaceName &side : sides)
      if (const CellIndex cell = topology.find_cell(side.cell);
          cell != invalid_index)
        {
          const FaceIndex face = topology.cell_faces[cell][side.local_face];
          if (face == invalid_index)
            beside_remote_cuts.insert(cell);
          return face;
        }
    return invalid_index;
  }

  void
  CrackPlanes::save(const Topology &topology, Archive &archive) const
  {
    std::vector<FaceRecord> faces;
    for (const auto &[face, normal] : of_faces)
      if (topology.owns_face(face))
        faces.push_back({sides_of(topology, face), normal});
    archive.write_list("crack planes of faces", faces);
    std::vector<VertexRecord> vertices;
    for (const auto &[vertex, parts] : at_vertices)
      // The first node at a vertex has its number.
      if (topology.owns_node(vertex))
        for (auto cell = topology.vertex_cells_first(vertex);
             cell != topology.vertex_cells_last(vertex);
             ++cell)
          for (std::uint32_t i = 0; i < parts.size(); ++i)
            vertices.push_back({topology.cell_global_indices[*cell],
                                topology.corner_at_vertex(*cell, vertex),
                                i,
                                parts[i].normal,
                                parts[i].area});
    archive.write_list("crack planes at vertices", vertices);
  }

  void
  CrackPlanes::load(const Topology &topology, const Archive &archive)
  {
    for (const auto &record :
         archive.read_list<FaceRecord>("crack planes of faces"))
      if (const FaceIndex face = find(topology, record.face);
          face != invalid_index)
        of_faces[face] = record.normal;
    auto vertices = archive.read_list<VertexRecord>("crack planes at vertices");
    std::sort(vertices.begin(),
              vertices.end(),
              [](const VertexRecord &a, const VertexRecord &b) {
                return a.place < b.place;
              });
    for (const VertexRecord &record : vertices)
      if (const CellIndex cell = topology.find_cell(record.cell);
          cell != invalid_index)
        if (auto &parts = at_vertices[topology.vertex(cell, record.corner)];
            parts.size() == record.place)
          parts.push_back({record.normal, record.area});
  }
} // namespace rift
