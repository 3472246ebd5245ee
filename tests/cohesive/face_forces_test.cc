#include <rift/cohesive/face_kinematics.h>

#include <gtest/gtest.h>

#include <random>

using namespace rift;

namespace
{
  using Vector = Vector3<double>;

  /** Eight cohesive elements far from their place in the undeformed body:
   * wide open, slipped and turned; sizes are of the order of one. */
  struct OpenFaces
  {
    explicit OpenFaces(const unsigned int seed)
      : random(seed)
    {
      std::uniform_real_distribution<double> value(-1, 1);
      state.resize(6 * batch_size);
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        {
          for (unsigned int c = 0; c < 3; ++c)
            {
              const NodeIndex minus = 6 * lane + c, plus = minus + 3;
              batch.minus[c][lane] = minus;
              batch.plus[c][lane]  = plus;
              for (unsigned int d = 0; d < dim; ++d)
                {
                  state.reference[minus][d] = state.reference[plus][d] =
                    2 * (c == d) + .5 * value(random);
                  state.displacement[minus][d] = .4 * value(random);
                  state.displacement[plus][d]  = .4 * value(random);
                }
            }
          Vector edges[2];
          for (unsigned int e = 0; e < 2; ++e)
            edges[e] = state.reference[6 * lane + e + 1].vector() -
                       state.reference[6 * lane].vector();
          for (unsigned int e = 0; e < 2; ++e)
            for (unsigned int d = 0; d < dim; ++d)
              batch.edges[e][d][lane] = edges[e][d];
          batch.area[lane] = .5 * norm(cross(edges[0], edges[1]));
          for (auto &traction : tractions)
            for (unsigned int d = 0; d < dim; ++d)
              traction[d][lane] = value(random);
        }
      batch.n_faces = batch_size;
    }

    FaceForces
    forces() const
    {
      return face_forces(batch.area,
                         tractions,
                         FaceKinematics(batch, state),
                         quadrature);
    }

    /** Work of the tractions, as they are, on the jumps in the frame. */
    double
    work_on_jumps(const unsigned int lane) const
    {
      const FaceKinematics kinematics(batch, state);
      double               work = 0;
      for (unsigned int q = 0; q < n_face_points; ++q)
        {
          const auto jump = kinematics.jump_at(quadrature, q);
          for (unsigned int d = 0; d < dim; ++d)
            work += quadrature.weight[q] * batch.area[lane] *
                    tractions[q][d][lane] * jump[d][lane];
        }
      return work;
    }

    std::mt19937   random;
    State          state;
    CohesiveBatch  batch{};
    FaceTractions  tractions;
    FaceQuadrature quadrature;
  };

  Vector
  of_lane(const Vector3<Simd> &v, const unsigned int lane)
  {
    return {{v[0][lane], v[1][lane], v[2][lane]}};
  }

  /** A rotation by any angle about any axis, from a random quaternion. */
  Matrix3<double>
  random_rotation(std::mt19937 &random)
  {
    std::normal_distribution<double> value;
    double q[4] = {value(random), value(random), value(random), value(random)};
    const double length =
      std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double &x : q)
      x /= length;
    const Vector    v = {{q[1], q[2], q[3]}};
    Matrix3<double> r;
    for (unsigned int d = 0; d < dim; ++d)
      {
        Vector e            = {{0, 0, 0}};
        e[d]                = 1;
        const Vector column = (q[0] * q[0] - dot(v, v)) * e +
                              (2 * dot(v, e)) * v + (2 * q[0]) * cross(v, e);
        for (unsigned int i = 0; i < dim; ++i)
          r[i][d] = column[i];
      }
    return r;
  }
} // namespace

TEST(FaceQuadrature, IsExactToDegreeFive)
{
  const FaceQuadrature quadrature;
  const double         factorial[] = {1, 1, 2, 6, 24, 120, 720, 5040, 40320};
  double               error_of_degree[7] = {};
  for (unsigned int a = 0; a <= 6; ++a)
    for (unsigned int b = 0; a + b <= 6; ++b)
      for (unsigned int c = 0; a + b + c <= 6; ++c)
        {
          double sum = 0;
          for (unsigned int q = 0; q < n_face_points; ++q)
            {
              const auto &n = quadrature.shape[q];
              sum += quadrature.weight[q] * std::pow(n[0], a) *
                     std::pow(n[1], b) * std::pow(n[2], c);
            }
          const double exact = 2 * factorial[a] * factorial[b] * factorial[c] /
                               factorial[a + b + c + 2];
          double &error = error_of_degree[a + b + c];
          error         = std::max(error, std::abs(sum - exact));
        }
  for (unsigned int degree = 0; degree <= 5; ++degree)
    EXPECT_LT(error_of_degree[degree], 1e-15);
  EXPECT_GT(error_of_degree[6], 1e-5);
}

