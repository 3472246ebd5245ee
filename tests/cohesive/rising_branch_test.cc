#include "law_specimen.h"
#include <gtest/gtest.h>

#include <random>

using namespace rift;
using namespace rift::test;

// The law of the intrinsic model, against its formulas (doc/theory.md, eqs. 14
// and 14b).
namespace
{
  using Intrinsic = BranchSpecimen<ParabolicBranch>;

  const double peak_opening = 2 * strength.tensile_strength / stiffness;
  const double peak_slip    = 2 * strength.cohesion / stiffness;

  double
  parabola(const double x)
  {
    return 2 * x - x * x;
  }
} // namespace

TEST(RisingBranch, IsTheParabolaInOpeningAndALineInCompression)
{
  Intrinsic specimen;
  for (const double x : {1e-6, .1, .5, .9, .999, .3, -.2, -5., 1e-3})
    {
      specimen.step_to({{x * peak_opening, 0, 0}});
      EXPECT_NEAR(specimen.point.traction[0],
                  strength.tensile_strength * (x > 0 ? parabola(x) : 2 * x),
                  1e-12 * strength.tensile_strength * std::abs(x));
    }
  EXPECT_EQ(specimen.point.softening, 1);
  EXPECT_EQ(specimen.fracture, 0);
}

// The parabola up to the cohesion, whatever the pressure; what friction adds is
// straight.
TEST(RisingBranch, ShearRisesToCohesionAndFriction)
{
  for (const double pressure : {0., 20e6})
    {
      const double friction = strength.tan_friction_angle * pressure;
      Intrinsic    specimen;
      const auto   expect_shear = [&](const double slip, const double shear) {
        specimen.step_to({{-pressure / stiffness, .6 * slip, -.8 * slip}});
        EXPECT_NEAR(specimen.point.traction[1], .6 * shear, 1e-9 * shear);
        EXPECT_NEAR(specimen.point.traction[2], -.8 * shear, 1e-9 * shear);
        EXPECT_EQ(specimen.point.softening, 1);
      };
      for (const double x : {1e-4, .1, .5, .99})
        expect_shear(x * peak_slip, strength.cohesion * parabola(x));
      if (pressure > 0)
        expect_shear(peak_slip + .9 * friction / stiffness,
                     strength.cohesion + .9 * friction);
      specimen.step_to(
        {{-pressure / stiffness,
          .6 * (peak_slip + 1.2 * friction / stiffness + 1e-7),
          -.8 * (peak_slip + 1.2 * friction / stiffness + 1e-7)}});
      EXPECT_LT(specimen.point.softening, 1);
      EXPECT_NEAR(specimen.shear(),
                  specimen.point.softening * strength.cohesion + friction,
                  1e-9 * strength.cohesion);
    }
}

TEST(RisingBranch, SoftensOverTheJumpBeyondThePeak)
{
  Intrinsic opening, sliding;
  for (unsigned int i = 1; i < 1000; ++i)
    {
      const double f = Softening::exact(i / 1000.);
      opening.step_to({{peak_opening + i / 1000. * full_opening, 0, 0}});
      sliding.step_to({{0, 0, peak_slip + i / 1000. * full_slip}});
      EXPECT_NEAR(opening.point.traction[0],
                  f * strength.tensile_strength,
                  1e-8 * strength.tensile_strength);
      EXPECT_NEAR(sliding.shear(),
                  f * strength.cohesion,
                  1e-8 * strength.cohesion);
    }
}

// As in the literature: the fracture energy and 2/3 of strength times jump at
// the peak.
TEST(RisingBranch, SeparationTakesTheFractureEnergyAndThatOfTheBranch)
{
  Intrinsic    opening, sliding;
  const double of_opening = strength.fracture_energy_1 +
                            2. / 3. * peak_opening * strength.tensile_strength;
  const double of_sliding =
    strength.fracture_energy_2 + 2. / 3. * peak_slip * strength.cohesion;
  opening.go_to({{1.2 * full_opening + peak_opening, 0, 0}}, 40000);
  sliding.go_to({{0, 1.2 * full_slip + peak_slip, 0}}, 40000);
  EXPECT_EQ(opening.point.softening, 0);
  EXPECT_EQ(sliding.point.softening, 0);
  EXPECT_NEAR(opening.work, of_opening, 1e-5 * of_opening);
  EXPECT_NEAR(sliding.work, of_sliding, 1e-5 * of_sliding);
  // What the ledger books is the work.
  EXPECT_NEAR(opening.fracture, of_opening, 1e-3 * of_opening);
  EXPECT_NEAR(sliding.fracture, of_sliding, 1e-3 * of_sliding);
  EXPECT_EQ(opening.friction, 0);
}

