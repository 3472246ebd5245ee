#include <gtest/gtest.h>

#include <rift/material/strength_field.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

using namespace rift;

namespace
{
  constexpr double length = .01;

  double
  deviation_of_weibull(const double modulus)
  {
    const double gamma = std::tgamma(1 + 1 / modulus);
    return std::sqrt(std::tgamma(1 + 2 / modulus) / (gamma * gamma) - 1);
  }

  /** Kolmogorov and Smirnov: beyond 1.95/sqrt(n) in 1 of 1000 samples. */
  template <typename Law>
  double
  distance_to_law(std::vector<double> values, const Law &law)
  {
    std::sort(values.begin(), values.end());
    const double n        = values.size();
    double       distance = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      distance = std::max({distance,
                           std::abs(law(values[i]) - i / n),
                           std::abs(law(values[i]) - (i + 1) / n)});
    return distance;
  }

  double
  mean_of(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.) / values.size();
  }

  /** The weakest of n[0] n[1] n[2] vertices in a cube with edges of 1 m. */
  double
  weakest_vertex(const StrengthField               &field,
                 const std::array<unsigned int, 3> &n)
  {
    double weakest = 1e30;
    for (unsigned int i = 0; i < n[0]; ++i)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int k = 0; k < n[2]; ++k)
          weakest =
            std::min(weakest,
                     field.factor(
                       {{i / (n[0] - 1.), j / (n[1] - 1.), k / (n[2] - 1.)}}));
    return weakest;
  }
} // namespace

TEST(WeibullFactor, IsGreaterThanZero)
{
  constexpr std::uint64_t all       = ~std::uint64_t(0);
  const auto              factor_of = [](const std::uint64_t bits, double m) {
    return weibull_factor(unit_number(bits), m);
  };
  for (const double modulus : {1., 5., 20.})
    {
      for (const std::uint64_t bits : {all, all - (1 << 11), all / 2})
        EXPECT_GT(factor_of(bits, modulus), 0);
      EXPECT_GT(factor_of(0, modulus), 1);
      EXPECT_TRUE(std::isfinite(factor_of(0, modulus)));
      EXPECT_LT(factor_of(all, modulus), factor_of(all / 2, modulus));
    }
}

// At any place, on a point of the lattice or between them: the mean, and the
// whole distribution.
TEST(StrengthField, IsWeibullOfMeanOneAtEachPlace)
{
  constexpr unsigned int n = 2000;
  for (const double modulus : {1.5, 4., 24.})
    for (const Vector3<double> place :
         {Vector3<double>{{0, 0, 0}},
          Vector3<double>{{.25 * length, .25 * length, .25 * length}},
          Vector3<double>{{-123.456, .789, 1e3}}})
      {
        std::vector<double> values;
        for (unsigned int seed = 1; seed <= n; ++seed)
          values.push_back(StrengthField(seed, length, modulus).factor(place));
        EXPECT_NEAR(mean_of(values),
                    1,
                    4 * deviation_of_weibull(modulus) / std::sqrt(n));
        const double gamma = std::tgamma(1 + 1 / modulus);
        EXPECT_LT(distance_to_law(values,
                                  [&](const double w) {
                                    return 1 - std::exp(
                                                 -std::pow(gamma * w, modulus));
                                  }),
                  1.95 / std::sqrt(n));
      }
}

// The same of one field, at places that share no point of the lattice.
TEST(StrengthField, IsWeibullInSpace)
{
  constexpr double    modulus = 6;
  const StrengthField field(1, length, modulus);
  std::vector<double> values;
  for (int i = -9; i < 9; ++i)
    for (int j = -9; j < 9; ++j)
      for (int k = -9; k < 9; ++k)
        values.push_back(field.factor(
          {{3.13 * length * i, 3.13 * length * j, 3.13 * length * k}}));
  const double n = values.size();
  EXPECT_NEAR(mean_of(values),
              1,
              4 * deviation_of_weibull(modulus) / std::sqrt(n));
  const double gamma = std::tgamma(1 + 1 / modulus);
  EXPECT_LT(distance_to_law(values,
                            [&](const double w) {
                              return 1 -
                                     std::exp(-std::pow(gamma * w, modulus));
                            }),
            1.95 / std::sqrt(n));
}

