// Rigid bodies in contact with elastic ones.

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>

#include <gtest/gtest.h>

using namespace rift;

namespace
{
  Parameters
  scene(const std::string &name, const std::vector<std::string> &overrides = {})
  {
    return read_parameters(RIFT_SOURCE_DIRECTORY "/" + name, overrides);
  }

  constexpr double speed = 2, area = 1e-4, density = 2700, modulus = 50e9;
} // namespace

TEST(Rigid, HammerIsSlowedDownByTheWave)
{
  Log            log(nullptr);
  Simulation     simulation(scene("prm/contact/hammer.prm"), log);
  FlushDenormals flush_denormals;
  const double   mass         = 7850 * .02 * 1.2e-2 * 1.2e-2;
  const double   rate         = std::sqrt(density * modulus) * area / mass;
  const State   &state        = simulation.state();
  const auto     hammer_speed = [&state] {
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      if (state.reference[i][0] < 0)
        return state.velocity[i][0];
    return 0.;
  };
  double early = 0, early_time = 0;
  while (state.step < simulation.n_steps())
    {
      simulation.step();
      if (state.time > 10e-6 && early == 0)
        {
          early      = hammer_speed();
          early_time = state.time;
        }
    }
  // Cells of a quarter of the width; half of that gives 0.1 % (README.md of the
  // scene).
  EXPECT_NEAR(std::log(early / hammer_speed()) / (state.time - early_time) /
                rate,
              1,
              .03);
  EXPECT_LT(hammer_speed(), .3);
  EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 1e-3);
}

TEST(Rigid, DrivenHammerFeelsTheImpedance)
{
  Log            log(nullptr);
  Simulation     simulation(scene("prm/contact/hammer.prm",
                              {"Material hammer/Initial velocity=0, 0, 0",
                                   "Material hammer/Velocity x=2",
                                   "Material hammer/Velocity y=0",
                                   "Material hammer/Velocity z=0"}),
                        log);
  FlushDenormals flush_denormals;
  // Momentum of the bar over time: the force.
  const State &state    = simulation.state();
  const auto   momentum = [&state] {
    double sum = 0;
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      if (state.reference[i][0] >= 0)
        sum += state.mass[i] * state.velocity[i][0];
    return sum;
  };
  double before = 0, time_before = 0;
  while (state.step < simulation.n_steps())
    {
      simulation.step();
      if (state.time > 10e-6 && time_before == 0)
        {
          before      = momentum();
          time_before = state.time;
        }
    }
  EXPECT_NEAR((momentum() - before) / (state.time - time_before) /
                (std::sqrt(density * modulus) * area * speed),
              1,
              .01);
  EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 1e-3);
  EXPECT_GT(simulation.energy_ledger().energies()["loads"], 0);
}

TEST(Rigid, GrazingBodiesKeepTheirMomenta)
{
  Log            log(nullptr);
  Simulation     simulation(scene("tests/scenes/rigid_collision.prm"), log);
  FlushDenormals flush_denormals;
  const State   &state = simulation.state();
  struct Momenta
  {
    Vector3<double> linear{}, angular{}, of_missile{};
  };
  const auto momenta = [&state] {
    Momenta sum;
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      {
        const Vector3<double> p = state.mass[i] * state.velocity[i].vector();
        sum.linear += p;
        sum.angular += cross(state.position(i), p);
        if (state.reference[i][0] < 0)
          sum.of_missile += p;
      }
    return sum;
  };
  const Momenta start = momenta();
  while (state.step < simulation.n_steps())
    {
      simulation.step();
      const Momenta now = momenta();
      ASSERT_LT(norm(now.linear - start.linear), 1e-12 * norm(start.linear));
      ASSERT_LT(norm(now.angular - start.angular), 1e-12 * norm(start.angular));
    }
  // It has been turned aside.
  const Vector3<double> end = momenta().of_missile;
  EXPECT_GT(norm(end - start.of_missile), .1 * norm(start.of_missile));
  EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 5e-4);
}
