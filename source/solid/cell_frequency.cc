#include <rift/solid/cell_frequency.h>

#include <cmath>

namespace rift
{
  namespace
  {
    StiffnessMatrix
    product(const StiffnessMatrix &a, const StiffnessMatrix &b)
    {
      StiffnessMatrix result{};
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int k = 0; k < 6; ++k)
          for (unsigned int j = 0; j < 6; ++j)
            result[i][j] += a[i][k] * b[k][j];
      return result;
    }

    double
    trace(const StiffnessMatrix &a)
    {
      double sum = 0;
      for (unsigned int i = 0; i < 6; ++i)
        sum += a[i][i];
      return sum;
    }

    /** B B^T of a linear tetrahedron in Voigt's notation, 1/m^2. */
    StiffnessMatrix
    gradient_products(const ReferenceBatch &reference, const unsigned int lane)
    {
      StiffnessMatrix result{};
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          const Vector3<double> g = reference.gradient(c, lane);
          // Strain rows that a unit displacement of this corner along x, y
          // and z makes.
          const double b[3][6] = {{g[0], 0, 0, 0, g[2], g[1]},
                                  {0, g[1], 0, g[2], 0, g[0]},
                                  {0, 0, g[2], g[1], g[0], 0}};
          for (const auto &row : b)
            for (unsigned int i = 0; i < 6; ++i)
              for (unsigned int j = 0; j < 6; ++j)
                result[i][j] += row[i] * row[j];
        }
      return result;
    }
  } // namespace

  double
  largest_frequency_squared(const ReferenceBatch  &reference,
                            const unsigned int     lane,
                            const StiffnessMatrix &stiffness,
                            const double           density)
  {
    StiffnessMatrix power =
      product(stiffness, gradient_products(reference, lane));
    // log of the trace of power^(2^k), over 2^k: powers are taken by squaring
    // and scaled to unit trace to stay in range.
    double log_bound = 0, weight = 1;
    for (unsigned int squaring = 0; squaring <= 6; ++squaring)
      {
        if (squaring > 0)
          {
            power = product(power, power);
            weight /= 2;
          }
        const double scale = trace(power);
        // Rigid cells have no stiffness.
        if (scale == 0)
          return 0;
        log_bound += weight * std::log(scale);
        for (auto &row : power)
          for (double &entry : row)
            entry /= scale;
      }
    return 4 / density * std::exp(log_bound);
  }
} // namespace rift
