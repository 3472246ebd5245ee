#include <rift/material/microcracks.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace rift
{
  namespace
  {
    using Matrix6 = std::array<std::array<double, 6>, 6>;

    /** Tensor components of each of Voigt's rows. */
    constexpr std::array<std::array<unsigned int, 2>, 6> components = {
      {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{1, 2}}, {{0, 2}}, {{0, 1}}}};

    /** Row of Voigt of a tensor component. */
    constexpr unsigned int
    row_of(const unsigned int i, const unsigned int j)
    {
      return i == j ? i : 6 - i - j;
    }

    /** A compliance, 1/Pa, in Kelvin's notation: shear rows times sqrt(2), so
     * that matrices multiply and invert like the tensors. */
    using Compliance = Matrix6;

    double
    kelvin_factor(const unsigned int row, const unsigned int column)
    {
      return (row < 3 ? 1 : M_SQRT2) * (column < 3 ? 1 : M_SQRT2);
    }

    /** Of a symmetric matrix; empty if it is not positive definite. */
    std::optional<Matrix6>
    definite_inverse(Matrix6 matrix)
    {
      // The library would end the program otherwise.
      gsl_error_handler_t *handler = gsl_set_error_handler_off();
      gsl_matrix_view      view    = gsl_matrix_view_array(&matrix[0][0], 6, 6);
      gsl_matrix          *of_gsl  = &view.matrix;
      const bool is_good = gsl_linalg_cholesky_decomp1(of_gsl) == GSL_SUCCESS &&
                           gsl_linalg_cholesky_invert(of_gsl) == GSL_SUCCESS;
      gsl_set_error_handler(handler);
      // It also passes what is not a number.
      double sum = 0;
      for (const auto &row : matrix)
        for (const double entry : row)
          sum += entry;
      if (!is_good || !std::isfinite(sum))
        return {};
      return matrix;
    }

    std::optional<StiffnessMatrix>
    stiffness_of(const Compliance &compliance)
    {
      auto result = definite_inverse(compliance);
      for (unsigned int i = 0; i < 6 && result; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          (*result)[i][j] /= kelvin_factor(i, j);
      return result;
    }

    std::optional<Compliance>
    compliance_of(StiffnessMatrix stiffness)
    {
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          stiffness[i][j] *= kelvin_factor(i, j);
      return definite_inverse(stiffness);
    }

    void
    add(const double factor, const Compliance &more, Compliance &sum)
    {
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          sum[i][j] += factor * more[i][j];
    }

    /** Points and weights of Gauss on [0, 1]. */
    struct GaussPoints
    {
      explicit GaussPoints(const std::size_t n)
        : points(n)
        , weights(n)
      {
        const std::unique_ptr<gsl_integration_glfixed_table,
                              decltype(&gsl_integration_glfixed_table_free)>
          table(gsl_integration_glfixed_table_alloc(n),
                gsl_integration_glfixed_table_free);
        for (std::size_t i = 0; i < n; ++i)
          gsl_integration_glfixed_point(0,
                                        1,
                                        i,
                                        &points[i],
                                        &weights[i],
                                        table.get());
      }

      std::vector<double> points, weights;
    };

    /** Two directions across a unit vector and across each other. */
    std::array<Vector3<double>, 2>
    tangents(const Vector3<double> &normal)
    {
      unsigned int smallest = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (std::abs(normal[d]) < std::abs(normal[smallest]))
          smallest = d;
      Vector3<double> first{};
      first[smallest] = 1;
      first -= dot(first, normal) * normal;
      first = (1 / norm(first)) * first;
      return {{first, cross(normal, first)}};
    }

    /** Compliance per density of cracks across a normal. */
    Compliance
    of_aligned(const StiffnessMatrix &stiffness, const Vector3<double> &normal)
    {
      const Vector3<double> n = (1 / norm(normal)) * normal;
      const Matrix3<double> q = inverse(crack_resistance(stiffness, n));
      Compliance            result;
      for (unsigned int row = 0; row < 6; ++row)
        for (unsigned int column = 0; column < 6; ++column)
          {
            const auto [i, j] = components[row];
            const auto [k, l] = components[column];
            result[row][column] =
              M_PI / 3 * kelvin_factor(row, column) *
              (n[i] * q[j][k] * n[l] + n[j] * q[i][k] * n[l] +
               n[i] * q[j][l] * n[k] + n[j] * q[i][l] * n[k]);
          }
      return result;
    }

    /** Compliance per density of cracks across all directions alike. */
    Compliance
    of_random(const StiffnessMatrix &stiffness)
    {
      // Half of the sphere: opposite normals are the same.
      constexpr unsigned int   n_around = 12;
      static const GaussPoints cosines(6);
      Compliance               mean{};
      for (std::size_t a = 0; a < cosines.points.size(); ++a)
        for (unsigned int b = 0; b < n_around; ++b)
          {
            const double c = cosines.points[a], s = std::sqrt(1 - c * c);
            const double phi = 2 * M_PI * (b + .5) / n_around;
            add(cosines.weights[a] / n_around,
                of_aligned(stiffness,
                           {{s * std::cos(phi), s * std::sin(phi), c}}),
                mean);
          }
      return mean;
    }

    /** Compliance of all groups in a material of this stiffness. */
    Compliance
    of_groups(const StiffnessMatrix         &stiffness,
              const std::vector<CrackGroup> &groups)
    {
      Compliance sum{};
      for (const CrackGroup &group : groups)
        if (group.density > 0)
          add(group.density,
              group.normal ? of_aligned(stiffness, *group.normal) :
                             of_random(stiffness),
              sum);
      return sum;
    }

    /** Adds cracks little by little: d S = of_groups(S^-1) over their share,
     * by the method of Runge and Kutta of fourth order. */
    bool
    integrate(const std::vector<CrackGroup> &groups, Compliance &compliance)
    {
      // An error of some 1e-6 at all densities.
      constexpr double n_steps_per_density = 40, least_number_of_steps = 8;
      double           density = 0;
      for (const CrackGroup &group : groups)
        density += group.density;
      const auto n_steps = static_cast<unsigned int>(std::ceil(
        std::max(n_steps_per_density * density, least_number_of_steps)));
      const auto rate    = [&](const Compliance &s) {
        const auto stiffness = stiffness_of(s);
        return stiffness ? of_groups(*stiffness, groups) : Compliance{};
      };
      const double step = 1. / n_steps;
      for (unsigned int i = 0; i < n_steps; ++i)
        {
          Compliance       change    = rate(compliance), sum{};
          constexpr double shares[]  = {.5, .5, 1},
                           weights[] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
          for (unsigned int stage = 0; stage < 4; ++stage)
            {
              add(weights[stage], change, sum);
              if (stage == 3)
                break;
              Compliance there = compliance;
              add(shares[stage] * step, change, there);
              change = rate(there);
            }
          add(step, sum, compliance);
        }
      return stiffness_of(compliance).has_value();
    }

    /** The compliance in which the cracks add just what it has more than the
     * intact one. */
    bool
    iterate(const std::vector<CrackGroup> &groups, Compliance &compliance)
    {
      constexpr unsigned int largest_number_of_iterations = 1000;
      const Compliance       intact                       = compliance;
      for (unsigned int i = 0; i < largest_number_of_iterations; ++i)
        {
          const auto stiffness = stiffness_of(compliance);
          if (!stiffness)
            return false;
          Compliance next = intact;
          add(1, of_groups(*stiffness, groups), next);
          double change = 0, size = 0;
          for (unsigned int row = 0; row < 6; ++row)
            for (unsigned int column = 0; column < 6; ++column)
              {
                change = std::max(
                  change,
                  std::abs(next[row][column] - compliance[row][column]));
                size = std::max(size, std::abs(next[row][column]));
              }
          if (!(size < 1e6 * intact[0][0]))
            return false;
          compliance = next;
          if (change < 1e-13 * size)
            return true;
        }
      return false;
    }
  } // namespace

  Matrix3<double>
  acoustic_matrix(const StiffnessMatrix &c,
                  const Vector3<double> &u,
                  const Vector3<double> &v)
  {
    Matrix3<double> result{};
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int l = 0; l < 3; ++l)
            result[j][k] += u[i] * c[row_of(i, j)][row_of(k, l)] * v[l];
    return result;
  }

  Matrix3<double>
  crack_resistance(const StiffnessMatrix &stiffness,
                   const Vector3<double> &normal)
  {
    constexpr unsigned int   n_around = 16;
    static const GaussPoints angles(12);
    const auto               t  = tangents(normal);
    const auto               nn = acoustic_matrix(stiffness, normal, normal);
    Matrix3<double>          sum{};
    // Half of the sphere: opposite directions give the same. With z = c n + s e
    // all that C has to say is in three matrices.
    for (unsigned int b = 0; b < n_around; ++b)
      {
        const double          phi = 2 * M_PI * (b + .5) / n_around;
        const Vector3<double> e   = std::cos(phi) * t[0] + std::sin(phi) * t[1];
        const auto            ne  = acoustic_matrix(stiffness, normal, e);
        const auto            ee  = acoustic_matrix(stiffness, e, e);
        for (std::size_t a = 0; a < angles.points.size(); ++a)
          {
            const double theta = M_PI / 2 * angles.points[a];
            const double s = std::sin(theta), c = std::cos(theta);
            const double weight =
              M_PI / 2 * angles.weights[a] / (n_around * s * s);
            Matrix3<double> nz, zn, zz;
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = 0; j < 3; ++j)
                {
                  nz[i][j] = zn[j][i] = c * nn[i][j] + s * ne[i][j];
                  zz[i][j] = c * c * nn[i][j] + c * s * (ne[i][j] + ne[j][i]) +
                             s * s * ee[i][j];
                }
            const auto p = nz * (inverse(zz) * zn);
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int j = 0; j < 3; ++j)
                sum[i][j] += weight * (nn[i][j] - p[i][j]);
          }
      }
    return sum;
  }

  std::optional<StiffnessMatrix>
  stiffness_with_cracks(const StiffnessMatrix         &intact,
                        const std::vector<CrackGroup> &groups,
                        const CrackScheme              scheme)
  {
    const auto of_intact = compliance_of(intact);
    if (!of_intact)
      return {};
    Compliance compliance = *of_intact;
    bool       is_good    = true;
    switch (scheme)
      {
      case CrackScheme::differential:
        is_good = integrate(groups, compliance);
        break;
      case CrackScheme::differential_in_order:
        for (const CrackGroup &group : groups)
          is_good = is_good && integrate({group}, compliance);
        break;
      case CrackScheme::dilute:
        add(1, of_groups(intact, groups), compliance);
        break;
      case CrackScheme::self_consistent:
        is_good = iterate(groups, compliance);
        break;
      }
    if (!is_good)
      return {};
    return stiffness_of(compliance);
  }
} // namespace rift
