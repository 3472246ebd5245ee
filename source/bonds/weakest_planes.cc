#include <deal.II/base/symmetric_tensor.h>

#include <rift/bonds/weakest_planes.h>
#include <rift/solid/principal_stresses.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  PlaneTraction
  traction_on(const SymmetricTensor<double> &stress,
              const Vector3<double>         &normal)
  {
    Vector3<double> traction{};
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        traction[i] += stress[voigt[i][j]] * normal[j];
    const double along = dot(traction, normal);
    return {along, norm(traction - along * normal)};
  }

  double
  demand_on(const PlaneTraction &traction, const FaceStrength &strength)
  {
    return std::max(
      traction.normal / strength.tensile_strength,
      (traction.shear + traction.normal * strength.tan_friction_angle) /
        strength.cohesion);
  }

  namespace
  {
    /** Largest demands of all planes. */
    struct Demands
    {
      double tension, shear;
    };

    Demands
    demands_of(const Vector3<double> &principal, const FaceStrength &strength)
    {
      const double tan    = strength.tan_friction_angle;
      const double radius = .5 * (principal[0] - principal[2]);
      const double centre = .5 * (principal[0] + principal[2]);
      return {principal[0] / strength.tensile_strength,
              (radius * std::sqrt(1 + tan * tan) + centre * tan) /
                strength.cohesion};
    }

    struct Principal
    {
      Vector3<double>                  stresses;
      std::array<Vector3<double>, dim> directions;
    };

    /** Principal stresses, the largest first, and their directions. */
    Principal
    principal(const SymmetricTensor<double> &stress)
    {
      dealii::SymmetricTensor<2, dim> tensor;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          tensor[i][j] = stress[voigt[i][j]];
      const auto pairs =
        dealii::eigenvectors(tensor,
                             dealii::SymmetricTensorEigenvectorMethod::jacobi);
      Principal result;
      for (unsigned int k = 0; k < dim; ++k)
        {
          result.stresses[k] = pairs[k].first;
          for (unsigned int d = 0; d < dim; ++d)
            result.directions[k][d] = pairs[k].second[d];
        }
      return result;
    }

    /** Moves a unit normal to a maximum of a demand near to it, in steps to eight
     * sides that become smaller. */
    template <typename Demand>
    void
    climb(const Demand &demand, double &best, Vector3<double> &normal)
    {
      for (double step = .1; step > 1e-4;)
        {
          Vector3<double> a                   = {{0, 0, 0}};
          a[std::abs(normal[0]) < .6 ? 0 : 1] = 1;
          a                                   = cross(normal, a);
          a                                   = (1 / norm(a)) * a;
          const Vector3<double> b             = cross(normal, a);
          bool                  is_better     = false;
          for (unsigned int side = 0; side < 8 && !is_better; ++side)
            {
              const double    angle = .25 * M_PI * side;
              Vector3<double> next  = normal + (step * std::cos(angle)) * a +
                                     (step * std::sin(angle)) * b;
              next      = (1 / norm(next)) * next;
              is_better = demand(next) > best;
              if (is_better)
                {
                  best   = demand(next);
                  normal = next;
                }
            }
          if (!is_better)
            step *= .5;
        }
    }

    /** Unit vectors that are spread evenly over half a sphere (a spiral of the
     * golden section). */
    std::vector<Vector3<double>>
    spread_directions()
    {
      constexpr unsigned int       n      = 200;
      const double                 golden = M_PI * (3 - std::sqrt(5.));
      std::vector<Vector3<double>> result;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double z = (i + .5) / n, r = std::sqrt(1 - z * z);
          result.push_back(
            {{r * std::cos(golden * i), r * std::sin(golden * i), z}});
        }
      return result;
    }
  } // namespace

  double
  largest_demand(const SymmetricTensor<double> &stress,
                 const FaceStrength            &strength)
  {
    const Demands demands = demands_of(principal_stresses(stress), strength);
    return std::max(demands.tension, demands.shear);
  }

  WeakestPlanes
  weakest_planes(const SymmetricTensor<double> &stress,
                 const FaceStrength            &strength)
  {
    const auto [s, e]     = principal(stress);
    const Demands demands = demands_of(s, strength);
    if (demands.tension >= demands.shear)
      return {demands.tension, false, {e[0]}};
    const double          tan   = strength.tan_friction_angle;
    const double          angle = .25 * M_PI + .5 * std::atan(tan);
    const Vector3<double> a     = std::sin(angle) * e[0];
    const Vector3<double> b     = std::cos(angle) * e[2];
    return {demands.shear, true, {a + b, a - b}};
  }

  WeakestPlanes
  weakest_planes(const SymmetricTensor<double> &stress,
                 const StrengthAcross          &strength_across)
  {
    static const auto directions = spread_directions();
    const auto        demand     = [&](const Vector3<double> &normal) {
      return demand_on(traction_on(stress, normal), strength_across(normal));
    };
    std::vector<std::pair<double, Vector3<double>>> starts;
    for (const Vector3<double> &direction : directions)
      starts.push_back({demand(direction), direction});
    // There may be several maxima, each with a start near to it.
    constexpr std::ptrdiff_t n_starts = 16;
    std::partial_sort(
      starts.begin(),
      starts.begin() + n_starts,
      starts.end(),
      [](const auto &a, const auto &b) { return a.first > b.first; });
    double          best = -std::numeric_limits<double>::max();
    Vector3<double> normal{};
    for (auto start = starts.begin(); start != starts.begin() + n_starts;
         ++start)
      {
        // A start far below the best one leads no higher.
        constexpr double far_below = .7;
        if (start->first < far_below * best)
          break;
        climb(demand, start->first, start->second);
        if (start->first > best)
          {
            best   = start->first;
            normal = start->second;
          }
      }
    const PlaneTraction traction = traction_on(stress, normal);
    return {best,
            traction.normal / strength_across(normal).tensile_strength < best,
            {normal}};
  }
} // namespace rift
