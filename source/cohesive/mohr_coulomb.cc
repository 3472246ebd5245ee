#include <rift/cohesive/laws/mohr_coulomb.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /**
     * One over the irreversible jump that spends the fracture energy and what
     * the elastic branch holds at the start, but not so short that the
     * softening snaps back.
     */
    double
    inverse_separation(const double strength,
                       const double fracture_energy,
                       const double traction,
                       const double stiffness)
    {
      const double energy =
        fracture_energy + .5 * traction * traction / stiffness;
      return std::min(Softening::integral * strength / energy,
                      stiffness /
                        (MohrCoulomb::shortest_separation * strength));
    }

    void
    set_separations(CohesivePoint<double> &point,
                    const Vector3<double> &traction,
                    const FaceStrength    &strength,
                    const double           stiffness)
    {
      point.inverse_opening = inverse_separation(point.tensile_strength,
                                                 strength.fracture_energy_1,
                                                 std::max(traction[0], 0.),
                                                 stiffness);
      point.inverse_slip =
        inverse_separation(point.cohesion,
                           strength.fracture_energy_2,
                           std::hypot(traction[1], traction[2]),
                           stiffness);
    }
  } // namespace

  CohesivePoint<double>
  make_cohesive_point(const FaceStrength &strength, const double stiffness)
  {
    CohesivePoint<double> point{};
    point.softening        = 1;
    point.tensile_strength = strength.tensile_strength;
    point.cohesion         = strength.cohesion;
    set_separations(point, {{0, 0, 0}}, strength, stiffness);
    return point;
  }

  double
  hold_traction(CohesivePoint<double> &point,
                const Vector3<double> &jump,
                const Vector3<double> &more,
                const FaceStrength    &strength,
                const double           stiffness)
  {
    constexpr double least_softening = .1;

    const Vector3<double> before = traction_at(point, jump, stiffness);
    Vector3<double>       t      = before + more;
    const double friction = strength.tan_friction_angle * std::max(-t[0], 0.);
    const double shear    = std::hypot(t[1], t[2]);
    if (point.softening > least_softening)
      {
        point.tensile_strength =
          std::max(point.tensile_strength, t[0] / point.softening);
        point.cohesion =
          std::max(point.cohesion, (shear - friction) / point.softening);
      }
    else
      {
        t[0] = std::min(t[0], point.softening * point.tensile_strength);
        const double limit = point.softening * point.cohesion + friction;
        if (shear > limit)
          for (unsigned int d = 1; d < 3; ++d)
            t[d] *= limit / shear;
      }
    point.offset = jump - (1 / stiffness) * t;
    set_separations(point, t, strength, stiffness);
    return .5 * (dot(t, t) - dot(before, before)) / stiffness;
  }
} // namespace rift
