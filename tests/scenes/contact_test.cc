// Scenes of prm/contact against their closed solutions.

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace rift;

namespace
{
  Parameters
  scene(const std::string &name, const std::vector<std::string> &overrides = {})
  {
    return read_parameters(RIFT_SOURCE_DIRECTORY "/prm/contact/" + name,
                           overrides);
  }

  /** Mean displacement, m, weighted by mass, of the nodes for which `belongs`
   * holds of their place in the undeformed body. */
  template <typename Function>
  Vector3<double>
  mean_displacement(const State &state, const Function &belongs)
  {
    Vector3<double> sum{};
    double          mass = 0;
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      if (belongs(state.reference[i].vector()))
        {
          sum += state.mass[i] * state.displacement[i].vector();
          mass += state.mass[i];
        }
    return (1 / mass) * sum;
  }

  /** Momentum, kg m/s, and mass, kg, of such nodes. */
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
  /** What a collision of the two spheres of spheres.prm came to. */
  struct Collision
  {
    /** s and N, over those of Hertz. */
    double duration, force;

    /** Speeds after over before. */
    double restitution;
  };

  Collision
  collide(const std::string &element_size)
  {
    // Hertz: E* = E / (2 (1 - nu^2)), R* = R / 2, m* = m / 2.
    const double speed = 10, radius = .01, density = 2700;
    const double modulus = 50e9 / (2 * (1 - .04));
    Log          log(nullptr);
    Simulation   simulation(
      scene("spheres.prm", {"Mesh/Element size=" + element_size}),
      log);
    FlushDenormals flush_denormals;
    const State   &state   = simulation.state();
    const auto     is_left = [](const Vector3<double> &x) { return x[0] < 0; };
    const double   mass    = momentum(state, is_left).second;
    EXPECT_NEAR(mass / (density * 4. / 3 * M_PI * std::pow(radius, 3)), 1, .04);
    const double depth = std::pow(15 * mass / 2 * speed * speed /
                                    (16 * modulus * std::sqrt(radius / 2)),
                                  .4);
    const double largest =
      4. / 3 * modulus * std::sqrt(radius / 2) * std::pow(depth, 1.5);

    double       first = 0, last = 0, peak = 0;
    const double start  = momentum(state, is_left).first[0];
    double       before = start;
    while (state.step < simulation.n_steps())
      {
        simulation.step();
        const double now   = momentum(state, is_left).first[0];
        const double force = (before - now) / simulation.time_step();
        if (force > 1e-3 * largest)
          {
            first = first > 0 ? first : state.time;
            last  = state.time;
          }
        peak   = std::max(peak, force);
        before = now;
      }
    EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 1e-3);
    return {(last - first) / (2.94 * depth / speed),
            peak / largest,
            -before / start};
  }

  void
  expect_hertz(const std::string &element_size,
               const double       tolerance_of_duration,
               const double       tolerance_of_force)
  {
    const Collision collision = collide(element_size);
    std::printf("%s m: duration %.4f, force %.4f, restitution %.5f\n",
                element_size.c_str(),
                collision.duration,
                collision.force,
                collision.restitution);
    EXPECT_NEAR(collision.duration, 1, tolerance_of_duration);
    EXPECT_NEAR(collision.force, 1, tolerance_of_force);
    EXPECT_GT(collision.restitution, .98);
    EXPECT_LT(collision.restitution, 1);
  }
} // namespace

TEST(Contact, SpheresCollideAfterHertz)
{
  // The radius of the contact is that of one element.
  expect_hertz("0.8e-3", .2, .2);
}

TEST(Contact, SpheresCollideAfterHertzOnFinerMeshes)
{
  expect_hertz("0.4e-3", .05, .05);
  expect_hertz("0.2e-3", .05, .05);
}

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
  EXPECT_NEAR(at_stop / .4e-3, 1, 1e-3);
  EXPECT_NEAR(way() / .4e-3, 1, 1e-3);
  EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 2e-3);
  // All of its energy has gone into friction but for a little.
  const Energies energies = simulation.energy_ledger().energies();
  EXPECT_NEAR(energies["friction"] / (.5 * 2700 * 4e-6 * 4), 1, .03);
}

// On a plane inclined by 20 or 35 degrees, the coefficient of friction being
// 0.5 (26.6 degrees). Viscosity brings what swings at the start to rest.
TEST(Contact, BlockOnAnInclineStaysOrSlides)
{
  for (const double degrees : {20., 35.})
    {
      const double angle = degrees * M_PI / 180, g = 1e4;
      char         gravity[100];
      std::snprintf(gravity,
                    sizeof gravity,
                    "Body force/Gravity=%.15g, 0, %.15g",
                    g * std::sin(angle),
                    -g * std::cos(angle));
      Log              log(nullptr);
      const Parameters slope = scene("block.prm",
                                     {gravity,
                                      "Material block/Initial velocity=0, 0, 0",
                                      "Material block/Viscosity=4e4",
                                      "Material table/Viscosity=4e4",
                                      "Mesh/Element size=1e-2",
                                      "Time/End time=0.5e-3"});
      Simulation       simulation(slope, log);
      FlushDenormals   flush_denormals;
      const State     &state = simulation.state();
      // Mean displacement of the block at 0.3, 0.4 and 0.5 ms.
      std::vector<double> ways;
      while (state.step < simulation.n_steps())
        {
          simulation.step();
          if (state.time >= (.3 + .1 * ways.size()) * 1e-3 * (1 - 1e-9))
            ways.push_back(
              mean_displacement(state, [](const Vector3<double> &x) {
                return x[2] > 1e-6;
              })[0]);
        }
      ASSERT_EQ(ways.size(), 3U);
      if (degrees < 26)
        // In 0.2 ms under a thousand times the gravity of the earth, less than
        // a millionth of its size.
        EXPECT_LT(std::abs(ways[2] - ways[0]), 1e-6 * .02);
      else
        {
          const double acceleration =
            (ways[2] - 2 * ways[1] + ways[0]) / (1e-4 * 1e-4);
          EXPECT_NEAR(acceleration /
                        (g * (std::sin(angle) - .5 * std::cos(angle))),
                      1,
                      .01);
        }
    }
}
