#include <rift/rigid/rigid_motion.h>

#include <gtest/gtest.h>

#include <limits>

using namespace rift;

namespace
{
  /** kg m^2, along the axes of the body. */
  RigidMass
  body_with(const Vector3<double> &inertia)
  {
    RigidMass mass;
    mass.mass = 2;
    for (unsigned int d = 0; d < 3; ++d)
      {
        mass.inertia[d][d]         = inertia[d];
        mass.inverse_inertia[d][d] = 1 / inertia[d];
      }
    return mass;
  }

  double
  energy(const RigidMotion &motion, const RigidMass &mass)
  {
    return .5 * dot(motion.angular_momentum, angular_velocity(motion, mass));
  }
} // namespace

TEST(RigidMotion, QuaternionsTurnRightHandedly)
{
  // A third of a turn about (1, 1, 1) takes x to y.
  const double     s     = .5;
  const Quaternion third = {.5, {{s, s, s}}};
  const auto       y     = turned(third, {{1, 0, 0}});
  EXPECT_NEAR(y[0], 0, 1e-15);
  EXPECT_NEAR(y[1], 1, 1e-15);
  const auto z = turned(third * third, {{1, 0, 0}});
  EXPECT_NEAR(z[2], 1, 1e-15);
}

TEST(RigidMotion, SymmetricTopPrecesses)
{
  // Without torque the axis of a symmetric top goes round the angular momentum
  // with |L| / I_1.
  const RigidMass       mass  = body_with({{2, 2, 3}});
  const Vector3<double> axis  = {{0, 0, 1}};
  const double          angle = .4, momentum = 6;
  const auto            error = [&](const unsigned int n_steps) {
    RigidMotion motion;
    motion.angular_momentum = {
      {momentum * std::sin(angle), 0, momentum * std::cos(angle)}};
    const double time = 1.;
    for (unsigned int i = 0; i < n_steps; ++i)
      EXPECT_TRUE(drift(motion, mass, time / n_steps));
    // Rodrigues' formula for the axis.
    const Vector3<double> e = {{std::sin(angle), 0, std::cos(angle)}};
    const double          phi   = momentum / 2 * time;
    const Vector3<double> exact = std::cos(phi) * axis +
                                  std::sin(phi) * cross(e, axis) +
                                  (dot(e, axis) * (1 - std::cos(phi))) * e;
    return norm(turned(motion.rotation, axis) - exact);
  };
  // Second order
  EXPECT_LT(error(1000), 1e-5);
  EXPECT_NEAR(error(1000) / error(2000), 4, .01);
}

TEST(RigidMotion, UnstableTopKeepsItsEnergy)
{
  // About the middle axis: it tumbles for ever.
  const RigidMass mass = body_with({{1, 2, 3}});
  RigidMotion     motion;
  motion.angular_momentum = {{.01, 2, .01}};
  const auto   momentum   = motion.angular_momentum;
  const double start      = energy(motion, mass);
  double       least = start, largest = start;
  double       lowest_y = 1;
  for (unsigned int i = 0; i < 100000; ++i)
    {
      ASSERT_TRUE(drift(motion, mass, .01));
      least    = std::min(least, energy(motion, mass));
      largest  = std::max(largest, energy(motion, mass));
      lowest_y = std::min(lowest_y, turned(motion.rotation, {{0, 1, 0}})[1]);
    }
  EXPECT_EQ(motion.angular_momentum, momentum);
  EXPECT_LT(lowest_y, -.9);
  EXPECT_LT((largest - least) / start, 1e-4);
  EXPECT_NEAR(motion.rotation.real * motion.rotation.real +
                dot(motion.rotation.imaginary, motion.rotation.imaginary),
              1,
              1e-12);
}

TEST(RigidMotion, SlenderRodsTurnInAnyDirection)
{
  // Moments of inertia of 1 to 10,000 about oblique axes.
  const double     s     = .5;
  const Quaternion third = {.5, {{s, s, s}}};
  RigidMass        mass;
  Matrix3<double>  axes;
  for (unsigned int d = 0; d < 3; ++d)
    {
      Vector3<double> unit{};
      unit[d] = 1;
      axes[d] = turned(third * Quaternion{.8, {{.6, 0, 0}}}, unit);
    }
  for (const double ratio : {3., 100., 1e4})
    {
      const Vector3<double> moments = {{1, ratio, .9 * ratio}};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            mass.inertia[i][j] = 0;
            for (unsigned int d = 0; d < 3; ++d)
              mass.inertia[i][j] += moments[d] * axes[d][i] * axes[d][j];
          }
      mass.inverse_inertia = inverse(mass.inertia);
      RigidMotion motion;
      motion.angular_momentum = mass.inertia * Vector3<double>{{.3, -.2, .4}};
      const double start      = energy(motion, mass);
      for (unsigned int i = 0; i < 20000; ++i)
        {
          ASSERT_TRUE(drift(motion, mass, .02)) << ratio << ' ' << i;
          ASSERT_NEAR(energy(motion, mass) / start, 1, 1e-3);
        }
    }
}

TEST(RigidMotion, MovesWithItsVelocity)
{
  RigidMotion motion;
  motion.velocity = {{1, 2, 3}};
  ASSERT_TRUE(drift(motion, body_with({{1, 1, 1}}), .5));
  EXPECT_EQ(displacement_of(motion, {{7, 8, 9}}),
            (Vector3<double>{{.5, 1, 1.5}}));
}

TEST(RigidMotion, TellsWhenItTurnsTooFast)
{
  const RigidMass mass = body_with({{1, 1, 1}});
  RigidMotion     motion;
  motion.angular_momentum = {{0, 0, .8}};
  EXPECT_TRUE(drift(motion, mass, 1));
  motion.angular_momentum = {{0, 0, .9}};
  EXPECT_FALSE(drift(motion, mass, 1));
  motion.angular_momentum = {{0, 0, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_FALSE(drift(motion, mass, 1));
}
