#include <deal.II/base/symmetric_tensor.h>

#include <rift/bonds/weakest_planes.h>
#include <rift/solid/principal_stresses.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

  DirectionalPlanes::DirectionalPlanes(StrengthAcross strength_across)
    : strength_across(std::move(strength_across))
    , directions(spread_directions())
  {
    for (const Vector3<double> &direction : directions)
      {
        const FaceStrength strength = this->strength_across(direction);
        for (unsigned int d = 0; d < dim; ++d)
          normals[d].push_back(direction[d]);
        inverse_tension.push_back(1 / strength.tensile_strength);
        inverse_cohesion.push_back(1 / strength.cohesion);
        friction.push_back(strength.tan_friction_angle);
      }
  }

  void
  DirectionalPlanes::find_demands(const SymmetricTensor<double> &stress,
                                  const double                   margin,
                                  std::vector<double>           &demands) const
  {
    demands.resize(directions.size());
    // As demand_on(), in a form that is vectorised.
    for (std::size_t i = 0; i < directions.size(); ++i)
      {
        const double n[3] = {normals[0][i], normals[1][i], normals[2][i]};
        double       t[3];
        for (unsigned int a = 0; a < dim; ++a)
          t[a] = stress[voigt[a][0]] * n[0] + stress[voigt[a][1]] * n[1] +
                 stress[voigt[a][2]] * n[2];
        const double normal = t[0] * n[0] + t[1] * n[1] + t[2] * n[2];
        const double shear_squared =
          t[0] * t[0] + t[1] * t[1] + t[2] * t[2] - normal * normal;
        const double shear =
          margin + std::sqrt(shear_squared > 0 ? shear_squared : 0);
        const double along      = margin + normal;
        const double of_tension = along * inverse_tension[i];
        const double of_shear =
          (shear + along * friction[i]) * inverse_cohesion[i];
        demands[i] = of_tension > of_shear ? of_tension : of_shear;
      }
  }

  double
  DirectionalPlanes::bound_of_demand(
    const SymmetricTensor<double> &stress) const
  {
    constexpr double      share  = .03;
    const Vector3<double> s      = principal_stresses(stress);
    const double          margin = share * (s[0] - s[2]);
    std::vector<double>   demands;
    find_demands(stress, margin, demands);
    return *std::max_element(demands.begin(), demands.end());
  }

  WeakestPlanes
  DirectionalPlanes::weakest(const SymmetricTensor<double> &stress) const
  {
    std::vector<double> demands;
    find_demands(stress, 0, demands);
    std::vector<std::size_t> order(demands.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(),
                     order.end(),
                     [&demands](const std::size_t a, const std::size_t b) {
                       return demands[a] > demands[b];
                     });
    const auto demand = [&](const Vector3<double> &normal) {
      return demand_on(traction_on(stress, normal), strength_across(normal));
    };
    // There may be several maxima. A start far below the best leads no higher,
    // and one beside another leads where that does.
    constexpr double             far_below = .7, cosine_of_beside = .94;
    double                       best = -std::numeric_limits<double>::max();
    Vector3<double>              normal{};
    std::vector<Vector3<double>> starts;
    for (const std::size_t i : order)
      {
        const Vector3<double> &start = directions[i];
        if (demands[i] < far_below * best)
          break;
        if (std::any_of(starts.begin(),
                        starts.end(),
                        [&start](const Vector3<double> &other) {
                          return std::abs(dot(start, other)) > cosine_of_beside;
                        }))
          continue;
        starts.push_back(start);
        double          reached = demands[i];
        Vector3<double> at      = start;
        climb(demand, reached, at);
        if (reached > best)
          {
            best   = reached;
            normal = at;
          }
      }
    const PlaneTraction traction = traction_on(stress, normal);
    return {best,
            traction.normal / strength_across(normal).tensile_strength < best,
            {normal}};
  }
} // namespace rift
