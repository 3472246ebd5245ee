#include <rift/material/elasticity.h>

#include <gtest/gtest.h>

using namespace rift;

namespace
{
  constexpr double E = 80e9, nu = .25;

  StiffnessMatrix
  intact()
  {
    MaterialParameters parameters;
    parameters.youngs_modulus = E;
    parameters.poissons_ratio = nu;
    return isotropic_stiffness(parameters);
  }

  CrackGroup
  across(const Vector3<double> &normal, const double density)
  {
    return {normal, density};
  }

  CrackGroup
  random_cracks(const double density)
  {
    return {{}, density};
  }

  /** Young's modulus and shear modulus of an isotropic material. */
  struct Moduli
  {
    double young, shear;
  };

  Moduli
  moduli_of(const StiffnessMatrix &c)
  {
    const double shear = c[3][3], lame = c[0][1];
    return {shear * (3 * lame + 2 * shear) / (lame + shear), shear};
  }

  /** C11 C22 C33 C12 C13 C23 and the shears 23 13 12, GPa. */
  std::array<double, 9>
  orthotropic(const StiffnessMatrix &c)
  {
    std::array<double, 9> result = {{c[0][0],
                                     c[1][1],
                                     c[2][2],
                                     c[0][1],
                                     c[0][2],
                                     c[1][2],
                                     c[3][3],
                                     c[4][4],
                                     c[5][5]}};
    for (double &x : result)
      x /= 1e9;
    return result;
  }

  void
  expect_near(const std::array<double, 9> &a,
              const std::array<double, 9> &b,
              const double                 tolerance)
  {
    for (unsigned int i = 0; i < 9; ++i)
      EXPECT_NEAR(a[i], b[i], tolerance) << i;
  }

  /** Barre granite: grain and rift cracks across the axes 2 and 3. */
  std::array<double, 9>
  barre(const double      grain,
        const double      rift,
        const double      random,
        const CrackScheme scheme)
  {
    return orthotropic(stiffness_with_cracks(intact(),
                                             {random_cracks(random),
                                              across({{0, 1, 0}}, grain),
                                              across({{0, 0, 1}}, rift)},
                                             scheme)
                         .value());
  }
} // namespace

TEST(Microcracks, ResistanceInAnIsotropicMaterial)
{
  const double          normal     = M_PI * E / (4 * (1 - nu * nu));
  const double          tangential = M_PI * E * (2 - nu) / (8 * (1 - nu * nu));
  const Vector3<double> n          = {{1 / 3., -2 / 3., 2 / 3.}};
  const auto            q          = crack_resistance(intact(), n);
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      EXPECT_NEAR(
        q[i][j] / E,
        (tangential * (i == j) + (normal - tangential) * n[i] * n[j]) / E,
        1e-12);
}

TEST(Microcracks, OneDiluteGroupHasItsClosedForm)
{
  const double density = .1;
  const auto   c       = stiffness_with_cracks(intact(),
                                       {across({{0, 0, 5}}, density)},
                                       CrackScheme::dilute)
                   .value();
  // Compliances along and across the normal, and in shear with it.
  const double s33 = (1 + 16 * (1 - nu * nu) / 3 * density) / E;
  const double s44 =
    (2 * (1 + nu) + 32 * (1 - nu * nu) / (3 * (2 - nu)) * density) / E;
  // With stress along the normal alone, strains are s33 and -nu/E.
  for (unsigned int row = 0; row < 3; ++row)
    EXPECT_NEAR(c[row][2] * s33 - (c[row][0] + c[row][1]) * nu / E,
                row == 2 ? 1 : 0,
                1e-8);
  EXPECT_NEAR(c[3][3] * s44, 1, 1e-8);
  EXPECT_NEAR(c[4][4] * s44, 1, 1e-8);
  EXPECT_NEAR(c[5][5] * 2 * (1 + nu) / E, 1, 1e-8);
}

