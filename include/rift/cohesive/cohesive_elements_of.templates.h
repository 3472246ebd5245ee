#ifndef rift_cohesive_cohesive_elements_of_templates_h
#define rift_cohesive_cohesive_elements_of_templates_h

#include <rift/base/check.h>
#include <rift/cohesive/cohesive_elements_of.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  template <typename Law>
  CohesiveElementsOf<Law>::CohesiveElementsOf(CohesiveFaces       &faces,
                                              const Topology      &topology,
                                              const FaceStrengths &strengths,
                                              PenaltyStiffness     stiffness_of)
    : faces(faces)
    , topology(topology)
    , strengths(strengths)
    , stiffness_of(std::move(stiffness_of))
  {
  }

  template <typename Law>
  void
  CohesiveElementsOf<Law>::take_in_new_faces()
  {
    const std::size_t first = n_known_faces;
    n_known_faces           = faces.size();
    for (std::size_t i = first; i < n_known_faces; ++i)
      {
        const Constants constants =
          Law::make_constants(strength_of(i),
                              stiffness_of(faces.infos[i].face));
        // Lanes without a face are like the first one, but have no area.
        if (i % batch_size == 0)
          {
            all_constants.push_back(in_all_lanes<ConstantsOfBatch>(constants));
            memory_of_batch.push_back(invalid_index);
          }
        else
          set_lane(all_constants[i / batch_size], i % batch_size, constants);
      }
    rift_check(all_constants.size() == faces.batches.size() &&
               memory_of_batch.size() == faces.batches.size());
    for (std::size_t i = first; i < n_known_faces; ++i)
      if (Memory *memory = memory_of(i / batch_size))
        start_points(*memory, i);
      else if (!is_intrinsic)
        make_memory(i / batch_size);
  }

  template <typename Law>
  void
  CohesiveElementsOf<Law>::start_points(Memory           &memory,
                                        const std::size_t index) const
  {
    const Point intact = Law::make_point(strength_of(index), constants(index));
    for (PointsOfBatch &point : memory.points)
      set_lane(point, index % batch_size, intact);
  }

  template <typename Law>
  typename CohesiveElementsOf<Law>::Memory &
  CohesiveElementsOf<Law>::make_memory(const std::size_t b)
  {
    rift_check(memory_of_batch[b] == invalid_index);
    memory_of_batch[b]      = static_cast<std::uint32_t>(memories.size());
    const std::size_t first = b * batch_size;
    Memory            memory{};
    memory.points.fill(in_all_lanes<PointsOfBatch>(
      Law::make_point(strength_of(first), constants(first))));
    for (std::size_t i = first; i < first + faces.batches[b].n_faces; ++i)
      start_points(memory, i);
    memories.push_back(memory);
    return memories.back();
  }

  namespace internal
  {
    /**
     * The nodes of this many batches ahead are asked for, and the numbers of
     * nodes of twice as many: the two sides of a face lie apart in memory, and
     * the processor cannot guess where.
     */
    constexpr std::size_t prefetch_distance = 8;

    // Not inlined, GCC takes it for a function without effect and drops it.
    [[gnu::always_inline]] inline void
    prefetch(const std::vector<CohesiveBatch> &batches,
             const std::size_t                 b,
             const State                      &state)
    {
      if (b + 2 * prefetch_distance >= batches.size())
        return;
      const CohesiveBatch &far = batches[b + 2 * prefetch_distance];
      for (const auto *side : {&far.minus, &far.plus})
        for (const auto &corner : *side)
          __builtin_prefetch(corner);
      const CohesiveBatch &near = batches[b + prefetch_distance];
      for (const auto *side : {&near.minus, &near.plus})
        for (const auto &corner : *side)
          for (const NodeIndex node : corner)
            {
              __builtin_prefetch(&state.displacement[node]);
              __builtin_prefetch(&state.force[node], 1);
            }
    }
  } // namespace internal

  template <typename Law>
  void
  CohesiveElementsOf<Law>::add_to(State &state, const Activity &activity)
  {
    for (std::size_t b = 0; b < faces.batches.size(); ++b)
      {
        const CohesiveBatch &batch  = faces.batches[b];
        Memory              *memory = memory_of(b);
        if (memory == nullptr && faces.is_at_rest(b, activity))
          continue;
        internal::prefetch(faces.batches, b, state);
        const FaceKinematics kinematics(batch, state);
        FaceTractions        tractions;
        Simd                 area = batch.area;
        if constexpr (is_intrinsic)
          if (memory == nullptr)
            {
              bool yields;
              tractions = intact_tractions(b, kinematics, yields);
              if (yields)
                memory = &make_memory(b);
            }
        if (memory != nullptr)
          {
            area      = faces.acting_area(b);
            tractions = update(b, *memory, kinematics, state, area);
          }
        scatter(batch,
                face_forces(area, tractions, kinematics, quadrature),
                state);
      }
  }

  template <typename Law>
  FaceTractions
  CohesiveElementsOf<Law>::intact_tractions(const std::size_t     b,
                                            const FaceKinematics &kinematics,
                                            bool                 &yields) const
  {
    FaceTractions tractions;
    SimdMask      any_yields{};
    for (unsigned int q = 0; q < n_face_points; ++q)
      {
        SimdMask yields_here;
        tractions[q] = Law::intact_traction(all_constants[b],
                                            kinematics.jump_at(quadrature, q),
                                            yields_here);
        any_yields |= yields_here;
      }
    yields = any(any_yields);
    return tractions;
  }

  template <typename Law>
  FaceTractions
  CohesiveElementsOf<Law>::update(const std::size_t     b,
                                  Memory               &memory,
                                  const FaceKinematics &kinematics,
                                  const State          &state,
                                  Simd                 &area)
  {
    const ConstantsOfBatch &constants = all_constants[b];
    FaceTractions           tractions;
    SimdMask                has_opened{};
    SimdMask                has_failed = broadcast(1) > 0.;
    for (unsigned int q = 0; q < n_face_points; ++q)
      {
        PointsOfBatch &point = memory.points[q];
        const auto     dissipation =
          law.update(point, constants, kinematics.jump_at(quadrature, q));
        const Simd share = quadrature.weight[q] * area;
        memory.fracture += share * dissipation.fracture;
        memory.friction += share * dissipation.friction;
        has_failed &= Law::has_failed(point);
        if constexpr (is_intrinsic)
          {
            const Damage<Simd> damage = Law::damage(point);
            has_opened |= damage.opening + damage.slip > 0.;
          }
        tractions[q] = point.traction;
      }
    if (any(has_opened | has_failed))
      note_states(b, has_opened, has_failed, state.time);
    const SimdMask lanes = faces.lanes_to_release(b, kinematics, state.step);
    if (any(lanes))
      release(b, memory, lanes, state.time, area);
    return tractions;
  }

  template <typename Law>
  void
  CohesiveElementsOf<Law>::note_states(const std::size_t b,
                                       const SimdMask   &has_opened,
                                       const SimdMask   &has_failed,
                                       const double      time)
  {
    for (unsigned int lane = 0; lane < faces.batches[b].n_faces; ++lane)
      {
        if (has_opened[lane])
          faces.set_state(b * batch_size + lane, FaceState::opening, time);
        if (has_failed[lane])
          faces.set_state(b * batch_size + lane, FaceState::failed, time);
      }
  }

  template <typename Law>
  void
  CohesiveElementsOf<Law>::release(const std::size_t b,
                                   Memory           &memory,
                                   const SimdMask   &lanes,
                                   const double      time,
                                   Simd             &area)
  {
    Simd elastic{};
    for (unsigned int q = 0; q < n_face_points; ++q)
      elastic += quadrature.weight[q] * area *
                 Law::elastic_energy(memory.points[q], all_constants[b]);
    for (unsigned int lane = 0; lane < faces.batches[b].n_faces; ++lane)
      if (lanes[lane])
        {
          memory.fracture[lane] += elastic[lane];
          area[lane] = 0;
          faces.set_state(b * batch_size + lane, FaceState::released, time);
        }
  }

  template <typename Law>
  void
  CohesiveElementsOf<Law>::hold(const State                      &state,
                                const std::vector<OpeningCorner> &corners)
  {
    const OpeningCorner *const end = corners.data() + corners.size();
    for (const OpeningCorner *first = corners.data(); first != end;)
      {
        const OpeningCorner *last = first;
        while (last != end && last->face == first->face)
          ++last;
        hold_face(state, first, last);
        first = last;
      }
  }

  template <typename Law>
  void
  CohesiveElementsOf<Law>::hold_face(const State         &state,
                                     const OpeningCorner *first,
                                     const OpeningCorner *last)
  {
    const std::size_t index = faces.index(first->face);
    rift_check(last - first <= 3 && memory_of(index / batch_size) != nullptr);
    if (faces.state(index) == FaceState::released)
      return;
    const CohesiveBatch &batch  = faces.batches[index / batch_size];
    Memory              &memory = *memory_of(index / batch_size);
    const unsigned int   lane   = index % batch_size;
    const FaceKinematics kinematics(batch, state);
    const double         area     = batch.area[lane];
    const FaceStrength   strength = strength_of(index);
    const auto           forces =
      corner_forces_in_frame(batch, kinematics, lane, first, last);
    for (unsigned int q = 0; q < n_face_points; ++q)
      {
        const auto      jumps = kinematics.jump_at(quadrature, q);
        Vector3<double> jump;
        for (unsigned int d = 0; d < dim; ++d)
          jump[d] = jumps[d][lane];
        Point               point = get_lane<Point>(memory.points[q], lane);
        const InitialEnergy energy =
          Law::hold_traction(point,
                             strength,
                             constants(index),
                             jump,
                             traction_of(forces, area, quadrature.shape[q]));
        const double share = quadrature.weight[q] * area;
        memory.given_cohesive[lane] += share * energy.cohesive;
        memory.given_frictional[lane] += share * energy.frictional;
        set_lane(memory.points[q], lane, point);
      }
  }

  template <typename Law>
  Simd
  CohesiveElementsOf<Law>::elastic_energy(const State      &state,
                                          const std::size_t b) const
  {
    const Memory *memory = memory_of(b);
    Simd          energy{};
    if (memory != nullptr)
      {
        const Simd area = faces.acting_area(b);
        for (unsigned int q = 0; q < n_face_points; ++q)
          energy += quadrature.weight[q] * area *
                    Law::elastic_energy(memory->points[q], all_constants[b]);
      }
    else if constexpr (is_intrinsic)
      {
        const CohesiveBatch &batch = faces.batches[b];
        const FaceKinematics kinematics(batch, state);
        for (unsigned int q = 0; q < n_face_points; ++q)
          energy += quadrature.weight[q] * batch.area *
                    Law::intact_energy(all_constants[b],
                                       kinematics.jump_at(quadrature, q));
      }
    return energy;
  }

  template <typename Law>
  CohesiveEnergy
  CohesiveElementsOf<Law>::energy(const State &state) const
  {
    CohesiveEnergy energy;
    for (std::size_t b = 0; b < faces.batches.size(); ++b)
      {
        const Simd    elastic = elastic_energy(state, b);
        const Memory *memory  = memory_of(b);
        for (unsigned int lane = 0; lane < faces.batches[b].n_faces; ++lane)
          {
            const std::size_t i = b * batch_size + lane;
            if (!faces.is_owned(i))
              continue;
            energy.recoverable.add(elastic[lane]);
            if (memory == nullptr)
              continue;
            energy.fracture.add(memory->fracture[lane]);
            energy.friction.add(memory->friction[lane]);
            energy.recoverable.add(-memory->given_frictional[lane]);
            // Fracture has used up the other part when the face has failed.
            (faces.state(i) >= FaceState::failed ? energy.fracture :
                                                   energy.recoverable)
              .add(-memory->given_cohesive[lane]);
          }
      }
    return energy;
  }

  template <typename Law>
  std::size_t
  CohesiveElementsOf<Law>::count_unresolved() const
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (faces.is_owned(i) && faces.has_opened(i) &&
          !Law::is_resolved(strength_of(i), constants(i)))
        ++n;
    return n;
  }

  template <typename Law>
  std::vector<FaceMeans>
  CohesiveElementsOf<Law>::means(const State &state) const
  {
    std::vector<FaceMeans> result(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      {
        // What has not opened has no memory, perhaps.
        if (!faces.has_opened(i))
          continue;
        const unsigned int   lane = i % batch_size;
        const FaceKinematics kinematics(faces.batches[i / batch_size], state);
        FaceMeans           &means = result[i];
        for (unsigned int q = 0; q < n_face_points; ++q)
          {
            const double weight        = quadrature.weight[q];
            const auto   jump          = kinematics.jump_at(quadrature, q);
            const Point  now           = point(i, q);
            const auto [opening, slip] = Law::damage(now);
            means.damage += weight * std::min(1., std::hypot(opening, slip));
            means.opening_damage += weight * opening * opening;
            means.slip_damage += weight * slip * slip;
            means.opening += weight * jump[0][lane];
            means.slip += weight * std::hypot(jump[1][lane], jump[2][lane]);
            means.normal += weight * now.traction[0];
            means.shear +=
              weight * std::hypot(now.traction[1], now.traction[2]);
          }
      }
    return result;
  }
} // namespace rift

#endif
