#ifndef rift_tests_contact_released_faces_h
#define rift_tests_contact_released_faces_h

#include <rift/mesh/node_splitter.h>

#include "../support/test_body.h"

namespace rift::test
{
  /** Where the corners of a cell are in the undeformed body, m. */
  inline std::array<Vector3<double>, 4>
  corners(const DiscreteBody &body, const CellIndex cell)
  {
    std::array<Vector3<double>, 4> result;
    for (unsigned int c = 0; c < n_corners; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        result[c][d] = body.state.reference[body.topology.vertex(cell, c)][d];
    return result;
  }

  /** Cuts faces of a body and leaves them to contact. */
  inline void
  release(DiscreteBody &body, const std::vector<FaceIndex> &faces)
  {
    split_nodes(body.topology, faces);
    for (const FaceIndex face : faces)
      body.topology.face_states[face] = FaceState::released;
  }
} // namespace rift::test

#endif
