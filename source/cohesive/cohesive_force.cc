#include <rift/base/check.h>
#include <rift/cohesive/cohesive_force.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace rift
{
  namespace
  {
    /** Whether each corner is of a cut face and occurs once; sorted corners. */
    bool
    are_corners_of_cuts(const std::vector<OpeningCorner> &corners,
                        const Topology                   &topology)
    {
      for (std::size_t i = 0; i < corners.size(); ++i)
        if (topology.face_states[corners[i].face] == FaceState::intact ||
            corners[i].corner >= 3 ||
            (i > 0 && corners[i].face == corners[i - 1].face &&
             corners[i].corner == corners[i - 1].corner))
          return false;
      return true;
    }

    /** Whether there is one number, or vector, for each point of all faces. */
    bool
    are_of_all_points(const CohesiveRecords &records)
    {
      const std::size_t n = records.faces.size() * n_face_points;
      return std::all_of(records.points.begin(),
                         records.points.end(),
                         [n](const auto &field) {
                           const std::size_t n_numbers = field.second.size();
                           return n_numbers == n || n_numbers == dim * n;
                         });
    }
  } // namespace

  CohesiveForce::CohesiveForce(Topology                 &topology,
                               const ReferenceCellData  &reference,
                               const FaceStrengths      &strengths,
                               const CohesiveParameters &parameters,
                               PenaltyStiffness          stiffness_of)
    : topology(topology)
    , cohesive_faces(topology, reference)
    , elements(make_cohesive_elements(parameters,
                                      cohesive_faces,
                                      topology,
                                      strengths,
                                      std::move(stiffness_of)))
    , partings(topology, reference)
  {
  }

  void
  CohesiveForce::start_all(const State &state)
  {
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (topology.face_states[face] != FaceState::intact &&
          topology.needs_face(face))
        cohesive_faces.add(face, state);
    for (CohesiveFaceInfo &info : cohesive_faces.infos)
      info.start_time = 0;
    elements->take_in_new_faces();
  }

  void
  CohesiveForce::apply(const TopologyChange &change)
  {
    partings.add(change);
    std::vector<VertexIndex> vertices;
    for (const NodeSplit &split : change.splits)
      vertices.push_back(topology.node_vertices[split.parts[0]]);
    cohesive_faces.update_nodes(vertices);
  }

  void
  CohesiveForce::start_openings(const State               &state,
                                std::vector<OpeningCorner> corners)
  {
    // An order that does not depend on where they come from.
    std::sort(corners.begin(),
              corners.end(),
              [](const OpeningCorner &a, const OpeningCorner &b) {
                return std::make_pair(a.face, a.corner) <
                       std::make_pair(b.face, b.corner);
              });
    rift_check(are_corners_of_cuts(corners, topology));
    const OpeningCorner *const end = corners.data() + corners.size();
    for (const OpeningCorner *first = corners.data(); first != end;)
      {
        const OpeningCorner *const last =
          std::find_if(first, end, [first](const OpeningCorner &corner) {
            return corner.face != first->face;
          });
        if (!cohesive_faces.has(first->face))
          {
            cohesive_faces.add(first->face, state);
            cohesive_faces.set_state(cohesive_faces.size() - 1,
                                     FaceState::opening,
                                     state.time);
          }
        first = last;
      }
    elements->take_in_new_faces();
    elements->hold(state, corners);
  }

  void
  CohesiveForce::restore(const State &state, const CohesiveRecords &records)
  {
    rift_check(are_of_all_points(records));
    // In the order in which they have begun to open.
    const auto key = [&records](const std::size_t i) {
      const CohesiveFaceRecord &r = records.faces[i];
      return std::make_tuple(r.start_time, r.face.cell, r.face.local_face);
    };
    std::vector<std::size_t> order(records.faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(),
              order.end(),
              [&key](const std::size_t a, const std::size_t b) {
                return key(a) < key(b);
              });
    std::vector<std::size_t> indices(records.faces.size(), invalid_index);
    for (const std::size_t i : order)
      {
        const CohesiveFaceRecord &record = records.faces[i];
        const FaceIndex           face   = topology.find_face(record.face);
        if (face == invalid_index || !topology.needs_face(face))
          continue;
        if (!cohesive_faces.has(face))
          cohesive_faces.add(face, state);
        indices[i]             = cohesive_faces.index(face);
        CohesiveFaceInfo &info = cohesive_faces.infos[indices[i]];
        info.start_time        = record.start_time;
        info.failure_time      = record.failure_time;
      }
    elements->take_in_new_faces();
    elements->restore(records, indices);
  }

  std::optional<OpenFace>
  CohesiveForce::open_face(const std::size_t index) const
  {
    if (!cohesive_faces.has_opened(index))
      return {};
    const CohesiveBatch &batch = cohesive_faces.batches[index / batch_size];
    OpenFace             result{cohesive_faces.infos[index].face, {}};
    for (unsigned int c = 0; c < 3; ++c)
      {
        result.nodes[0][c] = batch.minus[c][index % batch_size];
        result.nodes[1][c] = batch.plus[c][index % batch_size];
      }
    return result;
  }

  std::vector<FaceMeans>
  CohesiveForce::means(const State &state) const
  {
    std::vector<FaceMeans> result = elements->means(state);
    for (std::size_t i = 0; i < result.size(); ++i)
      {
        result[i].start_time   = cohesive_faces.infos[i].start_time;
        result[i].failure_time = cohesive_faces.infos[i].failure_time;
      }
    return result;
  }
} // namespace rift
