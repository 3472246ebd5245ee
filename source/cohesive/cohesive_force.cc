#include <rift/cohesive/cohesive_force.h>

namespace rift
{
  CohesiveForce::CohesiveForce(Topology                    &topology,
                               const ReferenceCellData     &reference,
                               const FaceStrengths         &strengths,
                               std::vector<StiffnessMatrix> stiffnesses,
                               std::vector<double>          densities,
                               const double                 frequency_limit)
    : topology(topology)
    , reference(reference)
    , strengths(strengths)
    , stiffnesses(std::move(stiffnesses))
    , densities(std::move(densities))
    , frequency_limit(frequency_limit)
    , index_of_face(topology.faces.size(), invalid_index)
  {
  }

  void
  CohesiveForce::add_to(State &state)
  {
    for (std::size_t b = 0; b < cohesive_faces.batches.size(); ++b)
      {
        CohesiveBatch       &batch = cohesive_faces.batches[b];
        const FaceKinematics kinematics(batch, state);

        Simd largest_softening{};
        for (unsigned int q = 0; q < n_face_points; ++q)
          {
            CohesivePoint<Simd> &point = batch.points[q];
            const auto           dissipation =
              law.update(point,
                         batch.constants,
                         kinematics.jump_at(quadrature, q));
            const Simd area = quadrature.weight[q] * batch.area;
            batch.fracture += area * dissipation.fracture;
            batch.friction += area * dissipation.friction;
            largest_softening = max(largest_softening, point.softening);
          }
        if (any(largest_softening <= 0.))
          note_failures(b, state.time);
        release_distant_faces(b, kinematics, state.time);
        scatter(batch, face_forces(batch, kinematics, quadrature), state);
      }
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
    const CohesiveBatch &batch = cohesive_faces.batches[b];
    for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
      {
        CohesiveFaceInfo &info = cohesive_faces.infos[b * batch_size + lane];
        bool              has_failed = info.failure_time < 0;
        for (unsigned int q = 0; q < n_face_points && has_failed; ++q)
          has_failed = batch.points[q].softening[lane] <= 0;
        if (has_failed)
          fail(info, time);
      }
  }

  void
  CohesiveForce::release_distant_faces(const std::size_t     b,
                                       const FaceKinematics &kinematics,
                                       const double          time)
  {
    CohesiveBatch &batch = cohesive_faces.batches[b];
    Simd           largest{};
    for (const Vector3<Simd> &jump : kinematics.jumps)
      largest = max(largest, dot(jump, jump));
    const SimdMask is_distant =
      (largest > release_distance * release_distance * batch.area) &
      (batch.area > 0.);
    if (!any(is_distant))
      return;

    for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
      if (is_distant[lane])
        {
          for (unsigned int q = 0; q < n_face_points; ++q)
            {
              const auto t = get_point(batch, q, lane).traction;
              batch.fracture[lane] += .5 * quadrature.weight[q] *
                                      batch.area[lane] * dot(t, t) /
                                      batch.constants.stiffness[lane];
            }
          batch.area[lane] = 0;
          fail(cohesive_faces.infos[b * batch_size + lane], time);
        }
  }

  void
  CohesiveForce::fail(CohesiveFaceInfo &info, const double time)
  {
    if (info.failure_time >= 0)
      return;
    info.failure_time               = time;
    topology.face_states[info.face] = FaceState::broken;
  }

  CohesiveEnergy
  CohesiveForce::energy() const
  {
    CohesiveEnergy energy;
    for (std::size_t b = 0; b < cohesive_faces.batches.size(); ++b)
      {
        const CohesiveBatch &batch = cohesive_faces.batches[b];
        Simd                 elastic{};
        for (unsigned int q = 0; q < n_face_points; ++q)
          {
            const Vector3<Simd> &t = batch.points[q].traction;
            elastic += (.5 * quadrature.weight[q]) * batch.area * dot(t, t) /
                       batch.constants.stiffness;
          }
        for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
          {
            const auto &info = cohesive_faces.infos[b * batch_size + lane];
            if (!topology.owns_face(info.face))
              continue;
            energy.recoverable.add(elastic[lane]);
            energy.fracture.add(batch.fracture[lane]);
            energy.friction.add(batch.friction[lane]);
            // What the elastic branch was given at the start belongs to the
            // recoverable energy until the face has failed.
            (info.failure_time >= 0 ? energy.fracture : energy.recoverable)
              .add(-batch.initial[lane]);
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
        if (!topology.owns_face(info.face))
          continue;
        const CohesiveBatch &batch = cohesive_faces.batches[i / batch_size];
        ++opened;
        if (info.failure_time >= 0)
          ++failed;
        if (is_separation_too_short(strengths.strength(info.face),
                                    batch.constants.stiffness[i % batch_size]))
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
    const CohesiveBatch &batch = cohesive_faces.batches[index / batch_size];
    const unsigned int   lane  = index % batch_size;
    const auto  jump = FaceKinematics(batch, state).jump_at(quadrature, point);
    const auto &traction = batch.points[point].traction;
    PointState  result;
    for (unsigned int d = 0; d < dim; ++d)
      {
        result.jump[d]     = jump[d][lane];
        result.traction[d] = traction[d][lane];
      }
    return result;
  }
} // namespace rift
