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
    ++failed;
  }

  CohesiveEnergy
  CohesiveForce::energy() const
  {
    Simd fracture{}, friction{}, recoverable{};
    for (std::size_t b = 0; b < cohesive_faces.batches.size(); ++b)
      {
        const CohesiveBatch &batch = cohesive_faces.batches[b];
        for (unsigned int q = 0; q < n_face_points; ++q)
          {
            const Vector3<Simd> &t = batch.points[q].traction;
            recoverable += (.5 * quadrature.weight[q]) * batch.area *
                           dot(t, t) / batch.constants.stiffness;
          }
        fracture += batch.fracture;
        friction += batch.friction;
        // What the elastic branch was given at the start belongs to the
        // recoverable energy until the face has failed.
        for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
          {
            const bool has_failed =
              cohesive_faces.infos[b * batch_size + lane].failure_time >= 0;
            (has_failed ? fracture : recoverable)[lane] -= batch.initial[lane];
          }
      }
    CohesiveEnergy energy;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      {
        energy.recoverable += recoverable[lane];
        energy.fracture += fracture[lane];
        energy.friction += friction[lane];
      }
    return energy;
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
