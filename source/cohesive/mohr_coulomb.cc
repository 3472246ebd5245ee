#include <rift/cohesive/laws/mohr_coulomb.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** Jump beyond the envelope over which a mode softens, m, if nothing but the
     * fracture energy counts. */
    double
    separation(const double strength, const double fracture_energy)
    {
      return fracture_energy / (Softening::integral * strength);
    }

    /** The shortest one, m. */
    double
    least_separation(const double strength, const double stiffness)
    {
      return shortest_separation * strength / stiffness;
    }

    /** Elastic energy of tension and of the shear that the cohesion carries,
     * J/m^2. */
    double
    cohesive_energy(const Vector3<double> &traction,
                    const double           friction_coefficient,
                    const double           stiffness)
    {
      const double tension  = std::max(traction[0], 0.);
      const double friction = friction_coefficient * std::max(-traction[0], 0.);
      const double shear =
        std::max(std::hypot(traction[1], traction[2]) - friction, 0.);
      return .5 * (tension * tension + shear * shear) / stiffness;
    }
  } // namespace

  template <typename Branch>
  MohrCoulombConstants<double>
  MohrCoulomb<Branch>::make_constants(const FaceStrength &strength,
                                      const double        stiffness)
  {
    const auto inverse = [stiffness](const double of_strength,
                                     const double energy) {
      return 1 / std::max(separation(of_strength, energy),
                          least_separation(of_strength, stiffness));
    };
    return {stiffness,
            strength.tensile_strength,
            strength.cohesion,
            strength.tan_friction_angle,
            strength.residual_friction,
            inverse(strength.tensile_strength, strength.fracture_energy_1),
            inverse(strength.cohesion, strength.fracture_energy_2)};
  }

  template <typename Branch>
  MohrCoulombPoint<double>
  MohrCoulomb<Branch>::make_point(const FaceStrength &,
                                  const Constants<double> &)
  {
    Point<double> point{};
    point.softening = 1;
    return point;
  }

  template <typename Branch>
  bool
  MohrCoulomb<Branch>::is_resolved(const FaceStrength      &strength,
                                   const Constants<double> &constants)
  {
    const auto is_long_enough = [&](const double of_strength,
                                    const double energy) {
      return separation(of_strength, energy) >=
             least_separation(of_strength, constants.stiffness);
    };
    return is_long_enough(strength.tensile_strength,
                          strength.fracture_energy_1) &&
           is_long_enough(strength.cohesion, strength.fracture_energy_2);
  }

  template <typename Branch>
  InitialEnergy
  MohrCoulomb<Branch>::hold_traction(Point<double> &point,
                                     const FaceStrength &,
                                     const Constants<double> &constants,
                                     const Vector3<double>   &jump,
                                     const Vector3<double>   &more)
  {
    const double          stiffness   = constants.stiffness;
    const double          coefficient = constants.friction_at(point.softening);
    const Vector3<double> before      = point.traction;
    const Vector3<double> t           = before + more;
    const double          friction    = coefficient * std::max(-t[0], 0.);
    const double          shear       = std::hypot(t[1], t[2]) - friction;
    // Excess that has not been worked off remains.
    point.normal_excess =
      std::max(point.normal_excess,
               t[0] - point.softening * constants.tensile_strength);
    point.shear_excess = std::max(point.shear_excess,
                                  shear - point.softening * constants.cohesion);
    point.traction     = t;
    // A failed point that is open keeps its place of closing as offset, which
    // is none of its elastic branch.
    if (point.softening <= 0 && before[0] == 0)
      point.offset[0] = jump[0];
    point.offset -= (1 / stiffness) * more;
    const double cohesive = cohesive_energy(t, coefficient, stiffness) -
                            cohesive_energy(before, coefficient, stiffness);
    const double all = .5 * (dot(t, t) - dot(before, before)) / stiffness;
    return {cohesive, all - cohesive};
  }

  template class MohrCoulomb<StraightBranch>;
  template class MohrCoulomb<ParabolicBranch>;
} // namespace rift
