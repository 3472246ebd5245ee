#include <rift/material/wave_speeds.h>

#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace rift
{
  namespace
  {
    /** Of a symmetric matrix; eigenvectors are rows. */
    struct Eigensystem
    {
      explicit Eigensystem(Matrix3<double> matrix)
      {
        Matrix3<double> columns;
        gsl_matrix_view of_matrix =
          gsl_matrix_view_array(matrix[0].data(), 3, 3);
        gsl_matrix_view of_vectors =
          gsl_matrix_view_array(columns[0].data(), 3, 3);
        gsl_vector_view of_values = gsl_vector_view_array(values.data(), 3);
        const std::unique_ptr<gsl_eigen_symmv_workspace,
                              decltype(&gsl_eigen_symmv_free)>
          workspace(gsl_eigen_symmv_alloc(3), gsl_eigen_symmv_free);
        gsl_eigen_symmv(&of_matrix.matrix,
                        &of_values.vector,
                        &of_vectors.matrix,
                        workspace.get());
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            vectors[i][j] = columns[j][i];
      }

      std::array<double, 3> values;
      Matrix3<double>       vectors;
    };
  } // namespace

  std::array<double, 3>
  wave_speeds(const StiffnessMatrix &stiffness,
              const double           density,
              const Vector3<double> &direction)
  {
    const Vector3<double> n = (1 / norm(direction)) * direction;
    const Eigensystem     system(acoustic_matrix(stiffness, n, n));
    std::array<double, 3> speeds;
    for (unsigned int i = 0; i < 3; ++i)
      speeds[i] = std::sqrt(system.values[i] / density);
    std::sort(speeds.begin(), speeds.end(), std::greater<>());
    return speeds;
  }

  Matrix3<double>
  impedance(const StiffnessMatrix &stiffness,
            const double           density,
            const Vector3<double> &normal)
  {
    const Eigensystem system(acoustic_matrix(stiffness, normal, normal));
    Matrix3<double>   result{};
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int i = 0; i < 3; ++i)
        result[i] +=
          (std::sqrt(density * system.values[k]) * system.vectors[k][i]) *
          system.vectors[k];
    return result;
  }
} // namespace rift
