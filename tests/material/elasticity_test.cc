// Elastic laws and their rotation into the frame of the mesh.

#include <rift/material/elasticity.h>

#include "../support/tensors.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  void
  expect_equal(const StiffnessMatrix &a,
               const StiffnessMatrix &b,
               const double           tolerance)
  {
    double scale = 0;
    for (const auto &row : a)
      for (const double entry : row)
        scale = std::max(scale, std::abs(entry));
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        EXPECT_NEAR(a[i][j], b[i][j], tolerance * scale) << i << j;
  }

  StiffnessMatrix
  orthotropic()
  {
    return {{{{55e9, 9e9, 8e9, 0, 0, 0}},
             {{9e9, 46e9, 7e9, 0, 0, 0}},
             {{8e9, 7e9, 35e9, 0, 0, 0}},
             {{0, 0, 0, 16e9, 0, 0}},
             {{0, 0, 0, 0, 18e9, 0}},
             {{0, 0, 0, 0, 0, 21e9}}}};
  }
} // namespace

TEST(Elasticity, IsotropicConstants)
{
  // Uniaxial stress: S11 / E11 = E and E22 / E11 = -nu.
  const Elasticity law = make_elasticity(granite());
  const auto       s   = std::get<IsotropicElasticity>(law).stress(
    SymmetricTensor<double>{{1e-3, -.2e-3, -.2e-3, 1e-4, 2e-4, 3e-4}});
  const double mu = 40.6e9 / 2.4;
  EXPECT_NEAR(s[0], 40.6e6, 1e-8 * 40.6e6);
  EXPECT_NEAR(s[1], 0, 1e-8);
  EXPECT_NEAR(s[2], 0, 1e-8);
  for (unsigned int i = 3; i < 6; ++i)
    EXPECT_NEAR(s[i], 2 * mu * (i - 2) * 1e-4, 1e-8);
}

TEST(Elasticity, IsotropicTensorIsTheSameInEveryFrame)
{
  Random                random(1);
  const StiffnessMatrix stiffness =
    stiffness_matrix(make_elasticity(granite()));
  EXPECT_NEAR(stiffness[0][0], 40.6e9 * .8 / (1.2 * .6), 1e-4);
  EXPECT_NEAR(stiffness[0][1], 40.6e9 * .2 / (1.2 * .6), 1e-4);
  EXPECT_NEAR(stiffness[3][3], 40.6e9 / 2.4, 1e-4);
  for (unsigned int i = 0; i < 100; ++i)
    expect_equal(rotate_stiffness(stiffness, random_rotation(random)),
                 stiffness,
                 1e-14);
}

TEST(Elasticity, QuarterTurnPermutesTheConstants)
{
  const StiffnessMatrix c = orthotropic();
  // Material axes 1, 2, 3 along y, -x, z: 11 and 22 change places, and so do
  // 23 and 13.
  const StiffnessMatrix r =
    rotate_stiffness(c, {{{{0, 1, 0}}, {{-1, 0, 0}}, {{0, 0, 1}}}});
  const unsigned int swapped[6] = {1, 0, 2, 4, 3, 5};
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      EXPECT_DOUBLE_EQ(r[i][j], c[swapped[i]][swapped[j]]) << i << j;

  // Axes 1, 2, 3 along y, z, x: what was of axis 1 is now of y.
  const StiffnessMatrix p =
    rotate_stiffness(c, {{{{0, 1, 0}}, {{0, 0, 1}}, {{1, 0, 0}}}});
  const unsigned int moved[6] = {2, 0, 1, 5, 3, 4};
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = 0; j < 6; ++j)
      EXPECT_DOUBLE_EQ(p[i][j], c[moved[i]][moved[j]]) << i << j;
}

TEST(Elasticity, RotationIsThatOfTheFullTensor)
{
  Random random(2);
  for (unsigned int n = 0; n < 50; ++n)
    {
      const MaterialParameters material = random_anisotropic(random);
      const Tensor4            tensor   = stiffness_tensor(material);
      StiffnessMatrix          expected;
      const unsigned int       pairs[6][2] =
        {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          expected[i][j] =
            tensor[pairs[i][0]][pairs[i][1]][pairs[j][0]][pairs[j][1]];
      expect_equal(expected,
                   stiffness_matrix(make_elasticity(material)),
                   1e-13);
    }
}

TEST(Elasticity, MaterialAxesAreOrthonormal)
{
  Random random(3);
  for (unsigned int n = 0; n < 100; ++n)
    {
      const Vector3<double> a    = 5. * random_direction(random);
      const Vector3<double> b    = .1 * random_direction(random) + 2. * a;
      const Matrix3<double> axes = material_axes(a, b);
      const Matrix3<double> gram = product(axes, transpose(axes));
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          EXPECT_NEAR(gram[i][j], i == j, 1e-11);
      EXPECT_NEAR(determinant(axes), 1, 1e-11);
      EXPECT_NEAR(dot(axes[0], a), 5, 1e-13);
      // The second is in the plane of the two, on the side of b.
      EXPECT_NEAR(dot(axes[2], b), 0, 1e-11 * norm(b));
      EXPECT_GT(dot(axes[1], b), 0);
    }
}
