// Contact of two tetrahedra: energy on closed paths, initial overlap,
// Coulomb's friction, damping.

#include "../support/single_pair.h"
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace rift;
using namespace rift::test;

namespace
{
  constexpr double penalty = 2e9;

  const ContactConstants smooth = {penalty, 0, 0, 1};

  /** A tetrahedron between an equilateral triangle and a tip. */
  Tetrahedron
  pyramid(const double radius, const double height)
  {
    const double x = -radius / 2, y = radius * std::sqrt(.75);
    if (height > 0)
      return {{{{radius, 0, 0}}, {{x, y, 0}}, {{x, -y, 0}}, {{0, 0, height}}}};
    return {{{{radius, 0, 0}}, {{x, -y, 0}}, {{x, y, 0}}, {{0, 0, height}}}};
  }

  // The face of a small one upon that of a large one.
  const Tetrahedron lower = pyramid(2, -2), upper = pyramid(.7, .7);

  CellMotion
  at_rest(const Tetrahedron &positions)
  {
    return {positions, {}};
  }

  CellMotion
  moving(Tetrahedron            positions,
         const Vector3<double> &shift,
         const Vector3<double> &velocity)
  {
    for (auto &x : positions)
      x += shift;
    CellMotion motion{positions, {}};
    motion.velocities.fill(velocity);
    return motion;
  }

  Vector3<double>
  sum(const NodalVector (&forces)[4])
  {
    Vector3<double> total{};
    for (const NodalVector &f : forces)
      total += f.vector();
    return total;
  }

  /** Corners of both on a closed path, s from 0 to 1. */
  std::array<Tetrahedron, 2>
  on_path(const std::array<Tetrahedron, 2> &amplitudes,
          const bool                        is_rigid,
          const double                      s)
  {
    std::array<Tetrahedron, 2> pair = {{lower, upper}};
    const double one = std::sin(2 * M_PI * s), two = 1 - std::cos(2 * M_PI * s);
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int c = 0; c < 4; ++c)
        for (unsigned int d = 0; d < 3; ++d)
          pair[k][c][d] += .1 * (one * amplitudes[k][is_rigid ? 0 : c][d] +
                                 two * amplitudes[k][is_rigid ? 1 : 3 - c][d]);
    // Apart at the start, and in each other most of the time; a corner first,
    // so that the force begins smoothly.
    for (unsigned int c = 0; c < 4; ++c)
      pair[1][c][2] += .02 - .4 * std::sin(M_PI * s) + .05 * c;
    return pair;
  }
} // namespace

TEST(ContactPair, GivesBackTheWorkOnClosedPaths)
{
  std::mt19937                     engine(3);
  std::normal_distribution<double> normal;
  for (unsigned int path = 0; path < 6; ++path)
    {
      const bool                 is_rigid = path % 2 == 0;
      std::array<Tetrahedron, 2> amplitudes{};
      for (auto &t : amplitudes)
        for (auto &x : t)
          for (double &v : x)
            v = normal(engine);
      constexpr unsigned int n = 40000;
      ContactMemory          memory;
      double                 work = 0, largest = 0;
      // Simpson's rule over each pair of steps.
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double h    = 1. / n;
          const auto   here = on_path(amplitudes, is_rigid, i * h);
          const auto   forces =
            pair_forces(at_rest(here[0]), at_rest(here[1]), smooth, 0, memory);
          largest             = std::max(largest, forces.energy);
          const auto   before = on_path(amplitudes, is_rigid, i * h - 1e-4);
          const auto   after  = on_path(amplitudes, is_rigid, i * h + 1e-4);
          const auto   far_b  = on_path(amplitudes, is_rigid, i * h - 2e-4);
          const auto   far_a  = on_path(amplitudes, is_rigid, i * h + 2e-4);
          const double weight =
            (i == 0 || i == n ? 1 : (i % 2 == 1 ? 4 : 2)) * h / 3;
          for (unsigned int k = 0; k < 2; ++k)
            for (unsigned int c = 0; c < 4; ++c)
              work +=
                weight * dot((k == 0 ? forces.on_a : forces.on_b)[c].vector(),
                             (1 / 12e-4) * (8. * (after[k][c] - before[k][c]) -
                                            (far_a[k][c] - far_b[k][c])));
        }
      EXPECT_GT(largest, 1e-3 * penalty);
      EXPECT_LT(std::abs(work), 1e-10 * largest) << path;
      EXPECT_EQ(memory.initial_potential, 0);
    }
}