// The correlation is that of the kernel with itself: 1/e at the length in all
// directions, 0 beyond twice the radius of the kernel. A mean of n products
// deviates by sqrt((1 + rho^2) / n); 0.004 is how far the lattice shows.
TEST(StrengthField, CorrelationFallsWithTheDistance)
{
  constexpr unsigned int n        = 4000;
  const double           diagonal = 1 / std::sqrt(3.);
  for (const auto &[distance, expected] : {std::make_pair(0., 1.),
                                           std::make_pair(.5, .784),
                                           std::make_pair(1., std::exp(-1.)),
                                           std::make_pair(1.5, .0915),
                                           std::make_pair(3.06, 0.)})
    for (const Vector3<double> direction :
         {Vector3<double>{{1, 0, 0}},
          Vector3<double>{{0, .6, -.8}},
          Vector3<double>{{diagonal, diagonal, diagonal}}})
      {
        double sum = 0;
        for (unsigned int seed = 1; seed <= n; ++seed)
          {
            const StrengthField   field(seed, length, 5);
            const Vector3<double> place = {
              {.0137 * length * seed, .0071 * length * seed, -.5 * length}};
            sum += field.normal_value(place) *
                   field.normal_value(place + distance * length * direction);
          }
        EXPECT_NEAR(sum / n,
                    expected,
                    .004 + 4 * std::sqrt((1 + expected * expected) / n));
      }
}

// A field is smooth, and depends on the seed and the length.
TEST(StrengthField, IsSmooth)
{
  const StrengthField field(1, length, 5);
  double              largest_change = 0, largest_difference = 0;
  for (unsigned int i = 0; i < 3000; ++i)
    {
      const Vector3<double> place = {{1e-3 * length * i, 0, 0}};
      const double          value = field.normal_value(place);
      const double next = field.normal_value({{1e-3 * length * (i + 1), 0, 0}});
      largest_change    = std::max(largest_change, std::abs(next - value));
      for (const StrengthField &other :
           {StrengthField(2, length, 5), StrengthField(1, 2 * length, 5)})
        largest_difference =
          std::max(largest_difference,
                   std::abs(other.normal_value(place) - value));
    }
  // The slope has the deviation sqrt(2) / length.
  EXPECT_LT(largest_change, 5 * std::sqrt(2.) * 1e-3);
  EXPECT_GT(largest_difference, 1);
}

// The weakest place of a body, on meshes whose cells differ by 3.136 in volume:
// where each vertex has a strength of its own, the means are in the ratio of the
// volumes to the power of 1/m; with a length of two edges and more they are the
// same. A mean of n has the error 1.28/m/sqrt(n).
TEST(StrengthField, BodyHasTheSameStrengthOnFinerCells)
{
  constexpr double                      modulus = 24, edge = .25;
  constexpr unsigned int                n_seeds = 500;
  constexpr std::array<unsigned int, 3> coarse  = {{5, 5, 5}},
                                        fine    = {{7, 7, 8}};
  const auto ratio = [&](const double correlation_length) {
    double sums[2] = {0, 0};
    for (unsigned int seed = 1; seed <= n_seeds; ++seed)
      {
        const StrengthField field(seed, correlation_length, modulus);
        sums[0] += weakest_vertex(field, coarse);
        sums[1] += weakest_vertex(field, fine);
      }
    return sums[0] / sums[1];
  };
  const double error = std::sqrt(2. / n_seeds) * 1.28 / modulus;
  EXPECT_NEAR(ratio(.01 * edge),
              std::pow(7 * 7 * 8 / 125., 1 / modulus),
              4 * error);
  EXPECT_NEAR(ratio(3 * edge), 1, 2 * error);
}
