#include <rift/bonds/crack_planes.h>

#include <algorithm>
#include <map>

namespace rift
{
  namespace
  {
    struct FaceRecord
    {
      CrackPlanes::FaceSides face;
      Vector3<double>        normal;
    };

    /** Where the vertex lies, m, and the place in its list. */

    struct VertexRecord
    {
      Vector3<double> position;
      std::uint64_t   place;
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
    static_assert(sizeof(VertexRecord) == 8 * sizeof(double));
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
  CrackPlanes::save(const Topology &topology,
                    const State    &state,
                    Archive        &archive) const
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
        for (std::size_t i = 0; i < parts.size(); ++i)
          vertices.push_back({state.reference[vertex].vector(),
                              i,
                              parts[i].normal,
                              parts[i].area});
    archive.write_list("crack planes at vertices", vertices);
  }

  void
  CrackPlanes::load(const Topology &topology,
                    const State    &state,
                    const Archive  &archive)
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
    std::map<Vector3<double>, VertexIndex> at;
    for (VertexIndex v = 0; v < topology.n_vertices() && !vertices.empty(); ++v)
      at[state.reference[v].vector()] = v;
    for (const VertexRecord &record : vertices)
      if (const auto vertex = at.find(record.position); vertex != at.end())
        at_vertices[vertex->second].push_back({record.normal, record.area});
  }
} // namespace rift
