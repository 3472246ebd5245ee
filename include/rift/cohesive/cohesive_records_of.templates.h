#ifndef rift_cohesive_cohesive_records_of_templates_h
#define rift_cohesive_cohesive_records_of_templates_h

#include <rift/base/check.h>
#include <rift/cohesive/cohesive_elements_of.h>

// How cohesive elements are saved and restored.
namespace rift
{
  namespace internal
  {
    inline void
    append(std::vector<double> &numbers, const double number)
    {
      numbers.push_back(number);
    }

    inline void
    append(std::vector<double> &numbers, const Vector3<double> &vector)
    {
      numbers.insert(numbers.end(), vector.begin(), vector.end());
    }

    /** Reads member number i of all that have been appended. */
    inline void
    read(const std::vector<double> &numbers, const std::size_t i, double &value)
    {
      value = numbers.at(i);
    }

    inline void
    read(const std::vector<double> &numbers,
         const std::size_t          i,
         Vector3<double>           &value)
    {
      for (unsigned int d = 0; d < dim; ++d)
        value[d] = numbers.at(dim * i + d);
    }
  } // namespace internal

  template <typename Law>
  CohesiveRecords
  CohesiveElementsOf<Law>::records() const
  {
    CohesiveRecords result;
    // Blocks of all fields, also where nothing has opened.
    const Point any_point{};
    for_each_field(any_point, [&](const char *name, const auto &) {
      result.points[name];
    });
    for (std::size_t i = 0; i < faces.size(); ++i)
      {
        if (!faces.is_owned(i) || !faces.has_opened(i))
          continue;
        rift_check(memory_of(i / batch_size) != nullptr);
        const CohesiveFaceInfo &info   = faces.infos[i];
        const Memory           &memory = *memory_of(i / batch_size);
        const unsigned int      lane   = i % batch_size;
        result.faces.push_back({topology.face_name(info.face),
                                info.start_time,
                                info.failure_time,
                                memory.fracture[lane],
                                memory.friction[lane],
                                memory.given_cohesive[lane],
                                memory.given_frictional[lane]});
        for (unsigned int q = 0; q < n_face_points; ++q)
          {
            const Point now = point(i, q);
            for_each_field(now, [&](const char *name, const auto &value) {
              internal::append(result.points[name], value);
            });
          }
      }
    return result;
  }

  template <typename Law>
  void
  CohesiveElementsOf<Law>::restore(const CohesiveRecords          &records,
                                   const std::vector<std::size_t> &indices)
  {
    for (std::size_t r = 0; r < records.faces.size(); ++r)
      {
        const std::size_t i = indices[r];
        if (i == invalid_index)
          continue;
        rift_check(faces.has_opened(i));
        const CohesiveFaceRecord &record = records.faces[r];
        const unsigned int        lane   = i % batch_size;
        Memory                   *memory = memory_of(i / batch_size);
        if (memory == nullptr)
          memory = &make_memory(i / batch_size);
        memory->fracture[lane]         = record.fracture;
        memory->friction[lane]         = record.friction;
        memory->given_cohesive[lane]   = record.given_cohesive;
        memory->given_frictional[lane] = record.given_frictional;
        for (unsigned int q = 0; q < n_face_points; ++q)
          {
            Point now;
            for_each_field(now, [&](const char *name, auto &value) {
              internal::read(records.points.at(name),
                             r * n_face_points + q,
                             value);
            });
            set_point(i, q, now);
          }
      }
  }
} // namespace rift

#endif
