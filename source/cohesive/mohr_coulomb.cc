#include <rift/cohesive/laws/mohr_coulomb.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** What a mode has when its separation is chosen. */
    struct Mode
    {
      double strength, fracture_energy, given, excess;
    };

    /**
     * One over the jump beyond the peak over which a mode softens, 1/m, such
     * that the work besides what has been given is the fracture energy: what
     * the branch takes to its peak and what the excess takes are part of that.
     */
    double
    inverse_separation(const Mode  &mode,
                       const double stiffness,
                       const double rising_work_fraction)
    {
      if (mode.strength == 0)
        return 0;
      const double peak = mode.strength + mode.excess;
      const double rise =
        std::max(0.,
                 rising_work_fraction * peak * peak / stiffness - mode.given);
      const double of_excess =
        .5 * mode.excess * mode.excess / (excess_slope * stiffness);
      return 1 / std::max((mode.fracture_energy - rise - of_excess) /
                            (Softening::integral * mode.strength),
                          shortest_separation * mode.strength / stiffness);
    }

    void
    set_separations(MohrCoulombPoint<double> &point,
                    const FaceStrength       &strength,
                    const double              stiffness,
                    const double              rising_work_fraction)
    {
      const Mode opening = {strength.tensile_strength,
                            strength.fracture_energy_1,
                            point.given_opening,
                            point.normal_excess};
      const Mode sliding = {point.cohesion,
                            strength.fracture_energy_2,
                            point.given_sliding,
                            point.shear_excess};
      point.inverse_opening =
        inverse_separation(opening, stiffness, rising_work_fraction);
      point.inverse_slip =
        inverse_separation(sliding, stiffness, rising_work_fraction);
    }

    /** Of an elastic branch, J/m^2: what fracture will use up, by modes, and
     * what the body can repay since the face is under pressure. */
    struct BranchEnergy
    {
      double opening, sliding, owed;
    };

    /**
     * Shear traction that has the energy which is given, Pa. Without pressure
     * that is all; with a pressure like the shear that the cohesion carries the
     * body can repay all. In between, what is owed falls with the pressure, so
     * that the closing that repays it has a bound.
     */
    double
    given_shear(const Vector3<double> &traction,
                const double           friction_coefficient)
    {
      const double pressure = std::max(-traction[0], 0.);
      const double cohesion = std::max(std::hypot(traction[1], traction[2]) -
                                         friction_coefficient * pressure,
                                       0.);
      return std::sqrt(cohesion * std::max(cohesion - pressure, 0.));
    }

    BranchEnergy
    energy_of(const Vector3<double> &traction,
              const double           friction_coefficient,
              const double           stiffness)
    {
      const double tension = std::max(traction[0], 0.);
      const double shear   = given_shear(traction, friction_coefficient);
      const double opening = .5 * tension * tension / stiffness;
      const double sliding = .5 * shear * shear / stiffness;
      return {opening,
              sliding,
              .5 * dot(traction, traction) / stiffness - opening - sliding};
    }
  } // namespace

  template <typename Branch>
  MohrCoulombConstants<double>
  MohrCoulomb<Branch>::make_constants(const FaceStrength &strength,
                                      const double        stiffness)
  {
    return {stiffness,
            strength.tensile_strength,
            strength.cohesion,
            strength.tan_friction_angle,
            strength.residual_friction};
  }

  template <typename Branch>
  MohrCoulombPoint<double>
  MohrCoulomb<Branch>::make_point(const FaceStrength      &strength,
                                  const Constants<double> &constants)
  {
    Point<double> point{};
    point.softening = 1;
    point.cohesion  = strength.cohesion;
    set_separations(point,
                    strength,
                    constants.stiffness,
                    Branch::rising_work_fraction);
    return point;
  }

  template <typename Branch>
  bool
  MohrCoulomb<Branch>::is_resolved(const FaceStrength      &strength,
                                   const Constants<double> &constants)
  {
    const auto is_too_short = [&](const double of_strength,
                                  const double energy) {
      return (Softening::integral * shortest_separation +
              Branch::rising_work_fraction) *
               of_strength * of_strength / constants.stiffness >
             energy;
    };
    return !is_too_short(strength.tensile_strength,
                         strength.fracture_energy_1) &&
           !is_too_short(strength.cohesion, strength.fracture_energy_2);
  }

  template <typename Branch>
  double
  MohrCoulomb<Branch>::hold_traction(Point<double>           &point,
                                     const FaceStrength      &strength,
                                     const Constants<double> &constants,
                                     const Vector3<double>   &jump,
                                     const Vector3<double>   &more)
  {
    const double          stiffness   = constants.stiffness;
    const Vector3<double> before      = point.traction;
    const Vector3<double> t           = before + more;
    const double          coefficient = constants.friction_at(point.softening);
    const double          friction    = coefficient * std::max(-t[0], 0.);
    const double tensile_strength = point.softening * strength.tensile_strength;
    const double cohesion         = point.softening * strength.cohesion;
    const double shear            = std::hypot(t[1], t[2]) - friction;
    // A face that opens in tension has the shear strength that it needs.
    if (t[0] > 0 && point.softening > 0 &&
        t[0] * cohesion > shear * tensile_strength)
      point.cohesion = std::min(shear / point.softening, strength.cohesion);
    // Excess that has not been worked off remains.
    point.normal_excess =
      std::max(point.normal_excess, t[0] - tensile_strength);
    point.shear_excess =
      std::max(point.shear_excess, shear - point.softening * point.cohesion);
    point.traction = t;
    // A failed point that is open keeps its place of closing as offset, which
    // is none of its elastic branch.
    if (point.softening <= 0 && before[0] == 0)
      point.offset[0] = jump[0];
    point.offset -= (1 / stiffness) * more;
    const BranchEnergy had = energy_of(before, coefficient, stiffness);
    const BranchEnergy has = energy_of(t, coefficient, stiffness);
    point.given_opening += has.opening - had.opening;
    point.given_sliding += has.sliding - had.sliding;
    point.debt += has.owed - had.owed;
    set_separations(point, strength, stiffness, Branch::rising_work_fraction);
    return has.opening - had.opening + has.sliding - had.sliding;
  }

  template class MohrCoulomb<StraightBranch>;
  template class MohrCoulomb<ParabolicBranch>;
} // namespace rift
