#include <rift/cohesive/cohesive_force.h>
#include <rift/mesh/mesh_data.h>
#include <rift/solid/cell_frequency.h>

#include <algorithm>

namespace rift
{
  CohesiveForce::CohesiveForce(Topology                    &topology,
                               const ReferenceCellData     &reference,
                               const FaceStrengths         &strengths,
                               std::vector<StiffnessMatrix> stiffnesses,
                               std::vector<double>          densities,
                               const double                 largest_time_step)
    : topology(topology)
    , reference(reference)
    , strengths(strengths)
    , stiffnesses(std::move(stiffnesses))
    , densities(std::move(densities))
    , largest_time_step(largest_time_step)
    , index_of_face(topology.faces.size(), invalid_index)
  {
  }

  CohesiveForce::Kinematics
  CohesiveForce::kinematics(const State &state, const CohesiveBatch &batch)
  {
    std::array<Vector3<Simd>, 3> sums, differences;
    for (unsigned int c = 0; c < 3; ++c)
      {
        const auto minus = gather(state.displacement.data(), batch.minus[c]);
        const auto plus  = gather(state.displacement.data(), batch.plus[c]);
        sums[c]          = plus + minus;
        differences[c]   = plus - minus;
      }
    Kinematics result;
    result.frame = face_frame(batch, sums);
    for (unsigned int c = 0; c < 3; ++c)
      result.jumps[c] = result.frame * differences[c];
    return result;
  }

  Vector3<Simd>
  CohesiveForce::jump_at(const Kinematics  &kinematics,
                         const unsigned int point) const
  {
    Vector3<Simd> jump{};
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        jump[d] += quadrature.shape[point][c] * kinematics.jumps[c][d];
    return jump;
  }

  void
  CohesiveForce::add_to(State &state)
  {
    for (std::size_t b = 0; b < cohesive_faces.batches.size(); ++b)
      {
        CohesiveBatch   &batch = cohesive_faces.batches[b];
        const Kinematics now   = kinematics(state, batch);

        std::array<Vector3<Simd>, 3> corner_forces{};
        Simd                         largest_softening{};
        for (unsigned int q = 0; q < n_face_points; ++q)
          {
            Vector3<Simd> traction;
            const auto    dissipation = law.update(batch.points[q],
                                                batch.constants,
                                                jump_at(now, q),
                                                traction);
            const Simd    area        = quadrature.weight[q] * batch.area;
            batch.fracture += area * dissipation.fracture;
            batch.friction += area * dissipation.friction;
            for (unsigned int c = 0; c < 3; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                corner_forces[c][d] +=
                  (area * quadrature.shape[q][c]) * traction[d];
            largest_softening =
              max(largest_softening, batch.points[q].softening);
          }

        std::array<std::array<Row, batch_size>, 3> rows;
        for (unsigned int c = 0; c < 3; ++c)
          {
            Vector3<Simd> force{};
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int d = 0; d < dim; ++d)
                force[d] += now.frame[i][d] * corner_forces[c][i];
            rows[c] = transpose_to_rows(force);
          }
        for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
          for (unsigned int c = 0; c < 3; ++c)
            {
              state.force[batch.minus[c][lane]].row() += rows[c][lane];
              state.force[batch.plus[c][lane]].row() -= rows[c][lane];
            }
        if (any(largest_softening <= 0.))
          note_failures(b, state.time);
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
          {
            info.failure_time               = time;
            topology.face_states[info.face] = FaceState::broken;
            ++failed;
          }
      }
  }

  CohesiveEnergy
  CohesiveForce::energy(const State &state) const
  {
    Simd fracture{}, friction{}, recoverable{};
    for (std::size_t b = 0; b < cohesive_faces.batches.size(); ++b)
      {
        const CohesiveBatch &batch = cohesive_faces.batches[b];
        const Kinematics     now   = kinematics(state, batch);
        for (unsigned int q = 0; q < n_face_points; ++q)
          {
            const auto t =
              traction_at(batch.points[q], batch.constants, jump_at(now, q));
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
    const auto           jump  = jump_at(kinematics(state, batch), point);
    const auto           traction =
      traction_at(batch.points[point], batch.constants, jump);
    PointState result;
    for (unsigned int d = 0; d < dim; ++d)
      {
        result.jump[d]     = jump[d][lane];
        result.traction[d] = traction[d][lane];
      }
    return result;
  }
} // namespace rift
