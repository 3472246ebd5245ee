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
      EXPECT_NEAR(softening(damage), Softening::exact(damage), 2e-10);
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
      EXPECT_NEAR(softening(i / 10.), values[i], 5e-5);
      EXPECT_NEAR(Softening::exact(i / 10.), values[i], 5e-5);
    }
  EXPECT_NEAR(softening(0.), 1, 1e-14);
  EXPECT_NEAR(softening(1.), 0, 1e-14);
  EXPECT_NEAR(Softening::exact_slope(0.), 0, 1e-12);
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
      table += weight / n * softening(damage);
    }
  EXPECT_NEAR(formula, .386307295, 5e-10);
  EXPECT_NEAR(formula, Softening::integral, 1e-11);
  EXPECT_NEAR(table, Softening::integral, 1e-9);
  EXPECT_NEAR(1 / Softening::integral, 2.588613, 5e-7);
}

TEST(Softening, SlopeIsTheDerivativeAndFallsWithoutPause)
{
  const Softening softening;
  const double    h    = 1e-5;
  double          last = 1;
  for (unsigned int i = 1; i < 10000; ++i)
    {
      const double damage = i / 10000.;
      const double difference =
        (Softening::exact(damage + h) - Softening::exact(damage - h)) / (2 * h);
      EXPECT_NEAR(Softening::exact_slope(damage), difference, 1e-6);
      EXPECT_LT(softening(damage), last);
      last = softening(damage);
    }
}

TEST(Softening, LanesAreLikeNumbers)
{
  const Softening softening;
  for (unsigned int i = 0; i < 1000; ++i)
    {
      Simd damage;
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        damage[lane] = (i + lane / 8.) / 999.875;
      const Simd lanes = softening(damage);
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        {
          const double one = damage[lane];
          EXPECT_NEAR(lanes[lane], softening(one), 1e-14);
        }
    }
}
