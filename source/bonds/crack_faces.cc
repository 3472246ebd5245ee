#include <rift/bonds/crack_faces.h>
#include <rift/mesh/mesh_data.h>

namespace rift
{
  namespace
  {
    FaceFrame
    frame_of(const std::array<Vector3<double>, 3> &corners)
    {
      FaceFrame frame;
      frame.edges[0]               = corners[1] - corners[0];
      frame.edges[1]               = corners[2] - corners[0];
      const Vector3<double> normal = cross(frame.edges[0], frame.edges[1]);
      frame.normal                 = (1 / norm(normal)) * normal;
      return frame;
    }
  } // namespace

  Vector3<double>
  FaceFrame::components(const Vector3<double> &vector) const
  {
    const double aa = dot(edges[0], edges[0]), bb = dot(edges[1], edges[1]),
                 ab = dot(edges[0], edges[1]);
    const double a = dot(vector, edges[0]), b = dot(vector, edges[1]);
    const double determinant = aa * bb - ab * ab;
    return {{(bb * a - ab * b) / determinant,
             (aa * b - ab * a) / determinant,
             dot(vector, normal)}};
  }

  CrackFaces::CrackFaces(const Topology &topology)
    : topology(topology)
  {
  }

  std::uint32_t
  CrackFaces::add(const FaceIndex face, const double time)
  {
    const auto [place, is_new] =
      place_of_face.insert({face, static_cast<std::uint32_t>(faces.size())});
    if (is_new)
      {
        faces.push_back({face, {}, time, -1, 0});
        update_face(faces.back());
      }
    return place->second;
  }

  std::uint32_t
  CrackFaces::find(const FaceIndex face) const
  {
    const auto place = place_of_face.find(face);
    return place != place_of_face.end() ? place->second : invalid_index;
  }

  void
  CrackFaces::update_nodes(const std::vector<VertexIndex> &vertices)
  {
    for (const VertexIndex vertex : vertices)
      for (const CutCorner &corner : cut_corners_at(topology, vertex))
        if (const auto place = find(corner.face); place != invalid_index)
          update_face(faces[place]);
  }

  void
  CrackFaces::update_face(Face &face)
  {
    const auto &[cells, local_faces] = topology.faces[face.index];
    for (unsigned int c = 0; c < 3; ++c)
      {
        const unsigned int corner = face_corners[local_faces[0]][c];
        face.nodes[0][c]          = topology.node(cells[0], corner);
        face.nodes[1][c]          = topology.node(
          cells[1],
          topology.corner_at_vertex(cells[1],
                                    topology.vertex(cells[0], corner)));
      }
  }

  FaceFrame
  CrackFaces::current_frame(const State &state, const std::uint32_t place) const
  {
    const Face                    &face = faces[place];
    std::array<Vector3<double>, 3> corners;
    for (unsigned int c = 0; c < 3; ++c)
      corners[c] = state.reference[face.nodes[0][c]].vector() +
                   .5 * (state.displacement[face.nodes[0][c]].vector() +
                         state.displacement[face.nodes[1][c]].vector());
    return frame_of(corners);
  }

  FaceFrame
  CrackFaces::undeformed_frame(const State        &state,
                               const std::uint32_t place) const
  {
    std::array<Vector3<double>, 3> corners;
    for (unsigned int c = 0; c < 3; ++c)
      corners[c] = state.reference[faces[place].nodes[0][c]].vector();
    return frame_of(corners);
  }
} // namespace rift