TEST(RisingBranch, UnloadingFollowsTheBranchThatIsLeft)
{
  Intrinsic specimen;
  specimen.go_to({{.4 * full_opening, 0, 0}}, 5000);
  const double peak     = specimen.point.traction[0];
  const double jump     = specimen.jump[0];
  const double fracture = specimen.fracture;
  EXPECT_LT(peak, .6 * strength.tensile_strength);
  for (const double x : {.9, .2, .7, 0.})
    {
      specimen.step_to({{jump - (1 - x) * 2 * peak / stiffness, 0, 0}});
      EXPECT_NEAR(specimen.point.traction[0], peak * parabola(x), 1e-6 * peak);
    }
  specimen.step_to({{specimen.jump[0] - 1e-8, 0, 0}});
  EXPECT_NEAR(specimen.point.traction[0], -stiffness * 1e-8, 1e-6 * peak);
  EXPECT_EQ(specimen.fracture, fracture);
}

// What the ledger sees: work is elastic energy and what has been used up, also
// where the pressure changes while the face slips.
TEST(RisingBranch, WorkIsBalancedOnRandomPaths)
{
  std::mt19937                           random(11);
  std::uniform_real_distribution<double> value(-1, 1);
  unsigned int n_damaged = 0, n_failed = 0, n_frictional = 0;
  for (unsigned int sample = 0; sample < 100; ++sample)
    {
      Intrinsic specimen;
      for (unsigned int leg = 0; leg < 6; ++leg)
        specimen.go_to({{.2 * full_opening * value(random),
                         .4 * full_slip * value(random),
                         .4 * full_slip * value(random)}},
                       20000);
      n_damaged += specimen.point.softening < .9;
      n_failed += specimen.point.softening == 0;
      n_frictional += specimen.friction > 1;
      EXPECT_GE(specimen.friction, 0);
      EXPECT_NEAR(specimen.work,
                  specimen.fracture + specimen.friction +
                    specimen.elastic_energy(),
                  2e-3 * specimen.work);
    }
  EXPECT_GT(n_damaged, 50u);
  EXPECT_GT(n_frictional, 50u);
  EXPECT_LT(n_failed, 100u);
}

// Slip under little pressure and back under much: no energy comes of it.
TEST(RisingBranch, ElasticCyclesUnderChangingPressureGiveNothing)
{
  for (const double slip : {.5 * peak_slip, 1.2 * peak_slip})
    {
      Intrinsic    specimen;
      const double low = -20e6 / stiffness, high = -100e6 / stiffness;
      specimen.go_to({{low, 0, 0}}, 1000);
      const double start = specimen.work;
      specimen.go_to({{low, slip, 0}}, 10000);
      specimen.go_to({{high, slip, 0}}, 1000);
      specimen.go_to({{high, 0, 0}}, 10000);
      specimen.go_to({{low, 0, 0}}, 1000);
      EXPECT_EQ(specimen.point.softening, 1);
      EXPECT_NEAR(specimen.work, start, 1e-6 * strength.fracture_energy_2);
    }
}

TEST(RisingBranch, EnergyOfTinyTractionsIsThatOfTheStartOfTheBranch)
{
  for (const double share : {1e-20, 1e-8})
    {
      Intrinsic    specimen;
      const double jump = share * strength.tensile_strength / stiffness;
      specimen.step_to({{jump, 0, 0}});
      EXPECT_NEAR(specimen.elastic_energy(),
                  .5 * stiffness * jump * jump,
                  1e-7 * stiffness * jump * jump);
    }
}

TEST(RisingBranch, AnIntactPointNeedsNoMemory)
{
  std::mt19937                           random(12);
  std::uniform_real_distribution<double> value(-1, 1);
  const MohrCoulomb<ParabolicBranch>     law;
  const auto   constants = law.make_constants(strength, stiffness);
  unsigned int n_yields  = 0;
  for (unsigned int i = 0; i < 10000; ++i)
    {
      const Vector jump  = {{1.2 * peak_opening * value(random),
                             .8 * peak_slip * value(random),
                             .8 * peak_slip * value(random)}};
      auto         point = law.make_point(strength, constants);
      bool         yields;
      const auto   traction = law.intact_traction(constants, jump, yields);
      law.update(point, constants, jump);
      EXPECT_EQ(yields, point.softening < 1 || point.opening + point.slip > 0);
      n_yields += yields;
      for (unsigned int d = 0; d < 3 && !yields; ++d)
        EXPECT_EQ(traction[d], point.traction[d]);
    }
  EXPECT_GT(n_yields, 500u);
  EXPECT_LT(n_yields, 9000u);
}
