#include <rift/bonds/weakest_planes.h>

#include <gtest/gtest.h>

#include <random>

using namespace rift;

namespace
{
  using Vector = Vector3<double>;

  const FaceStrength granite =
    {15e6, 36.7e6, std::tan(50 * M_PI / 180), .6, 400, 400};

  SymmetricTensor<double>
  random_stress(std::mt19937 &random)
  {
    std::normal_distribution<double> value(0, 2e7);
    SymmetricTensor<double>          stress;
    for (unsigned int i = 0; i < 6; ++i)
      stress[i] = value(random) - (i < 3 ? 1e7 : 0);
    return stress;
  }

  /** Directions that are spread evenly over half of the sphere. */
  std::vector<Vector>
  directions(const unsigned int n)
  {
    std::vector<Vector> result;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double z = 1 - (i + .5) / n, r = std::sqrt(1 - z * z);
        const double angle = 2.399963229728653 * i;
        result.push_back({{r * std::cos(angle), r * std::sin(angle), z}});
      }
    return result;
  }

  /** Of the tensor itself. */
  double
  demand(const SymmetricTensor<double> &s,
         const Vector                  &m,
         const FaceStrength            &strength)
  {
    const unsigned int at[3][3] = {{voigt[0][0], voigt[0][1], voigt[0][2]},
                                   {voigt[1][0], voigt[1][1], voigt[1][2]},
                                   {voigt[2][0], voigt[2][1], voigt[2][2]}};
    Vector             t        = {{0, 0, 0}};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        t[i] += s[at[i][j]] * m[j];
    const double along = dot(t, m);
    const double shear = std::sqrt(std::max(0., dot(t, t) - along * along));
    return std::max(along / strength.tensile_strength,
                    (shear + along * strength.tan_friction_angle) /
                      strength.cohesion);
  }

  double
  brute_force(const SymmetricTensor<double> &s,
              const StrengthAcross          &strength,
              const std::vector<Vector>     &planes)
  {
    double best = -1e300;
    for (const Vector &m : planes)
      best = std::max(best, demand(s, m, strength(m)));
    return best;
  }
} // namespace

// 40,000 directions are 0.7 degrees apart: at most 4e-4 of the stresses less.
TEST(WeakestPlanes, LargestOfManyDirections)
{
  std::mt19937 random(1);
  const auto   planes  = directions(40000);
  unsigned int n_shear = 0, n_tension = 0;
  for (unsigned int i = 0; i < 100; ++i)
    {
      const auto stress = random_stress(random);
      const auto result = weakest_planes(stress, granite);
      double     size   = 0;
      for (unsigned int k = 0; k < 6; ++k)
        size = std::max(size, std::abs(stress[k]) / granite.tensile_strength);
      const double best = brute_force(
        stress,
        [](const Vector &) { return granite; },
        planes);
      EXPECT_GE(result.demand, best - 1e-9 * size);
      EXPECT_NEAR(result.demand, best, 1e-3 * size);
      EXPECT_NEAR(largest_demand(stress, granite), result.demand, 1e-7 * size);
      ASSERT_EQ(result.normals.size(), result.by_shear ? 2u : 1u);
      (result.by_shear ? n_shear : n_tension) += 1;
      for (const Vector &m : result.normals)
        {
          EXPECT_NEAR(norm(m), 1, 1e-12);
          EXPECT_NEAR(demand(stress, m, granite), result.demand, 1e-7 * size);
          const auto   t       = traction_on(stress, m);
          const double tension = t.normal / granite.tensile_strength;
          EXPECT_EQ(result.by_shear, tension < result.demand - 1e-7 * size);
          EXPECT_NEAR(demand_on(t, granite), result.demand, 1e-7 * size);
        }
    }
  EXPECT_GT(n_shear, 10u);
  EXPECT_GT(n_tension, 10u);
}

// On any plane the mean of two stresses of a demand below 1 has one below 1.
TEST(WeakestPlanes, StressesBelowTheStrengthAreConvex)
{
  std::mt19937                           random(2);
  std::uniform_real_distribution<double> part(0, 1);
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const auto   a = random_stress(random), b = random_stress(random);
      const double d[2] = {largest_demand(a, granite),
                           largest_demand(b, granite)};
      const double w    = part(random);
      SymmetricTensor<double> mean;
      for (unsigned int k = 0; k < 6; ++k)
        mean[k] =
          w * a[k] / std::max(d[0], .1) + (1 - w) * b[k] / std::max(d[1], .1);
      EXPECT_LE(largest_demand(mean, granite), 1 + 1e-9);
    }
}

// Bedding that is turned: half the strength across one direction.
namespace
{
  StrengthAcross
  bedded_rock(const Vector &axis)
  {
    return [axis](const Vector &m) {
      const double along = dot(m, axis) * dot(m, axis);
      FaceStrength s     = granite;
      s.tensile_strength *= 1 - .5 * along;
      s.cohesion *= 1 - .5 * along;
      return s;
    };
  }
} // namespace

TEST(WeakestPlanes, OfBeddedRockAreTheLargestOfManyDirections)
{
  std::mt19937                     random(3);
  std::normal_distribution<double> value;
  const auto                       planes = directions(40000);
  for (unsigned int i = 0; i < 200; ++i)
    {
      Vector axis = {{value(random), value(random), value(random)}};
      axis        = (1 / norm(axis)) * axis;
      const StrengthAcross    across = bedded_rock(axis);
      const auto              stress = random_stress(random);
      const DirectionalPlanes bedded(across);
      const auto              result = bedded.weakest(stress);
      const double            best   = brute_force(stress, across, planes);
      if (best < .1)
        continue;
      ASSERT_FALSE(result.normals.empty());
      // A search may end at a place that is nearly as weak.
      EXPECT_GE(result.demand, .99 * best) << i;
      EXPECT_LE(result.demand, 1.01 * best) << i;
      for (const Vector &m : result.normals)
        EXPECT_NEAR(demand(stress, m, across(m)),
                    result.demand,
                    1e-6 * result.demand);
    }
}

TEST(WeakestPlanes, BoundOfBeddedRockIsNearTheLargestDemand)
{
  std::mt19937                     random(4);
  std::normal_distribution<double> value;
  const auto                       planes = directions(4000);
  double                           sum    = 0;
  unsigned int                     n      = 0;
  for (unsigned int i = 0; i < 500; ++i)
    {
      Vector axis = {{value(random), value(random), value(random)}};
      axis        = (1 / norm(axis)) * axis;
      const StrengthAcross across = bedded_rock(axis);
      auto                 stress = random_stress(random);
      // Under pressure, too.
      const double pressure = (i % 5) * 50e6;
      for (unsigned int d = 0; d < dim; ++d)
        stress[voigt[d][d]] -= pressure;
      const double best  = brute_force(stress, across, planes);
      const double bound = DirectionalPlanes(across).bound_of_demand(stress);
      EXPECT_GE(bound, best) << i;
      if (best > .5)
        {
          sum += bound / best;
          ++n;
        }
    }
  ASSERT_GT(n, 50u);
  EXPECT_LT(sum / n, 1.15);
}
