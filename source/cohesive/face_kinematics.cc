#include <rift/cohesive/face_kinematics.h>

namespace rift
{
  FaceKinematics::FaceKinematics(const CohesiveBatch &batch, const State &state)
  {
    const Simd                   half = broadcast(.5);
    std::array<Vector3<Simd>, 3> mean, difference;
    for (unsigned int c = 0; c < 3; ++c)
      {
        const auto minus = gather(state.displacement.data(), batch.minus[c]);
        const auto plus  = gather(state.displacement.data(), batch.plus[c]);
        mean[c]          = half * (plus + minus);
        difference[c]    = plus - minus;
      }
    const Vector3<Simd> edge_1     = batch.edges[0] + (mean[1] - mean[0]);
    const Vector3<Simd> edge_2     = batch.edges[1] + (mean[2] - mean[0]);
    const Vector3<Simd> area       = cross(edge_1, edge_2);
    const Simd          twice_area = sqrt(dot(area, area));
    length_1                       = sqrt(dot(edge_1, edge_1));
    frame[0]                       = (1. / twice_area) * area;
    frame[1]                       = (1. / length_1) * edge_1;
    frame[2]                       = cross(frame[0], frame[1]);
    along_2                        = dot(edge_2, frame[1]);
    across_2                       = twice_area / length_1;
    for (unsigned int c = 0; c < 3; ++c)
      jumps[c] = frame * difference[c];
  }

  Vector3<Simd>
  FaceKinematics::jump_at(const FaceQuadrature &quadrature,
                          const unsigned int    point) const
  {
    Vector3<Simd> jump{};
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        jump[d] += quadrature.shape[point][c] * jumps[c][d];
    return jump;
  }

  FaceForces
  face_forces(const Simd           &area,
              const FaceTractions  &tractions,
              const FaceKinematics &kinematics,
              const FaceQuadrature &quadrature)
  {
    const Matrix3<Simd>         &frame = kinematics.frame;
    std::array<Vector3<Simd>, 3> corner{};
    Vector3<Simd>                moment{};
    for (unsigned int q = 0; q < n_face_points; ++q)
      {
        const Simd          share = quadrature.weight[q] * area;
        const Vector3<Simd> t     = share * tractions[q];
        moment += cross(t, kinematics.jump_at(quadrature, q));
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            corner[c][d] += quadrature.shape[q][c] * t[d];
      }

    // The power of the moment on the turning of the frame, moment . omega,
    // with omega from the rates of the edges: normal components of both turn
    // the normal, the second tangential one of edge 1 the tangents.
    const Simd turn_2 = moment[1] / kinematics.across_2;
    const Simd turn_1 =
      -(moment[2] + turn_2 * kinematics.along_2) / kinematics.length_1;
    const Simd          twist  = moment[0] / kinematics.length_1;
    const Vector3<Simd> edge_1 = turn_1 * frame[0] + twist * frame[2];
    const Vector3<Simd> edge_2 = turn_2 * frame[0];

    // Edges end at the mean of both sides.
    const Simd                         half   = broadcast(.5);
    const std::array<Vector3<Simd>, 3> couple = {
      {half * (edge_1 + edge_2), -half * edge_1, -half * edge_2}};
    FaceForces forces;
    for (unsigned int c = 0; c < 3; ++c)
      {
        Vector3<Simd> traction{};
        for (unsigned int i = 0; i < dim; ++i)
          traction += corner[c][i] * frame[i];
        forces.minus[c] = couple[c] + traction;
        forces.plus[c]  = couple[c] - traction;
      }
    return forces;
  }

  void
  scatter(const CohesiveBatch &batch, const FaceForces &forces, State &state)
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

  CornerForces
  corner_forces_in_frame(const CohesiveBatch  &batch,
                         const FaceKinematics &kinematics,
                         const unsigned int    lane,
                         const OpeningCorner  *first,
                         const OpeningCorner  *last)
  {
    CornerForces    forces{};
    Vector3<double> mean = {{0, 0, 0}};
    for (auto corner = first; corner != last; ++corner)
      {
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            forces[corner->corner][i] +=
              kinematics.frame[i][d][lane] * corner->force[d];
        mean += (1. / (last - first)) * forces[corner->corner];
      }
    for (unsigned int c = 0; c < 3; ++c)
      if (batch.minus[c][lane] == batch.plus[c][lane])
        forces[c] = mean;
    return forces;
  }

  Vector3<double>
  traction_of(const CornerForces          &forces,
              const double                 area,
              const std::array<double, 3> &shape)
  {
    // The functions 4 N_c - 1 are dual to the N_c: each loads its own corner
    // alone.
    Vector3<double> traction = {{0, 0, 0}};
    for (unsigned int c = 0; c < 3; ++c)
      traction += (3 / area * (4 * shape[c] - 1)) * forces[c];
    return traction;
  }
} // namespace rift
