#include <rift/material/wave_speeds.h>

#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace rift
{
  std::array<double, 3>
  wave_speeds(const StiffnessMatrix &stiffness,
              const double           density,
              const Vector3<double> &direction)
  {
    const Vector3<double> n      = (1 / norm(direction)) * direction;
    Matrix3<double>       matrix = acoustic_matrix(stiffness, n, n);
    std::array<double, 3> eigenvalues;
    gsl_matrix_view matrix_view = gsl_matrix_view_array(matrix[0].data(), 3, 3);
    gsl_vector_view values_view = gsl_vector_view_array(eigenvalues.data(), 3);
    const std::unique_ptr<gsl_eigen_symm_workspace,
                          decltype(&gsl_eigen_symm_free)>
      workspace(gsl_eigen_symm_alloc(3), gsl_eigen_symm_free);
    gsl_eigen_symm(&matrix_view.matrix, &values_view.vector, workspace.get());
    std::array<double, 3> speeds;
    for (unsigned int i = 0; i < 3; ++i)
      speeds[i] = std::sqrt(eigenvalues[i] / density);
    std::sort(speeds.begin(), speeds.end(), std::greater<>());
    return speeds;
  }
} // namespace rift