TEST(ContactPair, BornWithAnOverlapStartsWithoutForceAndEnergy)
{
  const auto at_depth = [](const double depth) {
    return moving(upper, {{0, 0, -depth}}, {});
  };
  ContactMemory memory;
  memory.initial_potential = overlap(lower, at_depth(.1).positions).potential;
  const auto energy_at     = [&](const double depth) {
    return pair_forces(at_rest(lower), at_depth(depth), smooth, 0, memory);
  };
  EXPECT_EQ(energy_at(.1).energy, 0);
  EXPECT_EQ(norm(sum(energy_at(.1).on_a)), 0);

  // Deeper: from zero on, and always the derivative of the energy.
  const double h = 1e-6;
  for (const double depth : {.1 + 2 * h, .11, .15, .3})
    {
      const double slope =
        (energy_at(depth + h).energy - energy_at(depth - h).energy) / (2 * h);
      EXPECT_NEAR(sum(energy_at(depth).on_b)[2] / slope, 1, 1e-4) << depth;
    }
  EXPECT_LT(energy_at(.1 + h).energy, 1e-8 * energy_at(.3).energy);

  // Apart and in again: an ordinary pair.
  energy_at(-.1);
  ContactMemory fresh;
  EXPECT_EQ(energy_at(.1).energy,
            pair_forces(at_rest(lower), at_depth(.1), smooth, 0, fresh).energy);
}

TEST(ContactPair, BornWithAnOverlapIsNoStifferThanAnyOther)
{
  const auto at_depth = [](const double depth) {
    return moving(upper, {{0, 0, -depth}}, {});
  };
  const auto stiffness_at = [&](const double depth, const double initial) {
    const auto force_at = [&](const double at) {
      ContactMemory memory;
      memory.initial_potential = initial;
      return sum(
        pair_forces(at_rest(lower), at_depth(at), smooth, 0, memory).on_b)[2];
    };
    const double h = 1e-6;
    return (force_at(depth + h) - force_at(depth - h)) / (2 * h);
  };
  const double initial = overlap(lower, at_depth(.01).positions).potential;
  const double other   = stiffness_at(1e-4, 0);
  for (const double depth : {.0101, .012, .0173, .02, .03, .1})
    {
      EXPECT_LT(stiffness_at(depth, initial), other) << depth;
      EXPECT_GT(stiffness_at(depth, initial), .1 * other) << depth;
    }
}

TEST(ContactPair, RubsWithCoulombsForce)
{
  const ContactConstants rough    = {penalty, .5, 0, 1};
  const Vector3<double>  velocity = {{3, 4, 0}};
  const double           dt       = 1e-5;
  ContactMemory          memory;
  double                 loss = 0, work = 0;
  Vector3<double>        force{}, before{};
  const unsigned int     n = 2000;
  for (unsigned int i = 0; i <= n; ++i)
    {
      const auto forces =
        pair_forces(at_rest(lower),
                    moving(upper, {{3 * i * dt, 4 * i * dt, -.01}}, velocity),
                    rough,
                    i > 0 ? dt : 0,
                    memory);
      force = sum(forces.on_b);
      loss += forces.friction_loss;
      if (i > 0)
        work -= .5 * dt * dot(velocity, force + before);
      before = force;
      EXPECT_GE(forces.friction_loss, -1e-9 * penalty);
    }
  // Against the motion, half of the normal force.
  EXPECT_NEAR(force[0] / force[2], -.5 * 3 / 5, 1e-3);
  EXPECT_NEAR(force[1] / force[2], -.5 * 4 / 5, 1e-3);
  // What has been put in along the way is used up but for what the spring and
  // the overlap hold.
  const auto last =
    pair_forces(at_rest(lower),
                moving(upper, {{3 * n * dt, 4 * n * dt, -.01}}, {}),
                rough,
                0,
                memory);
  ContactMemory fresh;
  const double  at_first = pair_forces(at_rest(lower),
                                      moving(upper, {{0, 0, -.01}}, {}),
                                      rough,
                                      0,
                                      fresh)
                            .energy;
  EXPECT_NEAR(loss, work - (last.energy - at_first), .01 * work);
  EXPECT_GT(loss, .9 * work);
}

TEST(ContactPair, SticksWithAForceBelowCoulombs)
{
  const ContactConstants rough = {penalty, .5, 0, 1};
  ContactMemory          memory;
  const auto             shifted = [&](const double shift, const double speed) {
    return pair_forces(at_rest(lower),
                       moving(upper, {{shift, 0, -.01}}, {{speed, 0, 0}}),
                       rough,
                       1e-6,
                       memory);
  };
  shifted(0, 0);
  // There and back: the spring gives back what it got.
  double loss = 0;
  for (int i = 1; i <= 100; ++i)
    loss += shifted(1e-6 * i, 1).friction_loss;
  const double stretched = sum(shifted(1e-4, 0).on_b)[0];
  EXPECT_LT(stretched, 0);
  EXPECT_GT(stretched, -.5 * sum(shifted(1e-4, 0).on_b)[2]);
  for (int i = 99; i >= 0; --i)
    loss += shifted(1e-6 * i, -1).friction_loss;
  EXPECT_NEAR(sum(shifted(0, 0).on_b)[0], 0, 1e-6 * -stretched);
  EXPECT_LT(std::abs(loss), 1e-4 * 1e-4 * -stretched);
}

