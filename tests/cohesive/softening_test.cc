#include <rift/cohesive/laws/softening.h>

#include <gtest/gtest.h>

using namespace rift;

TEST(Softening, TableIsTheFormula)
{
  // As the header promises.
  const Softening softening;
  for (unsigned int i = 0; i <= 100000; ++i)
    {
      const double damage = i / 100000.;
      EXPECT_NEAR(softening(damage).value, Softening::exact(damage), 2e-10);
    }
}

TEST(Softening, ValuesOfTheReference)
{
  // From an independent script, to the four digits that it prints.
  const double values[11] =
    {1, .8783, .6784, .5096, .3890, .3041, .2382, .1791, .1208, .0611, 0};
  const Softening softening;
  for (unsigned int i = 0; i <= 10; ++i)
    {
      EXPECT_NEAR(softening(i / 10.).value, values[i], 5e-5);
      EXPECT_NEAR(Softening::exact(i / 10.), values[i], 5e-5);
    }
  EXPECT_NEAR(softening(0.).value, 1, 1e-14);
  EXPECT_NEAR(softening(1.).value, 0, 1e-14);
  EXPECT_NEAR(softening(0.).slope, 0, 1e-12);
}

TEST(Softening, IntegralIsThatOfTheFormula)
{
  // Simpson's rule, exact here to rounding.
  const unsigned int n = 2000;
  const Softening    softening;
  double             formula = 0, table = 0;
  for (unsigned int i = 0; i <= n; ++i)
    {
      const double damage = static_cast<double>(i) / n;
      const double weight = (i == 0 || i == n ? 1. : i % 2 == 1 ? 4. : 2.) / 3;
      formula += weight / n * Softening::exact(damage);
      table += weight / n * softening(damage).value;
    }
  EXPECT_NEAR(formula, .386307295, 5e-10);
  EXPECT_NEAR(formula, Softening::integral, 1e-11);
  EXPECT_NEAR(table, Softening::integral, 1e-9);
  EXPECT_NEAR(1 / Softening::integral, 2.588613, 5e-7);
}

TEST(Softening, SlopeIsTheDerivativeAndNeverSteeper)
{
  const Softening softening;
  const double    h        = 1e-5;
  double          steepest = 0, at = 0, last = 1;
  for (unsigned int i = 1; i < 10000; ++i)
    {
      const double damage = i / 10000.;
      const double slope  = softening(damage).slope;
      const double difference =
        (Softening::exact(damage + h) - Softening::exact(damage - h)) / (2 * h);
      EXPECT_NEAR(slope, difference, 1e-6);
      if (-slope > steepest)
        {
          steepest = -slope;
          at       = damage;
        }
      // It falls without pause.
      EXPECT_LT(softening(damage).value, last);
      last = softening(damage).value;
    }
  EXPECT_LE(steepest, Softening::steepest_slope);
  EXPECT_NEAR(steepest, Softening::steepest_slope, 1e-4);
  EXPECT_NEAR(at, .145, 1e-3);
}

TEST(Softening, LanesAreLikeNumbers)
{
  const Softening softening;
  for (unsigned int i = 0; i < 1000; ++i)
    {
      Simd damage;
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        damage[lane] = (i + lane / 8.) / 999.875;
      const auto lanes = softening(damage);
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        {
          const double one = damage[lane];
          EXPECT_NEAR(lanes.value[lane], softening(one).value, 1e-14);
          EXPECT_NEAR(lanes.slope[lane], softening(one).slope, 1e-12);
        }
    }
}
