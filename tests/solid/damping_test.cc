// Viscous stress: its value, rigid motion, and where the energy goes.

#include <rift/solid/damping.h>
#include <rift/time_integration/central_difference.h>

#include "../support/elastic_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  constexpr double eta = 3e5;

  /** Gives each node the velocity L x of its current position. */
  void
  impose_velocity(State &state, const Matrix3<double> &l)
  {
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      {
        const Vector3<double> v = l * state.position(i);
        for (unsigned int d = 0; d < 3; ++d)
          state.velocity[i][d] = v[d];
      }
  }

  Matrix3<double>
  random_deformation(Random &random)
  {
    auto h = random_matrix(random);
    for (auto &row : h)
      row = .1 * row;
    return rotated(random_rotation(random), h);
  }

  double
  largest_force(const State &state)
  {
    double result = 0;
    for (const auto &f : state.force)
      result = std::max(result, norm(f.vector()));
    return result;
  }

  /**
   * Largest error of kinetic + strain + dissipated energy over the energy at
   * the start, of a body that is stretched by `amplitude` and let go.
   */
  struct Vibration
  {
    double error, dissipated_share;
  };

  Vibration
  vibrate(const double amplitude, const double share_of_step)
  {
    // The viscosity makes a few per cent of critical damping.
    ElasticBody body(make_box({{2, 2, 3}}, 1, .1), granite());
    Damping     damping(body.topology, body.discrete.reference, {eta});
    impose_gradient(body.state,
                    {{{{amplitude, .3 * amplitude, 0}},
                      {{0, -.5 * amplitude, 0}},
                      {{.2 * amplitude, 0, amplitude}}}});
    const double dt    = share_of_step * body.critical_step(eta);
    const double end   = 60 * body.critical_step(eta);
    double       start = 0;
    Vibration    result{0, 0};
    while (body.state.time < end)
      {
        EXPECT_FALSE(body.force.add_to(body.state, body.activity));
        damping.add_to(body.state, body.activity);
        if (body.state.step == 0)
          start_velocities(body.state, dt);
        damping.count_work(body.state, dt);
        const double dissipated = damping.work().sum().value();
        const double energy =
          kinetic_energy(body.topology, body.state, dt).value() +
          body.force.strain_energy(body.state).value() + dissipated;
        if (body.state.step == 0)
          start = energy;
        result.error = std::max(result.error, std::abs(energy / start - 1));
        result.dissipated_share = dissipated / start;
        advance(body.state, body.activity, dt);
      }
    return result;
  }
} // namespace

TEST(Damping, StressIsViscosityTimesRateOfDeformation)
{
  // Virial theorem: minus the sum of f_a x_a^T is the stress times the volume.
  Random random(1);
  for (unsigned int n = 0; n < 20; ++n)
    {
      ElasticBody body(make_box({{3, 3, 2}}, 1, .1, random()), granite());
      Damping     damping(body.topology, body.discrete.reference, {eta});
      const auto  h = random_deformation(random), l = random_matrix(random);
      impose_gradient(body.state, h);
      impose_velocity(body.state, l);
      damping.add_to(body.state, body.activity);

      Matrix3<double> virial{}, f = h;
      for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
        for (unsigned int r = 0; r < 3; ++r)
          virial[r] += (-body.state.force[i][r]) * body.state.position(i);
      for (unsigned int d = 0; d < 3; ++d)
        f[d][d] += 1;
      const double volume = 18 * determinant(f);
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          EXPECT_NEAR(virial[i][j] / volume,
                      eta * (l[i][j] + l[j][i]) / 2,
                      1e-12 * eta);

      // The stress is the same everywhere: no force inside.
      const auto surface =
        surface_nodes(body.topology, whole_surface(body.topology));
      for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
        if (!std::binary_search(surface.begin(), surface.end(), i))
          {
            EXPECT_LT(norm(body.state.force[i].vector()),
                      1e-12 * largest_force(body.state));
          }
    }
}

TEST(Damping, RigidRotationGivesNoForce)
{
  Random random(2);
  for (unsigned int n = 0; n < 50; ++n)
    {
      ElasticBody body(make_box({{2, 2, 2}}, 1, .1, random()), granite());
      Damping     damping(body.topology, body.discrete.reference, {eta});
      impose_gradient(body.state, random_deformation(random));
      const Vector3<double> w    = 7. * random_direction(random);
      const Matrix3<double> spin = {
        {{{0, -w[2], w[1]}}, {{w[2], 0, -w[0]}}, {{-w[1], w[0], 0}}}};
      impose_velocity(body.state, spin);
      damping.add_to(body.state, body.activity);
      EXPECT_LT(largest_force(body.state), 1e-12 * eta * 7);
    }
}

TEST(Damping, OnlyWhereAMaterialIsViscous)
{
  Body box = make_box({{2, 2, 4}});
  for (LocalCell &cell : box.cells)
    cell.material = box.vertices[cell.vertices[0]][2] < 2 ? 0 : 1;
  DiscreteBody body = discretize(box, {2000, 2000});
  Activity     activity(body.topology);
  activity.wake_all(body.topology);
  Damping damping(body.topology, body.reference, {0, eta});
  impose_velocity(body.state, {{{{1, 0, 0}}, {{0, 0, 0}}, {{0, 0, 0}}}});
  damping.add_to(body.state, activity);
  for (std::size_t i = 0; i < body.state.n_nodes(); ++i)
    if (body.state.reference[i][2] < 2)
      {
        EXPECT_EQ(norm(body.state.force[i].vector()), 0);
      }
  EXPECT_GT(largest_force(body.state), .1 * eta);
}

TEST(Damping, EnergyOfALinearBodyIsExact)
{
  const Vibration v = vibrate(1e-13, .7);
  EXPECT_LT(v.error, 1e-12);
  EXPECT_GT(v.dissipated_share, .1);
  EXPECT_LT(v.dissipated_share, 1);
}

TEST(Damping, EnergyErrorFallsWithTheSquareOfTheStep)
{
  const double errors[3] = {vibrate(.02, .4).error,
                            vibrate(.02, .2).error,
                            vibrate(.02, .1).error};
  EXPECT_LT(errors[0], 1e-3);
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2, .25);
}