TEST(FaceForces, KeepMomentumAndAngularMomentum)
{
  for (unsigned int seed = 1; seed <= 200; ++seed)
    {
      const OpenFaces  faces(seed);
      const FaceForces forces = faces.forces();
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        {
          Vector sum = {{0, 0, 0}}, moment = {{0, 0, 0}};
          double size = 0;
          for (unsigned int c = 0; c < 3; ++c)
            {
              const Vector minus = of_lane(forces.minus[c], lane);
              const Vector plus  = of_lane(forces.plus[c], lane);
              sum += minus + plus;
              moment +=
                cross(faces.state.position(faces.batch.minus[c][lane]), minus) +
                cross(faces.state.position(faces.batch.plus[c][lane]), plus);
              size += norm(minus) + norm(plus);
            }
          EXPECT_GT(size, 1e-2);
          EXPECT_LT(norm(sum), 1e-14 * size);
          EXPECT_LT(norm(moment), 1e-14 * size * 3);
        }
    }
}

TEST(FaceForces, DoTheWorkOfTheTractions)
{
  std::uniform_real_distribution<double> value(-1, 1);
  for (unsigned int seed = 1; seed <= 200; ++seed)
    {
      OpenFaces           faces(seed);
      const FaceForces    forces = faces.forces();
      std::vector<Vector> direction(faces.state.n_nodes());
      for (Vector &v : direction)
        v = {{value(faces.random), value(faces.random), value(faces.random)}};
      const auto move = [&](const double length) {
        for (std::size_t i = 0; i < direction.size(); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            faces.state.displacement[i][d] += length * direction[i][d];
      };

      constexpr double               step = 1e-5;
      std::array<double, batch_size> after, before;
      move(step);
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        after[lane] = faces.work_on_jumps(lane);
      move(-2 * step);
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        before[lane] = faces.work_on_jumps(lane);

      for (unsigned int lane = 0; lane < batch_size; ++lane)
        {
          double power = 0, size = 0;
          for (unsigned int c = 0; c < 3; ++c)
            {
              const Vector minus = of_lane(forces.minus[c], lane);
              const Vector plus  = of_lane(forces.plus[c], lane);
              power += dot(minus, direction[faces.batch.minus[c][lane]]) +
                       dot(plus, direction[faces.batch.plus[c][lane]]);
              size += norm(minus) + norm(plus);
            }
          // The forces act against the jumps.
          EXPECT_NEAR(-power,
                      (after[lane] - before[lane]) / (2 * step),
                      1e-6 * size);
        }
    }
}

TEST(FaceKinematics, JumpsTurnWithTheFace)
{
  std::uniform_real_distribution<double> value(-1, 1);
  for (unsigned int seed = 1; seed <= 100; ++seed)
    {
      OpenFaces             faces(seed);
      const FaceKinematics  before(faces.batch, faces.state);
      const FaceForces      forces   = faces.forces();
      const Matrix3<double> rotation = random_rotation(faces.random);
      const Vector          shift    = {
                    {value(faces.random), value(faces.random), value(faces.random)}};
      for (NodeIndex i = 0; i < faces.state.n_nodes(); ++i)
        {
          const Vector u = shift + rotation * faces.state.position(i) -
                           faces.state.reference[i].vector();
          for (unsigned int d = 0; d < dim; ++d)
            faces.state.displacement[i][d] = u[d];
        }

      const FaceKinematics after(faces.batch, faces.state);
      const FaceForces     turned = faces.forces();
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        {
          for (unsigned int q = 0; q < n_face_points; ++q)
            EXPECT_LT(norm(of_lane(after.jump_at(faces.quadrature, q), lane) -
                           of_lane(before.jump_at(faces.quadrature, q), lane)),
                      1e-13);
          for (unsigned int c = 0; c < 3; ++c)
            {
              const Vector force = of_lane(forces.plus[c], lane);
              EXPECT_LT(norm(of_lane(turned.plus[c], lane) - rotation * force),
                        1e-12 * (1 + norm(force)));
            }
        }
    }
}

TEST(FaceKinematics, FirstAxisPointsFromMinusToPlus)
{
  // Plus lies 0.1 above minus, with the normal of (0, 1, 2) up, and has slid
  // by 0.2 and 0.3 along and across the edge from corner 0 to 1.
  OpenFaces    faces(1);
  const Vector x[3] = {{{0, 0, 0}}, {{2, 0, 0}}, {{0, 1, 0}}};
  const Vector jump = {{.2, .3, .1}};
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int d = 0; d < dim; ++d)
      {
        const NodeIndex minus           = faces.batch.minus[c][0];
        const NodeIndex plus            = faces.batch.plus[c][0];
        faces.state.reference[minus][d] = faces.state.reference[plus][d] =
          x[c][d];
        faces.state.displacement[minus][d] = 0;
        faces.state.displacement[plus][d]  = jump[d];
        if (c > 0)
          faces.batch.edges[c - 1][d][0] = x[c][d];
      }
  const FaceKinematics kinematics(faces.batch, faces.state);
  for (unsigned int q = 0; q < n_face_points; ++q)
    EXPECT_LT(norm(of_lane(kinematics.jump_at(faces.quadrature, q), 0) -
                   Vector{{.1, .2, .3}}),
              1e-15);
}
