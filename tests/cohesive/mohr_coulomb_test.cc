#include "law_specimen.h"
#include <gtest/gtest.h>

#include <random>

using namespace rift;
using namespace rift::test;

TEST(MohrCoulomb, UnloadingAndReloadingFollowTheSlope)
{
  for (const double share : {.1, .4, .8})
    {
      Specimen specimen;
      specimen.go_to({{share * full_opening, .1 * full_slip, 0}}, 5000);
      const Vector jump = specimen.jump, traction = specimen.point.traction;
      const double softening = specimen.point.softening;
      const double fracture  = specimen.fracture;
      const double back      = .5 * traction[0] / stiffness;
      for (const double way : {.25, 1., .5, 0.})
        {
          specimen.step_to(jump - Vector{{way * back, way * back, 0}});
          for (unsigned int d = 0; d < 2; ++d)
            EXPECT_NEAR(specimen.point.traction[d],
                        traction[d] - stiffness * way * back,
                        1e-12 * strength.cohesion);
        }
      EXPECT_EQ(specimen.fracture, fracture);
      EXPECT_EQ(specimen.point.softening, softening);
    }
}

TEST(MohrCoulomb, TractionStaysInsideTheEnvelope)
{
  std::mt19937                           random(5);
  Specimen                               specimen;
  double                                 last = 1;
  std::uniform_real_distribution<double> value(-1, 1);
  for (unsigned int i = 0; i < 100000; ++i)
    {
      specimen.step_to(specimen.jump +
                       (.01 * full_opening) *
                         Vector{{value(random), value(random), value(random)}});
      const auto &p = specimen.point;
      EXPECT_LE(p.softening, last);
      last = p.softening;
      ASSERT_LE(p.traction[0],
                p.softening * strength.tensile_strength +
                  1e-7 * strength.tensile_strength);
      ASSERT_LE(specimen.shear(),
                p.softening * strength.cohesion +
                  strength.tan_friction_angle * std::max(-p.traction[0], 0.) +
                  1e-7 * strength.cohesion);
      const double damage = std::hypot(p.opening, p.slip);
      ASSERT_NEAR(p.softening,
                  damage >= 1 ? 0 : Softening::exact(damage),
                  1e-6);
    }
  EXPECT_EQ(last, 0);
}

TEST(MohrCoulomb, ExcessFallsToTheStrength)
{
  Specimen     specimen;
  const double excess = .2 * strength.tensile_strength;
  specimen.hold({{strength.tensile_strength + excess, 0, 0}});
  EXPECT_NEAR(specimen.point.normal_excess, excess, 1e-6);

  // The envelope falls by k/3 of the irreversible opening, which is what the
  // whole opening and the falling elastic part add up to: together by k/2.
  const double small = 1e-3 * excess / stiffness;
  specimen.step_to({{small, 0, 0}});
  EXPECT_NEAR(
    (strength.tensile_strength + excess - specimen.point.traction[0]) / small,
    stiffness / 2,
    1e-3 * stiffness);
  double last = specimen.point.traction[0];
  for (unsigned int i = 1; i <= 100; ++i)
    {
      specimen.step_to({{i * .021 * excess / stiffness, 0, 0}});
      EXPECT_LT(specimen.point.traction[0], last);
      last = specimen.point.traction[0];
    }
  EXPECT_EQ(specimen.point.normal_excess, 0);
  EXPECT_LE(last, strength.tensile_strength);

  Specimen sliding;
  sliding.hold({{0, 0, -1.2 * strength.cohesion}});
  EXPECT_NEAR(sliding.point.shear_excess, .2 * strength.cohesion, 1e-6);
  sliding.go_to({{0, 0, -.5 * strength.cohesion / stiffness}}, 100);
  EXPECT_EQ(sliding.point.shear_excess, 0);
  EXPECT_LE(sliding.shear(), strength.cohesion);
}

