#include <rift/contact/known_face_states.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>
#include <cstring>

namespace rift
{
  KnownFaceStates::KnownFaceStates(const Topology &topology)
    : topology(topology)
    , states(topology.faces.size(), FaceState::intact)
  {
  }

  std::vector<KnownFaceStates::Change>
  KnownFaceStates::look()
  {
    // Few change: by blocks.
    constexpr std::size_t block_size = 512;
    std::vector<Change>   changes;
    for (std::size_t begin = 0; begin < states.size(); begin += block_size)
      {
        const std::size_t end = std::min(begin + block_size, states.size());
        if (std::memcmp(&states[begin],
                        &topology.face_states[begin],
                        (end - begin) * sizeof(FaceState)) == 0)
          continue;
        for (std::size_t face = begin; face < end; ++face)
          if (const FaceState now = topology.face_states[face];
              states[face] != now)
            {
              changes.push_back(
                {static_cast<FaceIndex>(face), states[face], now});
              states[face] = now;
            }
      }
    return changes;
  }

  std::array<VertexIndex, 3>
  vertices_of(const Topology &topology, const FaceIndex face)
  {
    const Face                &f       = topology.faces[face];
    const auto                &corners = face_corners[f.local_faces[0]];
    std::array<VertexIndex, 3> vertices;
    for (unsigned int c = 0; c < 3; ++c)
      vertices[c] = topology.vertex(f.cells[0], corners[c]);
    return vertices;
  }
} // namespace rift
