#include <rift/cohesive/cohesive_force.h>

namespace rift
{
  namespace
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
  } // namespace

  CohesiveForce::AnyLaw
  CohesiveForce::law_of(const CohesiveParameters::Model model)
  {
    if (model == CohesiveParameters::Model::intrinsic)
      return MohrCoulomb<ParabolicBranch>();
    return MohrCoulomb<StraightBranch>();
  }

  CohesiveForce::CohesiveForce(Topology                       &topology,
                               const ReferenceCellData        &reference,
                               const FaceStrengths            &strengths,
                               const CohesiveParameters::Model model,
                               FaceSlope                       slope,
                               const double                    least_share)
    : topology(topology)
    , reference(reference)
    , strengths(strengths)
    , slope(std::move(slope))
    , law(law_of(model))
    , part_of_fracture(
        std::visit([](const auto &law) { return law.part_of_fracture; }, law))
    , least_share(least_share)
    , index_of_face(topology.faces.size(), invalid_index)
  {
  }

  void
  CohesiveForce::add_to(State &state, const Activity &activity)
  {
    std::visit(
      [&](const auto &the_law) { add_forces(the_law, state, activity); },
      law);
  }

  template <typename Law>
  void
  CohesiveForce::add_forces(const Law      &the_law,
                            State          &state,
                            const Activity &activity)
  {
    for (std::size_t b = 0; b < cohesive_faces.batches.size(); ++b)
      {
        const CohesiveBatch &batch = cohesive_faces.batches[b];
        if (batch.memory == invalid_index && is_at_rest(b, activity))
          continue;
        prefetch(cohesive_faces.batches, b, state);
        const FaceKinematics kinematics(batch, state);
        FaceTractions        tractions;
        bool                 yields = false;
        if (batch.memory == invalid_index)
          {
            tractions = intact_tractions<Law>(batch, kinematics, yields);
            if (yields)
              make_memory(b);
          }
        if (batch.memory != invalid_index)
          tractions = update_memory(the_law, b, kinematics, state);
        scatter(batch,
                face_forces(batch.area, tractions, kinematics, quadrature),
                state);
      }
  }

  template <typename Law>
  FaceTractions
  CohesiveForce::intact_tractions(const CohesiveBatch  &batch,
                                  const FaceKinematics &kinematics,
                                  bool                 &yields) const
  {
    FaceTractions tractions;
    SimdMask      any_yields{};
    for (unsigned int q = 0; q < n_face_points; ++q)
      {
        SimdMask yields_here;
        tractions[q] = Law::intact_traction(batch.constants,
                                            batch.cohesion,
                                            kinematics.jump_at(quadrature, q),
                                            yields_here);
        any_yields |= yields_here;
      }
    yields = any(any_yields);
    return tractions;
  }

  template <typename Law>
  FaceTractions
  CohesiveForce::update_memory(const Law            &the_law,
                               const std::size_t     b,
                               const FaceKinematics &kinematics,
                               const State          &state)
  {
    const CohesiveBatch &batch  = cohesive_faces.batches[b];
    CohesiveMemory      &memory = cohesive_faces.memories[batch.memory];
    FaceTractions        tractions;
    Simd                 largest_softening{};
    for (unsigned int q = 0; q < n_face_points; ++q)
      {
        CohesivePoint<Simd> &point = memory.points[q];
        const auto           dissipation =
          the_law.update(point,
                         batch.constants,
                         kinematics.jump_at(quadrature, q));
        const Simd area = quadrature.weight[q] * batch.area;
        memory.fracture += area * dissipation.fracture;
        memory.friction += area * dissipation.friction;
        largest_softening = max(largest_softening, point.softening);
        tractions[q]      = point.traction;
      }
    if (any(largest_softening <= 0.))
      note_failures(b, state.time);
    release_distant_faces(b, kinematics, state);
    return tractions;
  }

  bool
  CohesiveForce::is_at_rest(const std::size_t b, const Activity &activity) const
  {
    const std::size_t end = b * batch_size + cohesive_faces.batches[b].n_faces;
    for (std::size_t i = b * batch_size; i < end; ++i)
      for (const CellIndex cell :
           topology.faces[cohesive_faces.infos[i].face].cells)
        if (activity.is_awake(cell / batch_size))
          return false;
    return true;
  }

  void
  CohesiveForce::scatter(const CohesiveBatch &batch,
                         const FaceForces    &forces,
                         State               &state)
  {
    std::array<std::array<Row, batch_size>, 3> minus, plus;
    for (unsigned int c = 0; c < 3; ++c)
      {
        minus[c] = transpose_to_rows(forces.minus[c]);
        plus[c]  = transpose_to_rows(forces.plus[c]);
      }
    for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
      for (unsigned int c = 0; c < 3; ++c)
        {
          state.force[batch.minus[c][lane]].row() += minus[c][lane];
          state.force[batch.plus[c][lane]].row() += plus[c][lane];
        }
  }

  void
  CohesiveForce::note_failures(const std::size_t b, const double time)
  {
    const CohesiveBatch  &batch  = cohesive_faces.batches[b];
    const CohesiveMemory &memory = cohesive_faces.memories[batch.memory];
    for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
      {
        CohesiveFaceInfo &info = cohesive_faces.infos[b * batch_size + lane];
        bool              has_failed = info.failure_time < 0;
        for (unsigned int q = 0; q < n_face_points && has_failed; ++q)
          has_failed = memory.points[q].softening[lane] <= 0;
        if (has_failed)
          fail(info, time);
      }
  }

  SimdMask
  CohesiveForce::is_open_and_failed(const std::size_t     b,
                                    const FaceKinematics &kinematics) const
  {
    SimdMask result = broadcast(1) > 0.;
    for (const Vector3<Simd> &jump : kinematics.jumps)
      result &= jump[0] > 0.;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      if (b * batch_size + lane >= cohesive_faces.size() ||
          cohesive_faces.infos[b * batch_size + lane].failure_time < 0)
        result[lane] = 0;
    return result;
  }

  void
  CohesiveForce::release_distant_faces(const std::size_t     b,
                                       const FaceKinematics &kinematics,
                                       const State          &state)
  {
    CohesiveBatch &batch = cohesive_faces.batches[b];
    Simd           largest{};
    for (const Vector3<Simd> &jump : kinematics.jumps)
      largest = max(largest, dot(jump, jump));
    // Less in a thin face, whose mid-plane would collapse.
    const Vector3<Simd> edge_3  = batch.edges[1] - batch.edges[0];
    const Simd          longest = max(max(dot(batch.edges[0], batch.edges[0]),
                                 dot(batch.edges[1], batch.edges[1])),
                             dot(edge_3, edge_3));
    const Simd size = batch.area * min(broadcast(1), 4. * batch.area / longest);
    SimdMask   lets_go = largest > release_distance * release_distance * size;
    if (contact_interval > 0 && (state.step + 1) % contact_interval == 0)
      lets_go |= is_open_and_failed(b, kinematics);
    lets_go &= batch.area > 0.;
    if (!any(lets_go))
      return;

    CohesiveMemory &memory  = cohesive_faces.memories[batch.memory];
    const Simd      elastic = elastic_energy(state, batch);
    const Simd      debt    = debt_of(batch);
    for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
      if (lets_go[lane] && has_opened(b * batch_size + lane))
        {
          memory.fracture[lane] += elastic[lane];
          memory.unpaid[lane] += debt[lane];
          batch.area[lane] = 0;
          ++event_counter;
          fail(cohesive_faces.infos[b * batch_size + lane], state.time);
        }
  }

  void
  CohesiveForce::fail(CohesiveFaceInfo &info, const double time)
  {
    if (info.failure_time >= 0)
      return;
    ++event_counter;
    info.failure_time               = time;
    topology.face_states[info.face] = FaceState::broken;
  }

  template <typename Law>
  Simd
  CohesiveForce::elastic_energy(const State         &state,
                                const CohesiveBatch &batch) const
  {
    FaceTractions tractions;
    bool          yields;
    if (batch.memory == invalid_index)
      tractions =
        intact_tractions<Law>(batch, FaceKinematics(batch, state), yields);
    Simd energy{};
    for (unsigned int q = 0; q < n_face_points; ++q)
      {
        CohesivePoint<Simd> point{};
        if (batch.memory != invalid_index)
          point = cohesive_faces.memories[batch.memory].points[q];
        else
          {
            point.softening = broadcast(1);
            point.cohesion  = batch.cohesion;
            point.traction  = tractions[q];
          }
        energy += quadrature.weight[q] * batch.area *
                  Law::elastic_energy(point, batch.constants);
      }
    return energy;
  }

  Simd
  CohesiveForce::elastic_energy(const State         &state,
                                const CohesiveBatch &batch) const
  {
    return std::visit(
      [&](const auto &the_law) {
        return elastic_energy<std::decay_t<decltype(the_law)>>(state, batch);
      },
      law);
  }

  Simd
  CohesiveForce::debt_of(const CohesiveBatch &batch) const
  {
    Simd debt{};
    if (batch.memory != invalid_index)
      for (unsigned int q = 0; q < n_face_points; ++q)
        debt += quadrature.weight[q] * batch.area *
                cohesive_faces.memories[batch.memory].points[q].debt;
    return debt;
  }

  CohesiveEnergy
  CohesiveForce::energy(const State &state) const
  {
    CohesiveEnergy energy;
    for (std::size_t b = 0; b < cohesive_faces.batches.size(); ++b)
      {
        const CohesiveBatch &batch = cohesive_faces.batches[b];
        const Simd recoverable = elastic_energy(state, batch) - debt_of(batch);
        for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
          {
            const std::size_t i    = b * batch_size + lane;
            const auto       &info = cohesive_faces.infos[i];
            if (!topology.owns_face(info.face))
              continue;
            energy.recoverable.add(recoverable[lane]);
            const CohesiveMemory *memory = cohesive_faces.memory_of(i);
            if (memory == nullptr)
              continue;
            energy.fracture.add(memory->fracture[lane]);
            energy.friction.add(memory->friction[lane]);
            energy.recoverable.add(-memory->unpaid[lane]);
            // What the elastic branch was given at the start belongs to the
            // recoverable energy until the face has failed.
            (info.failure_time >= 0 ? energy.fracture : energy.recoverable)
              .add(-memory->given[lane]);
          }
      }
    return energy;
  }

  FaceCounts
  CohesiveForce::count_faces(const Communicator &communicator) const
  {
    std::int64_t inserted = 0, opened = 0, failed = 0, too_short = 0;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (topology.owns_face(face) &&
          topology.face_states[face] != FaceState::intact)
        ++inserted;
    for (std::size_t i = 0; i < cohesive_faces.size(); ++i)
      {
        const CohesiveFaceInfo &info = cohesive_faces.infos[i];
        if (!topology.owns_face(info.face) || !has_opened(i))
          continue;
        const CohesiveBatch &batch = cohesive_faces.batches[i / batch_size];
        ++opened;
        if (info.failure_time >= 0)
          ++failed;
        if (is_separation_too_short(strength_of(info),
                                    batch.constants.stiffness[i % batch_size],
                                    part_of_fracture))
          ++too_short;
      }
    std::vector<std::int64_t> numbers = {inserted, opened, failed, too_short};
    communicator.sum(numbers);
    const auto number = [&numbers](const std::size_t i) {
      return static_cast<std::uint64_t>(numbers[i]);
    };
    return {number(0), number(1), number(2), number(3)};
  }

  CohesiveForce::PointState
  CohesiveForce::point_state(const State       &state,
                             const std::size_t  index,
                             const unsigned int point) const
  {
    const CohesiveBatch  &batch = cohesive_faces.batches[index / batch_size];
    const unsigned int    lane  = index % batch_size;
    const FaceKinematics  kinematics(batch, state);
    const auto            jump   = kinematics.jump_at(quadrature, point);
    const CohesiveMemory *memory = cohesive_faces.memory_of(index);
    Vector3<Simd>         traction;
    if (memory != nullptr)
      traction = memory->points[point].traction;
    else
      {
        bool yields;
        traction =
          intact_tractions<MohrCoulomb<ParabolicBranch>>(batch,
                                                         kinematics,
                                                         yields)[point];
      }
    PointState result{};
    for (unsigned int d = 0; d < dim; ++d)
      {
        result.jump[d]     = jump[d][lane];
        result.traction[d] = traction[d][lane];
      }
    if (memory != nullptr)
      {
        result.opening = memory->points[point].opening[lane];
        result.slip    = memory->points[point].slip[lane];
        result.damage  = std::min(1., std::hypot(result.opening, result.slip));
      }
    return result;
  }

  bool
  CohesiveForce::holds(const FaceIndex face) const
  {
    const std::uint32_t i = index_of_face[face];
    return i == invalid_index ||
           cohesive_faces.batches[i / batch_size].area[i % batch_size] > 0;
  }

  bool
  CohesiveForce::has_opened(const std::size_t index) const
  {
    if (std::holds_alternative<MohrCoulomb<StraightBranch>>(law))
      return true;
    const CohesiveMemory *memory = cohesive_faces.memory_of(index);
    if (memory == nullptr)
      return false;
    const unsigned int lane = index % batch_size;
    for (const CohesivePoint<Simd> &point : memory->points)
      if (point.opening[lane] > 0 || point.slip[lane] > 0)
        return true;
    return false;
  }
} // namespace rift
