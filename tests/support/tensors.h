#ifndef rift_tests_support_tensors_h
#define rift_tests_support_tensors_h

#include <rift/discretization/state.h>
#include <rift/material/material_parameters.h>

#include <algorithm>
#include <cmath>
#include <random>

/**
 * Tensors for tests: rotations, linear fields and an elastic law by the full
 * tensor of fourth order, none of which uses the program's formulas.
 */
namespace rift::test
{
  using Random = std::mt19937;

  inline constexpr Matrix3<double> unit_matrix = {
    {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};

  inline Matrix3<double>
  transpose(const Matrix3<double> &a)
  {
    Matrix3<double> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        result[i][j] = a[j][i];
    return result;
  }

  inline Matrix3<double>
  product(const Matrix3<double> &a, const Matrix3<double> &b)
  {
    Matrix3<double> result{};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          result[i][j] += a[i][k] * b[k][j];
    return result;
  }

  /** Largest magnitude of a component. */
  inline double
  largest(const Matrix3<double> &a)
  {
    double result = 0;
    for (const auto &row : a)
      for (const double entry : row)
        result = std::max(result, std::abs(entry));
    return result;
  }

  inline Matrix3<double>
  random_matrix(Random &random)
  {
    std::uniform_real_distribution<double> entry(-1, 1);
    Matrix3<double>                        result;
    for (auto &row : result)
      for (double &x : row)
        x = entry(random);
    return result;
  }

  /** A direction, all being equally likely. */
  inline Vector3<double>
  random_direction(Random &random)
  {
    std::normal_distribution<double> normal;
    const Vector3<double>            a = {
                 {normal(random), normal(random), normal(random)}};
    return (1 / norm(a)) * a;
  }

  /** Rotation about a unit vector by an angle (Rodrigues). */
  inline Matrix3<double>
  rotation(const Vector3<double> &axis, const double angle)
  {
    Matrix3<double> result;
    for (unsigned int j = 0; j < 3; ++j)
      {
        const Vector3<double> e = unit_matrix[j];
        const Vector3<double> column =
          std::cos(angle) * e + std::sin(angle) * cross(axis, e) +
          ((1 - std::cos(angle)) * dot(axis, e)) * axis;
        for (unsigned int i = 0; i < 3; ++i)
          result[i][j] = column[i];
      }
    return result;
  }

  inline Matrix3<double>
  random_rotation(Random &random)
  {
    std::uniform_real_distribution<double> angle(-M_PI, M_PI);
    return rotation(random_direction(random), angle(random));
  }

  /** Moves node at X by shift + H X. */
  inline void
  impose_gradient(State                 &state,
                  const Matrix3<double> &h,
                  const Vector3<double> &shift = {{0, 0, 0}})
  {
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      {
        const Vector3<double> u = shift + h * state.reference[i].vector();
        for (unsigned int d = 0; d < 3; ++d)
          state.displacement[i][d] = u[d];
      }
  }

  /** Displacement gradient of a deformation followed by a rotation. */
  inline Matrix3<double>
  rotated(const Matrix3<double> &r, const Matrix3<double> &h)
  {
    Matrix3<double> f = h;
    for (unsigned int d = 0; d < 3; ++d)
      f[d][d] += 1;
    f = product(r, f);
    for (unsigned int d = 0; d < 3; ++d)
      f[d][d] -= 1;
    return f;
  }

  /** Stiffness as C[i][j][k][l], Pa. */
  using Tensor4 = std::array<std::array<Matrix3<double>, 3>, 3>;

  /** Place of a pair of indices in 11, 22, 33, 23, 13, 12. */
  inline unsigned int
  place(const unsigned int i, const unsigned int j)
  {
    return i == j ? i : 6 - i - j;
  }

  /** The tensor of an anisotropic material in the frame of the mesh. */
  inline Tensor4
  stiffness_tensor(const MaterialParameters &material)
  {
    const Vector3<double> a1   = (1 / norm(material.axis_1)) * material.axis_1;
    const Vector3<double> n    = cross(a1, material.axis_2);
    const Vector3<double> a3   = (1 / norm(n)) * n;
    const Matrix3<double> axes = {{a1, cross(a3, a1), a3}};

    const auto constant = [&](unsigned int row, unsigned int column) {
      if (row > column)
        std::swap(row, column);
      return material.stiffness[row * 6 - row * (row + 1) / 2 + column];
    };
    Tensor4 result{};
    // All 81 components, each from all 81.
    for (unsigned int component = 0; component < 81; ++component)
      {
        const unsigned int i = component / 27, j = component / 9 % 3,
                           k = component / 3 % 3, l = component % 3;
        for (unsigned int p = 0; p < 3; ++p)
          for (unsigned int q = 0; q < 3; ++q)
            for (unsigned int r = 0; r < 3; ++r)
              for (unsigned int s = 0; s < 3; ++s)
                result[i][j][k][l] += axes[p][i] * axes[q][j] * axes[r][k] *
                                      axes[s][l] *
                                      constant(place(p, q), place(r, s));
      }
    return result;
  }

  /** Second Piola-Kirchhoff and Cauchy stress of a displacement gradient. */
  struct Stresses
  {
    Matrix3<double> second, cauchy;
  };

  inline Stresses
  stresses_of(const Tensor4 &c, const Matrix3<double> &h)
  {
    Matrix3<double> f = h, strain{};
    for (unsigned int i = 0; i < 3; ++i)
      {
        f[i][i] += 1;
        for (unsigned int j = 0; j < 3; ++j)
          {
            strain[i][j] = h[i][j] / 2 + h[j][i] / 2;
            for (unsigned int k = 0; k < 3; ++k)
              strain[i][j] += h[k][i] * h[k][j] / 2;
          }
      }
    Stresses result{};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = 0; l < 3; ++l)
            result.second[i][j] += c[i][j][k][l] * strain[k][l];
    result.cauchy = product(product(f, result.second), transpose(f));
    for (auto &row : result.cauchy)
      for (double &entry : row)
        entry /= determinant(f);
    return result;
  }

  /** A rock with a random positive definite stiffness in a random frame. */
  inline MaterialParameters
  random_anisotropic(Random &random)
  {
    std::normal_distribution<double>     normal;
    std::array<std::array<double, 6>, 6> factor;
    for (auto &row : factor)
      for (double &entry : row)
        entry = normal(random);
    MaterialParameters material;
    material.name       = "random";
    material.density    = 2600;
    material.elasticity = MaterialParameters::Elasticity::anisotropic;
    unsigned int k      = 0;
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = i; j < 6; ++j, ++k)
        {
          double sum = i == j ? 2 : 0;
          for (unsigned int m = 0; m < 6; ++m)
            sum += factor[i][m] * factor[j][m];
          material.stiffness[k] = 1e10 * sum;
        }
    const auto axes = random_rotation(random);
    material.axis_1 = 3. * axes[0];
    material.axis_2 = .5 * axes[1] + .7 * axes[0];
    return material;
  }

  inline MaterialParameters
  granite()
  {
    MaterialParameters material;
    material.name           = "granite";
    material.density        = 2641;
    material.youngs_modulus = 40.6e9;
    material.poissons_ratio = .2;
    return material;
  }
} // namespace rift::test

#endif
