#include <rift/base/check.h>
#include <rift/cohesive/cohesive_faces.h>
#include <rift/cohesive/face_kinematics.h>
#include <rift/cohesive/partings.h>
#include <rift/mesh/mesh_data.h>

#include <cmath>

namespace rift
{
  FaceQuadrature::FaceQuadrature()
  {
    shape[0].fill(1. / 3.);
    weight[0]          = 9. / 40.;
    const double root  = std::sqrt(15.);
    const double at[2] = {(6 - root) / 21, (6 + root) / 21};
    const double w[2]  = {(155 - root) / 1200, (155 + root) / 1200};
    for (unsigned int orbit = 0; orbit < 2; ++orbit)
      for (unsigned int corner = 0; corner < 3; ++corner)
        {
          const unsigned int q = 1 + 3 * orbit + corner;
          shape[q].fill(at[orbit]);
          shape[q][corner] = 1 - 2 * at[orbit];
          weight[q]        = w[orbit];
        }
  }

  namespace
  {
    /** Whether the lanes of a batch with a face have an area, and no others. */
    bool
    is_padding_empty(const CohesiveBatch &batch)
    {
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        if ((batch.area[lane] > 0) != (lane < batch.n_faces))
          return false;
      return true;
    }
  } // namespace

  CohesiveFaces::CohesiveFaces(Topology                &topology,
                               const ReferenceCellData &reference)
    : topology(topology)
    , reference(reference)
    , index_of_face(topology.faces.size(), invalid_index)
  {
  }

  void
  CohesiveFaces::add(const FaceIndex face, const State &state)
  {
    rift_check(!has(face));
    const unsigned int lane = size() % batch_size;
    if (lane == 0)
      {
        // Lanes without a face are triangles of no area that never open.
        CohesiveBatch empty{};
        empty.edges[0][0] = empty.edges[1][1] = broadcast(1);
        batches.push_back(empty);
      }
    index_of_face[face] = static_cast<std::uint32_t>(size());
    infos.push_back({face, state.time, -1});

    CohesiveBatch &batch = batches.back();
    batch.n_faces        = lane + 1;
    batch.area[lane]     = reference_area(topology, reference, face);
    rift_check(is_padding_empty(batch));
    rift_check(batches.size() == (size() + batch_size - 1) / batch_size);
    update_face(face);
    for (unsigned int e = 0; e < 2; ++e)
      for (unsigned int d = 0; d < dim; ++d)
        batch.edges[e][d][lane] = state.reference[batch.minus[e + 1][lane]][d] -
                                  state.reference[batch.minus[0][lane]][d];
  }

  void
  CohesiveFaces::update_nodes(const std::vector<VertexIndex> &vertices)
  {
    for (const VertexIndex vertex : vertices)
      for (const CutCorner &corner : cut_corners_at(topology, vertex))
        if (has(corner.face))
          update_face(corner.face);
  }

  void
  CohesiveFaces::update_face(const FaceIndex index)
  {
    const std::uint32_t i = index_of_face[index];
    rift_check(i < size() && infos[i].face == index);
    CohesiveBatch &batch = batches[i / batch_size];
    const Face    &face  = topology.faces[index];
    for (unsigned int c = 0; c < 3; ++c)
      {
        const unsigned int corner      = face_corners[face.local_faces[0]][c];
        const VertexIndex  vertex      = topology.vertex(face.cells[0], corner);
        batch.minus[c][i % batch_size] = topology.node(face.cells[0], corner);
        batch.plus[c][i % batch_size] =
          topology.node(face.cells[1],
                        topology.corner_at_vertex(face.cells[1], vertex));
      }
  }

  void
  CohesiveFaces::set_state(const std::size_t index,
                           const FaceState   next,
                           const double      time)
  {
    FaceState &state = topology.face_states[infos[index].face];
    rift_check(state != FaceState::intact);
    rift_check((state >= FaceState::failed) ==
               (infos[index].failure_time >= 0));
    if (next <= state)
      return;
    if (next >= FaceState::failed && state < FaceState::failed)
      infos[index].failure_time = time;
    state = next;
  }

  Simd
  CohesiveFaces::acting_area(const std::size_t b) const
  {
    Simd area = batches[b].area;
    for (unsigned int lane = 0; lane < batches[b].n_faces; ++lane)
      if (state(b * batch_size + lane) == FaceState::released)
        area[lane] = 0;
    return area;
  }

  SimdMask
  CohesiveFaces::lanes_to_release(const std::size_t     b,
                                  const FaceKinematics &kinematics,
                                  const std::uint64_t   step) const
  {
    const CohesiveBatch &batch = batches[b];
    Simd                 largest{};
    for (const Vector3<Simd> &jump : kinematics.jumps)
      largest = max(largest, dot(jump, jump));
    // Less in a thin face, whose mid-plane would collapse.
    const Vector3<Simd> edge_3  = batch.edges[1] - batch.edges[0];
    const Simd          longest = max(max(dot(batch.edges[0], batch.edges[0]),
                                 dot(batch.edges[1], batch.edges[1])),
                             dot(edge_3, edge_3));
    const Simd size = batch.area * min(broadcast(1), 4. * batch.area / longest);
    SimdMask   result = largest > release_distance * release_distance * size;

    const bool is_contact_due =
      contact_interval > 0 && (step + 1) % contact_interval == 0;
    if (!is_contact_due && !any(result))
      return result;
    SimdMask is_open = largest > contact_opening * contact_opening * size;
    for (const Vector3<Simd> &jump : kinematics.jumps)
      is_open &= jump[0] > 0.;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      {
        const bool is_face = lane < batch.n_faces;
        const auto now =
          is_face ? state(b * batch_size + lane) : FaceState::intact;
        const bool to_contact =
          is_contact_due && is_open[lane] && now == FaceState::failed;
        if (now < FaceState::opening || now == FaceState::released ||
            !(result[lane] || to_contact))
          result[lane] = 0;
        else
          result[lane] = -1;
      }
    return result;
  }

  bool
  CohesiveFaces::is_at_rest(const std::size_t b, const Activity &activity) const
  {
    const std::size_t end = b * batch_size + batches[b].n_faces;
    for (std::size_t i = b * batch_size; i < end; ++i)
      for (const CellIndex cell : topology.faces[infos[i].face].cells)
        if (activity.is_awake(cell / batch_size))
          return false;
    return true;
  }
} // namespace rift