TEST(MohrCoulomb, FrictionDoesNotFadeWithDamage)
{
  const double pressure = 10e6, tan = strength.tan_friction_angle;
  for (const double share : {.2, .5, 2.})
    {
      Specimen specimen;
      specimen.go_to({{share * full_opening, 0, 0}}, 5000);
      const double f = specimen.point.softening;
      specimen.go_to({{specimen.point.offset[0] - pressure / stiffness, 0, 0}},
                     1000);
      EXPECT_NEAR(specimen.point.traction[0], -pressure, 1e-6 * pressure);
      EXPECT_EQ(specimen.point.softening, f);

      // Just until it slides: more would soften the cohesion.
      specimen.go_to(
        {{specimen.jump[0],
          (f * strength.cohesion + tan * pressure) / stiffness * 1.0001,
          0}},
        100000);
      EXPECT_NEAR(specimen.shear(),
                  specimen.point.softening * strength.cohesion + tan * pressure,
                  1e-6 * strength.cohesion);
      EXPECT_GE(specimen.shear(),
                .999 * (f * strength.cohesion + tan * pressure));

      // And to the end.
      const double friction = specimen.friction;
      specimen.go_to({{specimen.jump[0], 2 * full_slip, 0}}, 10000);
      const double from = specimen.jump[1];
      EXPECT_EQ(specimen.point.softening, 0);
      EXPECT_NEAR(specimen.shear(), tan * pressure, 1e-9 * pressure);
      const double before = specimen.friction;
      EXPECT_GT(before, friction);
      specimen.go_to({{specimen.jump[0], from - 2 * full_slip, 0}}, 10000);
      // Back: first the elastic branch is turned round.
      EXPECT_NEAR(specimen.friction - before,
                  tan * pressure *
                    (2 * full_slip - 2 * tan * pressure / stiffness),
                  1e-3 * tan * pressure * full_slip);
    }
}

// On the way, the shear is f C + mu(f) p. What slides is the slip beyond the
// envelope and what the elastic branch gives back, (1 - f) (C + fading p)/k,
// so that the integral of f over it is I s_t + (C + fading p)/(2 k).
TEST(MohrCoulomb, FrictionFadesToTheResidual)
{
  const double pressure = 50e6, cohesion = strength.cohesion;
  for (const double residual : {0., .5})
    {
      Specimen specimen;
      specimen.constants.residual_friction = residual;
      const double fading = strength.tan_friction_angle - residual;
      specimen.go_to({{-pressure / stiffness, 0, 0}}, 10);
      double least_softening = 1;
      for (unsigned int i = 1; i <= 40000; ++i)
        {
          specimen.step_to(
            {{-pressure / stiffness, i * 1.5e-4 * full_slip, 0}});
          const auto &p     = specimen.point;
          least_softening   = std::min(least_softening, p.softening);
          const double peak = p.softening * cohesion +
                              (residual + fading * p.softening) * pressure;
          ASSERT_LE(specimen.shear(), peak * (1 + 1e-9));
          if (p.softening < 1)
            {
              ASSERT_NEAR(specimen.shear(), peak, 1e-9 * cohesion);
            }
        }
      EXPECT_EQ(least_softening, 0);
      EXPECT_NEAR(specimen.shear(), residual * pressure, 1e-9 * pressure);

      const double slip = specimen.point.offset[1];
      const double part = Softening::integral * full_slip +
                          .5 * (cohesion + fading * pressure) / stiffness;
      EXPECT_NEAR(specimen.fracture, cohesion * part, 1e-3 * cohesion * part);
      const double friction = pressure * (residual * slip + fading * part);
      EXPECT_NEAR(specimen.friction, friction, 1e-3 * friction);
      EXPECT_NEAR(specimen.work - .5 * pressure * pressure / stiffness,
                  specimen.fracture + specimen.friction +
                    .5 * std::pow(residual * pressure, 2) / stiffness,
                  1e-9 * specimen.work);
    }
}

TEST(MohrCoulomb, FailedPointClosesWhereItWasCut)
{
  Specimen specimen;
  specimen.go_to({{2 * full_opening, .3 * full_slip, 0}}, 5000);
  EXPECT_EQ(specimen.point.softening, 0);
  for (const double opening : {1e-6, 1e-12})
    {
      specimen.step_to({{opening, .3 * full_slip, 0}});
      EXPECT_EQ(specimen.point.traction[0], 0);
    }
  for (const double overlap : {1e-12, 1e-9, 1e-7})
    {
      specimen.step_to({{-overlap, .3 * full_slip, 0}});
      EXPECT_NEAR(specimen.point.traction[0],
                  -stiffness * overlap,
                  1e-12 * stiffness * overlap);
    }
  specimen.step_to({{1e-12, .3 * full_slip, 0}});
  EXPECT_EQ(specimen.point.traction[0], 0);
}
