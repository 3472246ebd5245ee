#include <rift/material/crack_fit.h>
#include <rift/material/wave_speeds.h>

#include <gtest/gtest.h>

using namespace rift;

namespace
{
  StiffnessMatrix
  granite()
  {
    MaterialParameters parameters;
    parameters.youngs_modulus = 80e9;
    parameters.poissons_ratio = .25;
    return isotropic_stiffness(parameters);
  }
} // namespace

TEST(WaveSpeeds, IsotropicInAnyDirection)
{
  const auto speeds = wave_speeds(granite(), 2600, {{1, -2, 3}});
  EXPECT_NEAR(speeds[0] / std::sqrt(96e9 / 2600), 1, 1e-12);
  EXPECT_NEAR(speeds[1] / std::sqrt(32e9 / 2600), 1, 1e-12);
  EXPECT_NEAR(speeds[2] / std::sqrt(32e9 / 2600), 1, 1e-12);
}

TEST(WaveSpeeds, OrthotropicBetweenTheAxes)
{
  StiffnessMatrix c = granite();
  c[2][2]           = 35e9;
  c[3][3]           = 15e9;
  c[4][4]           = 18e9;
  // Along (0, 1, 1) the wave polarized along x is by itself; the other two are
  // roots of a quadratic equation.
  const auto   speeds = wave_speeds(c, 2600, {{0, 1, 1}});
  const double a = .5 * (c[1][1] + c[3][3]), b = .5 * (c[2][2] + c[3][3]),
               d    = .5 * (c[1][2] + c[3][3]);
  const double mean = .5 * (a + b), spread = std::hypot(.5 * (a - b), d);
  const double across = .5 * (c[5][5] + c[4][4]);
  EXPECT_NEAR(speeds[0] / std::sqrt((mean + spread) / 2600), 1, 1e-12);
  EXPECT_NEAR(speeds[1] / std::sqrt(across / 2600), 1, 1e-12);
  EXPECT_NEAR(speeds[2] / std::sqrt((mean - spread) / 2600), 1, 1e-12);
}

TEST(WaveSpeeds, ImpedanceIsDensityTimesSpeed)
{
  const double          density = 2600;
  const Vector3<double> n       = {{2 / 3., -1 / 3., 2 / 3.}};
  const auto            z       = impedance(granite(), density, n);
  const double p = std::sqrt(96e9 * density), s = std::sqrt(32e9 * density);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      EXPECT_NEAR(z[i][j] / p,
                  (s * (i == j) + (p - s) * n[i] * n[j]) / p,
                  1e-12);
}

TEST(CrackFit, FindsTheDensitiesAgain)
{
  const std::vector<CrackGroup> groups = {{Vector3<double>{{0, 1, 1}}, .05},
                                          {{}, .3},
                                          {Vector3<double>{{1, 0, 0}}, 0}};
  const auto                    target =
    stiffness_with_cracks(granite(), groups, CrackScheme::dilute).value();
  auto start = groups;
  for (CrackGroup &group : start)
    group.density = .1;
  const CrackFit fit =
    fit_cracks(granite(),
               start,
               CrackScheme::dilute,
               [&target](const StiffnessMatrix &stiffness) {
                 std::vector<double> residuals;
                 for (unsigned int i = 0; i < 6; ++i)
                   for (unsigned int j = i; j < 6; ++j)
                     residuals.push_back(stiffness[i][j] - target[i][j]);
                 return residuals;
               });
  EXPECT_NEAR(fit.groups[0].density, .05, 1e-6);
  EXPECT_NEAR(fit.groups[1].density, .3, 1e-6);
  EXPECT_NEAR(fit.groups[2].density, 0, 1e-6);
  EXPECT_LT(fit.mean_residual(), 1e4);
}
