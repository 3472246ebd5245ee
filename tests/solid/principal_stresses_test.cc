#include <rift/solid/principal_stresses.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

using namespace rift;

namespace
{
  void
  expect_near(const Vector3<double> &values,
              const Vector3<double> &expected,
              const double           tolerance)
  {
    for (unsigned int i = 0; i < 3; ++i)
      EXPECT_NEAR(values[i], expected[i], tolerance) << "value " << i;
  }

  /** R diag(values) R^T with the rotation of a random unit quaternion. */
  Matrix3<double>
  turned(const Vector3<double> &values, std::mt19937 &random)
  {
    std::normal_distribution<double> normal;
    std::array<double, 4>            q;
    double                           square = 0;
    for (double &component : q)
      {
        component = normal(random);
        square += component * component;
      }
    for (double &component : q)
      component /= std::sqrt(square);
    const auto [w, x, y, z] = q;
    const Matrix3<double> r{
      {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)}},
       {{2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)}},
       {{2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}}};
    Matrix3<double> result{};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          result[i][j] += r[i][k] * values[k] * r[j][k];
    return result;
  }
} // namespace

TEST(PrincipalStresses, OfSimpleStates)
{
  // Of rest; of pressure alone; of tension along y; of shear.
  using Tensor = SymmetricTensor<double>;
  expect_near(principal_stresses(Tensor{}), {{0, 0, 0}}, 0);
  expect_near(principal_stresses(Tensor{{-5, -5, -5, 0, 0, 0}}),
              {{-5, -5, -5}},
              1e-14);
  expect_near(principal_stresses(Tensor{{0, 7, 0, 0, 0, 0}}),
              {{7, 0, 0}},
              1e-7);
  expect_near(principal_stresses(Tensor{{0, 0, 0, 0, 3, 0}}),
              {{3, 0, -3}},
              1e-14);
}

TEST(PrincipalStresses, OfAnyComponents)
{
  // Traces of the powers of the matrix.
  const SymmetricTensor<double> s = {{1, -2, 3, 4, -5, 6}};
  const Vector3<double>         p = principal_stresses(s);
  EXPECT_NEAR(p[0] + p[1] + p[2], 2, 1e-13);
  EXPECT_NEAR(dot(p, p), 1 + 4 + 9 + 2 * (16 + 25 + 36), 1e-12);
  // By Sarrus's rule.
  EXPECT_NEAR(p[0] * p[1] * p[2],
              -6 + 2 * 4 * -5 * 6 - 1 * 16 + 2 * 25 - 3 * 36,
              1e-11);
  EXPECT_GT(p[0], p[1]);
  EXPECT_GT(p[1], p[2]);
}

TEST(PrincipalStresses, DoNotDependOnTheAxes)
{
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> stress(-1, 1);
  for (unsigned int i = 0; i < 1000; ++i)
    {
      Vector3<double> values{{stress(random), stress(random), stress(random)}};
      std::sort(values.begin(), values.end(), std::greater<>());
      // Nearly equal values cost half of the digits.
      expect_near(principal_stresses(turned(values, random)), values, 1e-7);
    }
}
