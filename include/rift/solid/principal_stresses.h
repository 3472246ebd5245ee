#ifndef rift_solid_principal_stresses_h
#define rift_solid_principal_stresses_h

#include <rift/material/elasticity.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  /** Principal values of a stress, the largest first, by the angle of Lode; of
   * a matrix that is not quite symmetric those of its symmetric part. */
  inline Vector3<double>
  principal_stresses(const Matrix3<double> &stress)
  {
    const double    mean = (stress[0][0] + stress[1][1] + stress[2][2]) / 3;
    Matrix3<double> deviator;
    double          square = 0;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          deviator[i][j] =
            .5 * (stress[i][j] + stress[j][i]) - (i == j ? mean : 0);
          square += deviator[i][j] * deviator[i][j];
        }
    const double radius = std::sqrt(square / 6);
    if (radius == 0)
      return {{mean, mean, mean}};
    const double determinant =
      dot(deviator[0], cross(deviator[1], deviator[2]));
    const double angle =
      std::acos(
        std::clamp(.5 * determinant / (radius * radius * radius), -1., 1.)) /
      3;
    return {{mean + 2 * radius * std::cos(angle),
             mean + 2 * radius * std::cos(angle - 2 * M_PI / 3),
             mean + 2 * radius * std::cos(angle + 2 * M_PI / 3)}};
  }

  /** The three principal stresses, the largest first, Pa. */
  inline Vector3<double>
  principal_stresses(const SymmetricTensor<double> &stress)
  {
    Matrix3<double> matrix;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        matrix[i][j] = stress[voigt[i][j]];
    return principal_stresses(matrix);
  }
} // namespace rift

#endif