TEST(ContactPair, ForgetsOverlapThatHasBecomeLess)
{
  const auto at_depth = [](const double depth) {
    return moving(upper, {{0, 0, -depth}}, {});
  };
  const auto potential = [&](const double depth) {
    return overlap(lower, at_depth(depth).positions).potential;
  };
  ContactMemory memory;
  memory.initial_potential = potential(.1);
  pair_forces(at_rest(lower), at_depth(.06), smooth, 0, memory);
  EXPECT_EQ(memory.initial_potential, potential(.06));
  // In again: as a pair that started at .06.
  const double free = potential(.06), now = potential(.1);
  const double energy =
    pair_forces(at_rest(lower), at_depth(.1), smooth, 0, memory).energy;
  EXPECT_NEAR(energy /
                (penalty * std::pow(std::sqrt(now) - std::sqrt(free), 2)),
              1,
              1e-12);
}

// While it is pressed deeper and turned, with friction: what is put in is there
// or used up.
TEST(ContactPair, FrictionKeepsTheBalanceOnAnyPath)
{
  const ContactConstants           rough = {penalty, .5, 0, 1};
  std::mt19937                     engine(5);
  std::normal_distribution<double> normal;
  for (unsigned int path = 0; path < 10; ++path)
    {
      Vector3<double> amplitude{}, phase{};
      for (unsigned int d = 0; d < 3; ++d)
        {
          amplitude[d] = (d < 2 ? .03 : .02) * normal(engine);
          phase[d]     = normal(engine);
        }
      const auto place = [&](const double s) {
        Vector3<double> x{};
        for (unsigned int d = 0; d < 3; ++d)
          x[d] =
            amplitude[d] * (std::sin(6 * s + phase[d]) - std::sin(phase[d]));
        x[2] -= .04 * s;
        return x;
      };
      const unsigned int n  = 20000;
      const double       dt = 1. / n;
      ContactMemory      memory;
      double             work = 0, loss = 0, energy = 0, at_start = 0;
      Vector3<double>    before{};
      for (unsigned int i = 0; i <= n; ++i)
        {
          const Vector3<double> shift =
            i > 0 ? place(i * dt) - place((i - 1) * dt) : Vector3<double>{};
          const auto forces =
            pair_forces(at_rest(lower),
                        moving(upper, place(i * dt), (1 / dt) * shift),
                        rough,
                        i > 0 ? dt : 0,
                        memory);
          const Vector3<double> force = sum(forces.on_b);
          work -= .5 * dot(force + before, shift);
          before = force;
          loss += forces.friction_loss;
          energy = forces.energy;
          if (i == 0)
            at_start = energy;
        }
      EXPECT_GE(loss, -1e-9);
      EXPECT_NEAR(energy - at_start + loss,
                  work,
                  .01 * (std::abs(work) + energy));
    }
}

TEST(ContactPair, TellsOfACellThatIsInsideOfAnother)
{
  // Where the potential of the large one is about zero: at its face.
  Tetrahedron     small = upper;
  Vector3<double> centre{};
  for (const Vector3<double> &x : lower)
    centre += .25 * x;
  for (unsigned int c = 0; c < 4; ++c)
    small[c] = centre + 1e-3 * (upper[c] - upper[0]);
  ContactMemory memory;
  const auto    forces =
    pair_forces(at_rest(lower), at_rest(small), smooth, 0, memory);
  EXPECT_TRUE(forces.is_too_deep);
}

TEST(ContactPair, DampingTakesEnergyAndNeverPulls)
{
  const ContactConstants damped = {penalty, 0, .2, 1e3};
  for (const double speed : {-10., 10., 1e6})
    {
      const auto    above = moving(upper, {{0, 0, -.01}}, {{0, 0, speed}});
      ContactMemory memory, fresh;
      pair_forces(at_rest(lower), above, damped, 0, memory);
      const auto forces =
        pair_forces(at_rest(lower), above, damped, 1e-6, memory);
      const auto elastic =
        pair_forces(at_rest(lower), above, smooth, 1e-6, fresh);
      const double force = sum(elastic.on_b)[2];
      const double added = sum(forces.on_b)[2] - force;
      // -2 zeta sqrt(k m) v, k of flat faces.
      const double stiffness = force * force / (2 * elastic.energy);
      EXPECT_NEAR(added,
                  std::max(-.4 * std::sqrt(stiffness * 1e3) * speed, -force),
                  1e-6 * std::abs(added));
      EXPECT_NEAR(forces.damping_loss,
                  -added * speed * 1e-6,
                  1e-9 * std::abs(added * speed * 1e-6));
    }
}