TEST(Microcracks, RandomCracksLeaveTheMaterialIsotropic)
{
  // dilute: Budiansky & O'Connell; differential: Hashin's two equations, here
  // in many steps of Runge and Kutta.
  const auto rate = [](const Moduli &m) {
    const double v = m.young / (2 * m.shear) - 1;
    return Moduli{-m.young * 16 * (1 - v * v) * (10 - 3 * v) / (45 * (2 - v)),
                  -m.shear * 32 * (1 - v) * (5 - v) / (45 * (2 - v))};
  };
  const double density = .3;
  const Moduli start   = {E, E / (2 * (1 + nu))};
  const Moduli first   = rate(start);
  const auto   dilute  = moduli_of(stiffness_with_cracks(intact(),
                                                      {random_cracks(density)},
                                                      CrackScheme::dilute)
                                  .value());
  EXPECT_NEAR(start.young / dilute.young,
              1 - density * first.young / start.young,
              1e-8);
  EXPECT_NEAR(start.shear / dilute.shear,
              1 - density * first.shear / start.shear,
              1e-8);

  Moduli       exact   = start;
  const int    n_steps = 10000;
  const double step    = density / n_steps;
  for (int i = 0; i < n_steps; ++i)
    {
      const Moduli k      = rate(exact);
      const Moduli middle = rate(
        {exact.young + step / 2 * k.young, exact.shear + step / 2 * k.shear});
      exact = {exact.young + step * middle.young,
               exact.shear + step * middle.shear};
    }
  const auto c = stiffness_with_cracks(intact(),
                                       {random_cracks(density)},
                                       CrackScheme::differential)
                   .value();
  EXPECT_NEAR(moduli_of(c).young / exact.young, 1, 1e-6);
  EXPECT_NEAR(moduli_of(c).shear / exact.shear, 1, 1e-6);
  EXPECT_NEAR(c[0][0] / c[2][2], 1, 1e-9);
  EXPECT_NEAR(c[0][0] - c[0][1] - 2 * c[5][5], 0, 1e-9 * E);
}

TEST(Microcracks, SchemesAgreeWithTheReference)
{
  // An independent program with other quadratures, GPa.
  expect_near(barre(.0624, .0954, .2262, CrackScheme::differential),
              {{54.67, 40.64, 35.12, 7.82, 6.88, 5.34, 15.80, 18.18, 19.45}},
              .02);
  expect_near(barre(.0581, .0845, .2405, CrackScheme::differential_in_order),
              {{54.67, 40.65, 35.13, 7.85, 6.91, 5.36, 15.84, 18.22, 19.44}},
              .02);
  expect_near(barre(.1035, .1654, .3027, CrackScheme::dilute),
              {{54.76, 40.74, 35.29, 7.97, 7.03, 5.46, 15.59, 17.62, 19.11}},
              .02);
  expect_near(barre(.0399, .0593, .1744, CrackScheme::self_consistent),
              {{54.62, 40.64, 35.10, 7.73, 6.80, 5.29, 15.97, 18.53, 19.68}},
              .02);
}

TEST(Microcracks, FrameDoesNotMatter)
{
  const Matrix3<double>         axes = material_axes({{1, 2, 2}}, {{-2, 1, 0}});
  const std::vector<CrackGroup> turned   = {across(axes[1], .06),
                                            across(axes[2], .1),
                                            random_cracks(.2)};
  const std::vector<CrackGroup> straight = {across({{0, 1, 0}}, .06),
                                            across({{0, 0, 1}}, .1),
                                            random_cracks(.2)};
  for (const CrackScheme scheme : {CrackScheme::dilute,
                                   CrackScheme::differential,
                                   CrackScheme::differential_in_order,
                                   CrackScheme::self_consistent})
    {
      const auto a = stiffness_with_cracks(intact(), turned, scheme).value();
      const auto b = rotate_stiffness(
        stiffness_with_cracks(intact(), straight, scheme).value(),
        axes);
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          EXPECT_NEAR(a[i][j] / E, b[i][j] / E, 2e-6) << i << j;
    }
}

TEST(Microcracks, TellsWhenNothingIsLeft)
{
  EXPECT_FALSE(stiffness_with_cracks(intact(),
                                     {random_cracks(.7)},
                                     CrackScheme::self_consistent));
  // The differential scheme always leaves some.
  EXPECT_TRUE(stiffness_with_cracks(intact(),
                                    {random_cracks(2)},
                                    CrackScheme::differential));
}
