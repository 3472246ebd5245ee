#include <rift/material/elasticity.h>

namespace rift
{
  StiffnessMatrix
  IsotropicElasticity::stiffness(const MaterialParameters &p)
  {
    return stiffness_matrix(make(p));
  }

  StiffnessMatrix
  isotropic_stiffness(const MaterialParameters &p)
  {
    return IsotropicElasticity::stiffness(p);
  }

  StiffnessMatrix
  stiffness_in_material_axes(const MaterialParameters &p)
  {
    StiffnessMatrix result{};
    for_each_elastic_law([&](const auto &law) {
      if (p.elasticity == law.name)
        result = law.stiffness(p);
    });
    return result;
  }

  Elasticity
  make_elasticity(const MaterialParameters &p)
  {
    Elasticity result;
    for_each_elastic_law([&](const auto &law) {
      if (p.elasticity == law.name)
        result = law.make(p);
    });
    return result;
  }

  StiffnessMatrix
  stiffness_matrix(const Elasticity &elasticity)
  {
    StiffnessMatrix result;
    for (unsigned int j = 0; j < 6; ++j)
      {
        SymmetricTensor<double> strain{};
        strain[j] = j < 3 ? 1. : .5;
        const auto column =
          std::visit([&](const auto &law) { return law.stress(strain); },
                     elasticity);
        for (unsigned int i = 0; i < 6; ++i)
          result[i][j] = column[i];
      }
    return result;
  }

  double
  mean_youngs_modulus(const StiffnessMatrix &c)
  {
    const double normal  = c[0][0] + c[1][1] + c[2][2];
    const double lateral = c[0][1] + c[1][2] + c[2][0];
    const double bulk    = (normal + 2 * lateral) / 9;
    const double shear =
      (normal - lateral + 3 * (c[3][3] + c[4][4] + c[5][5])) / 15;
    return 9 * bulk * shear / (3 * bulk + shear);
  }

  Matrix3<double>
  material_axes(const Vector3<double> &axis_1, const Vector3<double> &axis_2)
  {
    Matrix3<double> axes;
    axes[0] = (1. / norm(axis_1)) * axis_1;
    axes[1] = axis_2 - dot(axis_2, axes[0]) * axes[0];
    axes[1] = (1. / norm(axes[1])) * axes[1];
    axes[2] = cross(axes[0], axes[1]);
    return axes;
  }

  StiffnessMatrix
  rotate_stiffness(const StiffnessMatrix &stiffness,
                   const Matrix3<double> &axes)
  {
    // Bond's matrix M: stress row in the frame of the mesh = M x row in
    // material axes; then C' = M C M^T.
    constexpr std::array<std::array<unsigned int, 2>, 6> pairs = {
      {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{1, 2}}, {{0, 2}}, {{0, 1}}}};
    StiffnessMatrix bond, product{}, result{};
    for (unsigned int row = 0; row < 6; ++row)
      for (unsigned int column = 0; column < 6; ++column)
        {
          const auto [i, j] = pairs[row];
          const auto [k, l] = pairs[column];
          bond[row][column] = axes[k][i] * axes[l][j];
          if (k != l)
            bond[row][column] += axes[l][i] * axes[k][j];
        }
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        for (unsigned int k = 0; k < 6; ++k)
          product[i][j] += bond[i][k] * stiffness[k][j];
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        for (unsigned int k = 0; k < 6; ++k)
          result[i][j] += product[i][k] * bond[j][k];
    return result;
  }
} // namespace rift
