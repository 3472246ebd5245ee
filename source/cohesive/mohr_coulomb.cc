#include <rift/cohesive/laws/mohr_coulomb.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /**
     * One over the irreversible jump that spends the fracture energy, and what
     * the elastic branch holds at the start, less what the excess spends; but
     * not so short that the softening snaps back.
     */
    double
    inverse_separation(const double strength,
                       const double fracture_energy,
                       const double traction,
                       const double excess,
                       const double stiffness)
    {
      const double energy =
        fracture_energy + .5 * traction * traction / stiffness -
        .5 * excess * excess / (MohrCoulomb::excess_slope * stiffness);
      const double shortest =
        MohrCoulomb::shortest_separation * strength / stiffness;
      return strength > 0 ?
               1 /
                 std::max(energy / (Softening::integral * strength), shortest) :
               0;
    }

    void
    set_separations(CohesivePoint<double> &point,
                    const Vector3<double> &traction,
                    const FaceStrength    &strength,
                    const double           stiffness)
    {
      point.inverse_opening = inverse_separation(strength.tensile_strength,
                                                 strength.fracture_energy_1,
                                                 std::max(traction[0], 0.),
                                                 point.normal_excess,
                                                 stiffness);
      point.inverse_slip =
        inverse_separation(point.cohesion,
                           strength.fracture_energy_2,
                           std::hypot(traction[1], traction[2]),
                           point.shear_excess,
                           stiffness);
    }
  } // namespace

  CohesiveConstants<double>
  make_constants(const FaceStrength &strength, const double stiffness)
  {
    return {stiffness, strength.tensile_strength, strength.tan_friction_angle};
  }

  CohesivePoint<double>
  make_cohesive_point(const FaceStrength &strength, const double stiffness)
  {
    CohesivePoint<double> point{};
    point.softening = 1;
    point.cohesion  = strength.cohesion;
    set_separations(point, {{0, 0, 0}}, strength, stiffness);
    return point;
  }

  bool
  is_separation_too_short(const FaceStrength &strength, const double stiffness)
  {
    const auto is_too_short = [stiffness](const double of_strength,
                                          const double energy) {
      return Softening::integral * MohrCoulomb::shortest_separation *
               of_strength * of_strength / stiffness >
             energy;
    };
    return is_too_short(strength.tensile_strength,
                        strength.fracture_energy_1) ||
           is_too_short(strength.cohesion, strength.fracture_energy_2);
  }

  double
  hold_traction(CohesivePoint<double> &point,
                const Vector3<double> &jump,
                const Vector3<double> &more,
                const FaceStrength    &strength,
                const double           stiffness)
  {
    const Vector3<double> before = point.traction;
    const Vector3<double> t      = before + more;
    const double friction = strength.tan_friction_angle * std::max(-t[0], 0.);
    const double tensile_strength = point.softening * strength.tensile_strength;
    const double cohesion         = point.softening * strength.cohesion;
    const double shear            = std::hypot(t[1], t[2]) - friction;
    // A face that opens in tension has the shear strength that it needs.
    if (t[0] > 0 && point.softening > 0 &&
        t[0] * cohesion > shear * tensile_strength)
      point.cohesion = std::min(shear / point.softening, strength.cohesion);
    point.normal_excess = std::max(0., t[0] - tensile_strength);
    point.shear_excess = std::max(0., shear - point.softening * point.cohesion);
    point.traction     = t;
    // A failed point that is open keeps its place of closing as offset, which
    // is none of its elastic branch.
    if (point.softening <= 0 && before[0] == 0)
      point.offset[0] = jump[0];
    point.offset -= (1 / stiffness) * more;
    set_separations(point, t, strength, stiffness);
    return .5 * (dot(t, t) - dot(before, before)) / stiffness;
  }
} // namespace rift
