// Scenes of prm/contact against their closed solutions.

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace rift;

namespace
{
  Parameters
  scene(const std::string &name, const std::vector<std::string> &overrides = {})
  {
    return read_parameters(RIFT_SOURCE_DIRECTORY "/prm/contact/" + name,
                           overrides);
  }

  /** Momentum, kg m/s, and mass, kg, of the nodes for which `belongs` holds of
   * their place in the undeformed body. */
  template <typename Function>
  std::pair<Vector3<double>, double>
  momentum(const State &state, const Function &belongs)
  {
    Vector3<double> sum{};
    double          mass = 0;
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      if (belongs(state.reference[i].vector()))
        {
          sum += state.mass[i] * state.velocity[i].vector();
          mass += state.mass[i];
        }
    return {sum, mass};
  }
} // namespace

TEST(Contact, TwoBarsExchangeTheirVelocities)
{
  const double          length = .1, gap = 1e-6, speed = 2;
  const Vector3<double> start = {{speed, 0, 0}};
  const double          c     = std::sqrt(50e9 / 2700);

  Log            log(nullptr);
  Simulation     simulation(scene("bars.prm"), log);
  FlushDenormals flush_denormals;
  const State   &state     = simulation.state();
  const auto     is_hammer = [&](const Vector3<double> &x) {
    return x[0] < length + gap / 2;
  };
  const auto is_anvil = [&](const Vector3<double> &x) { return !is_hammer(x); };
  const double    mass   = momentum(state, is_hammer).second;
  Vector3<double> before = momentum(state, is_hammer).first;
  double          first = 0, last = 0, worst = 0;
  while (state.step < simulation.n_steps())
    {
      simulation.step();
      const Vector3<double> now   = momentum(state, is_hammer).first;
      const Vector3<double> whole = now + momentum(state, is_anvil).first;
      worst                       = std::max(worst, norm(whole - mass * start));
      // In touch: the force is a tenth of that between the bars or more.
      const double force = (before[0] - now[0]) / simulation.time_step();
      if (force > .1 * .5 * 2700 * c * speed * 1e-4)
        {
          first = first > 0 ? first : state.time;
          last  = state.time;
        }
      before = now;
    }
  EXPECT_NEAR((last - first) / (2 * length / c), 1, .02);
  EXPECT_NEAR(momentum(state, is_hammer).first[0] / (mass * speed), 0, .02);
  EXPECT_NEAR(momentum(state, is_anvil).first[0] / (mass * speed), 1, .02);
  EXPECT_LT(worst, 1e-12 * mass * speed);
  EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 1e-3);
}

TEST(Contact, SlidingBlockStopsWhereItShould)
{
  Log            log(nullptr);
  Simulation     simulation(scene("block.prm"), log);
  FlushDenormals flush_denormals;
  const State   &state = simulation.state();
  const auto is_block  = [](const Vector3<double> &x) { return x[2] > 1e-6; };
  const auto way       = [&] {
    double sum = 0, mass = 0;
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      if (is_block(state.reference[i].vector()))
        {
          sum += state.mass[i] * state.displacement[i][0];
          mass += state.mass[i];
        }
    return sum / mass;
  };
  // v / (mu g) = 0.4 ms; then it stands still.
  double at_stop = 0;
  while (state.step < simulation.n_steps())
    {
      simulation.step();
      if (at_stop == 0 && state.time > .5e-3)
        at_stop = way();
    }
  EXPECT_NEAR(at_stop / .4e-3, 1, .01);
  EXPECT_NEAR(way() / .4e-3, 1, .01);
  EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 2e-3);
  // All of its energy has gone into friction but for a little.
  const Energies energies = simulation.energy_ledger().energies();
  EXPECT_NEAR(energies.friction / (.5 * 2700 * 4e-6 * 4), 1, .03);
}
