#include <rift/cohesive/weakest_plane.h>

#include <gtest/gtest.h>

#include <random>

using namespace rift;

namespace
{
  using Vector = Vector3<double>;
  using Matrix = Matrix3<double>;

  const FaceStrength strength = {15e6, 36.7e6, std::tan(.8), .6, 400, 400};

  /** The largest factor up to which a stress may grow before one of many planes
   * is at its strength after eq. (11). */
  double
  reserve_by_search(const Matrix &stress)
  {
    double             least = 1e300;
    const unsigned int n     = 600;
    for (unsigned int i = 0; i <= n; ++i)
      for (unsigned int j = 0; j < 2 * n; ++j)
        {
          const double a = .5 * M_PI * i / n, b = M_PI * j / n;
          const Vector normal = {{std::cos(a),
                                  std::sin(a) * std::cos(b),
                                  std::sin(a) * std::sin(b)}};
          const Vector t      = stress * normal;
          const double sigma  = dot(t, normal);
          const double tau    = norm(t - sigma * normal);
          if (sigma > 0)
            least = std::min(least, strength.tensile_strength / sigma);
          const double demand =
            tau + std::min(sigma, 0.) * strength.tan_friction_angle;
          if (demand > 0)
            least = std::min(least, strength.cohesion / demand);
        }
    return least;
  }
} // namespace

TEST(WeakestPlane, IsThatOfAllPlanes)
{
  std::mt19937                           random(4);
  std::uniform_real_distribution<double> value(-1, 1);
  for (unsigned int sample = 0; sample < 20; ++sample)
    {
      Matrix       stress;
      const double pressure = sample % 4 * 3e6;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          stress[i][j] = stress[j][i] =
            10e6 * value(random) - (i == j ? pressure : 0);
      const double reserve = reserve_by_search(stress);
      if (reserve > 1e3)
        continue;
      const auto scaled = [&](const double factor) {
        Matrix result = stress;
        for (auto &row : result)
          row = factor * row;
        return result;
      };
      EXPECT_FALSE(some_plane_is_at_strength(scaled(.9999 * reserve), strength))
        << sample;
      EXPECT_TRUE(some_plane_is_at_strength(scaled(1.0001 * reserve), strength))
        << sample;
    }
}

TEST(WeakestPlane, UniaxialStrengths)
{
  const double sine = std::sin(std::atan(strength.tan_friction_angle));
  const double uniaxial =
    2 * strength.cohesion * std::sqrt((1 + sine) / (1 - sine));
  for (const auto &[stress, is_at_strength] :
       {std::make_pair(1.000001 * strength.tensile_strength, true),
        std::make_pair(.999999 * strength.tensile_strength, false),
        std::make_pair(-1.000001 * uniaxial, true),
        std::make_pair(-.999999 * uniaxial, false)})
    {
      Matrix s{};
      s[1][1] = stress;
      EXPECT_EQ(some_plane_is_at_strength(s, strength), is_at_strength);
    }
  Matrix hydrostatic{};
  for (unsigned int i = 0; i < dim; ++i)
    hydrostatic[i][i] = -1e9;
  EXPECT_FALSE(some_plane_is_at_strength(hydrostatic, strength));
}
