// The bound of the highest frequency against the eigenvalues of the 12 x 12
// stiffness of a loose cell.

#include <rift/solid/cell_frequency.h>

#include "../support/single_cell.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  using Matrix12 = std::array<std::array<double, 12>, 12>;

  /** K_(a i)(b k) = V dN_a/dX_j C_ijkl dN_b/dX_l over the mass of a corner. */
  Matrix12
  dynamic_matrix(const ReferenceBatch &cell,
                 const Tensor4        &c,
                 const double          density)
  {
    Matrix12 result{};
    for (unsigned int row = 0; row < 12; ++row)
      for (unsigned int column = 0; column < 12; ++column)
        for (unsigned int j = 0; j < 3; ++j)
          for (unsigned int l = 0; l < 3; ++l)
            result[row][column] += 4 / density * cell.gradient(row / 3, 0)[j] *
                                   c[row % 3][j][column % 3][l] *
                                   cell.gradient(column / 3, 0)[l];
    return result;
  }

  /** Power iteration with the powers 2^k, then Rayleigh's quotient. */
  double
  largest_eigenvalue(const Matrix12 &matrix)
  {
    Matrix12 power = matrix;
    for (unsigned int squaring = 0; squaring < 40; ++squaring)
      {
        double scale = 0;
        for (unsigned int i = 0; i < 12; ++i)
          scale += power[i][i];
        Matrix12 square{};
        for (unsigned int i = 0; i < 12; ++i)
          for (unsigned int j = 0; j < 12; ++j)
            for (unsigned int k = 0; k < 12; ++k)
              square[i][j] += (power[i][k] / scale) * (power[k][j] / scale);
        power = square;
      }
    std::array<double, 12> v{};
    for (unsigned int i = 0; i < 12; ++i)
      for (unsigned int j = 0; j < 12; ++j)
        v[i] += power[i][j] * std::sin(1.3 * j + .7);
    double numerator = 0, denominator = 0;
    for (unsigned int i = 0; i < 12; ++i)
      {
        denominator += v[i] * v[i];
        for (unsigned int j = 0; j < 12; ++j)
          numerator += v[i] * matrix[i][j] * v[j];
      }
    return numerator / denominator;
  }

  Tensor4
  isotropic_tensor(const double youngs_modulus, const double nu)
  {
    const double lambda = youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu));
    const double mu     = youngs_modulus / (2 * (1 + nu));
    Tensor4      c{};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          c[i][i][j][j] += lambda;
          c[i][j][i][j] += mu;
          c[i][j][j][i] += mu;
        }
    return c;
  }

  /** Bound over truth. */
  double
  ratio(const Body &body, const MaterialParameters &material, const Tensor4 &c)
  {
    const DiscreteBody discrete = discretize(body, {material.density});
    const double       bound =
      largest_frequency_squared(discrete.reference[0],
                                0,
                                stiffness_matrix(make_elasticity(material)),
                                material.density);
    return bound /
           largest_eigenvalue(
             dynamic_matrix(discrete.reference[0], c, material.density));
  }
} // namespace

TEST(CellFrequency, RegularTetrahedronIsThatOfTheTable)
{
  // dt c_p / h of the height h = sqrt(2/3), with dt = 2 / omega.
  for (const auto &[nu, expected] : {std::make_pair(0., std::sqrt(.75)),
                                     std::make_pair(.2, std::sqrt(.5)),
                                     std::make_pair(.25, std::sqrt(.45)),
                                     std::make_pair(.3, .6355)})
    {
      const DiscreteBody discrete = discretize(make_regular_cell(), {2641});
      const double       e        = 40.6e9;
      const double       c_p =
        std::sqrt(e * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / 2641);
      const double truth = largest_eigenvalue(
        dynamic_matrix(discrete.reference[0], isotropic_tensor(e, nu), 2641));
      EXPECT_NEAR(2 / std::sqrt(truth) * c_p / std::sqrt(2. / 3),
                  expected,
                  5e-5);

      MaterialParameters material = granite();
      material.poissons_ratio     = nu;
      const double of_program =
        largest_frequency_squared(discrete.reference[0],
                                  0,
                                  stiffness_matrix(make_elasticity(material)),
                                  2641);
      EXPECT_GE(of_program, truth * (1 - 1e-12));
      EXPECT_LE(of_program, truth * 1.03);
    }
}

TEST(CellFrequency, RigidCellsHaveNone)
{
  const DiscreteBody body = discretize(make_regular_cell(), {2641});
  EXPECT_EQ(largest_frequency_squared(body.reference[0], 0, {}, 2641), 0);
}

TEST(CellFrequency, BoundIsSafeAndSharp)
{
  Random random(1);
  double smallest = 2, largest_ratio = 0;
  for (unsigned int n = 0; n < 300; ++n)
    {
      MaterialParameters material = granite();
      material.poissons_ratio     = -.3 + .79 * (n % 50) / 50;
      const double isotropic      = ratio(
        make_random_cell(random),
        material,
        isotropic_tensor(material.youngs_modulus, material.poissons_ratio));
      material = random_anisotropic(random);
      const double anisotropic =
        ratio(make_random_cell(random), material, stiffness_tensor(material));
      smallest      = std::min({smallest, isotropic, anisotropic});
      largest_ratio = std::max({largest_ratio, isotropic, anisotropic});
    }
  EXPECT_GE(smallest, 1 - 1e-12);
  EXPECT_LE(largest_ratio, 1.03);
}
