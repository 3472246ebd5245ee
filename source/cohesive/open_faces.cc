#include <rift/cohesive/open_faces.h>

namespace rift
{
  FaceCounts
  count_faces(const Topology     &topology,
              const std::size_t   n_too_short,
              const Communicator &communicator)
  {
    std::int64_t inserted = 0, opened = 0, failed = 0;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (topology.owns_face(face))
        {
          const FaceState state = topology.face_states[face];
          inserted += state >= FaceState::cut ? 1 : 0;
          opened += state >= FaceState::opening ? 1 : 0;
          failed += state >= FaceState::failed ? 1 : 0;
        }
    std::vector<std::int64_t> numbers =
      {inserted, opened, failed, static_cast<std::int64_t>(n_too_short)};
    communicator.sum(numbers);
    const auto number = [&numbers](const std::size_t i) {
      return static_cast<std::uint64_t>(numbers[i]);
    };
    return {number(0), number(1), number(2), number(3)};
  }
} // namespace rift
