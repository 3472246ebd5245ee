#include <rift/cohesive/cohesive_force.h>

#include <algorithm>
#include <tuple>

// What checkpoints need of CohesiveForce.
namespace rift
{
  std::vector<CohesiveFaceRecord>
  CohesiveForce::records() const
  {
    std::vector<CohesiveFaceRecord> result;
    for (std::size_t i = 0; i < cohesive_faces.size(); ++i)
      {
        const CohesiveFaceInfo &info = cohesive_faces.infos[i];
        if (!topology.owns_face(info.face) || !has_opened(i))
          continue;
        const CohesiveBatch  &batch  = cohesive_faces.batches[i / batch_size];
        const CohesiveMemory &memory = *cohesive_faces.memory_of(i);
        const unsigned int    lane   = i % batch_size;
        CohesiveFaceRecord    record{topology.face_name(info.face),
                                  info.start_time,
                                  info.failure_time,
                                  info.share,
                                  batch.area[lane],
                                  memory.fracture[lane],
                                  memory.friction[lane],
                                  memory.given[lane],
                                  memory.unpaid[lane],
                                  {}};
        for (unsigned int q = 0; q < n_face_points; ++q)
          record.points[q] = get_point(memory, q, lane);
        result.push_back(record);
      }
    return result;
  }

  void
  CohesiveForce::restore(const State                    &state,
                         std::vector<CohesiveFaceRecord> records)
  {
    // In the order in which they have begun to open.
    const auto key = [](const CohesiveFaceRecord &r) {
      return std::make_tuple(r.start_time, r.face.cell, r.face.local_face);
    };
    std::sort(records.begin(),
              records.end(),
              [&](const CohesiveFaceRecord &a, const CohesiveFaceRecord &b) {
                return key(a) < key(b);
              });
    for (const CohesiveFaceRecord &record : records)
      {
        const FaceIndex face = topology.find_face(record.face);
        if (face == invalid_index || !topology.needs_face(face))
          continue;
        if (index_of_face[face] == invalid_index)
          activate(face, state, record.share);
        const std::uint32_t i     = index_of_face[face];
        CohesiveBatch      &batch = cohesive_faces.batches[i / batch_size];
        if (batch.memory == invalid_index)
          make_memory(i / batch_size);
        CohesiveMemory    &memory = cohesive_faces.memories[batch.memory];
        const unsigned int lane   = i % batch_size;
        batch.area[lane]          = record.area;
        memory.fracture[lane]     = record.fracture;
        memory.friction[lane]     = record.friction;
        memory.given[lane]        = record.given;
        memory.unpaid[lane]       = record.unpaid;
        for (unsigned int q = 0; q < n_face_points; ++q)
          set_point(memory, q, lane, record.points[q]);
        CohesiveFaceInfo &info = cohesive_faces.infos[i];
        info.start_time        = record.start_time;
        if (record.failure_time >= 0)
          fail(info, record.failure_time);
      }
  }
} // namespace rift
