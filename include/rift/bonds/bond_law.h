#ifndef rift_bonds_bond_law_h
#define rift_bonds_bond_law_h

#include <rift/base/vector3.h>
#include <rift/cohesive/laws/softening.h>
#include <rift/material/face_strength.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  /**
   * The traction of a bond per projected area of its crack plane: at most an
   * envelope that softens with the damage (doc/theory.md, eq. 41 to 43a). There
   * is no spring: what holds the two nodes together comes from outside, and the
   * law says how much of it the bond bears.
   */
  class BondLaw
  {
  public:
    /** What a bond remembers, besides the strength of its plane. */
    struct Memory
    {
      /** Damage from 0 to 1. */
      double damage = 0;

      /** What of the damage sliding has done, for output. */
      double slip_damage = 0;

      /** What the demand at the start was above 1. */
      double excess = 0;

      /** f(damage). */
      double softening = 1;
    };

    /** A traction in the frame of the crack plane, Pa: normal part, tension
     * positive, and shear part as a vector in space. */
    struct Traction
    {
      /** Along the normal, and the rest. */
      double          normal;
      Vector3<double> shear;
    };

    /** Splits a traction in space. */
    static Traction
    split(const Vector3<double> &traction, const Vector3<double> &normal)
    {
      const double along = dot(traction, normal);
      return {along, traction - along * normal};
    }

    /** Present coefficient of friction (eq. 14a). */
    static double
    friction(const FaceStrength &strength, const Memory &memory)
    {
      return strength.residual_friction +
             memory.softening *
               (strength.tan_friction_angle - strength.residual_friction);
    }

    /** The envelope of a bond at its present damage (eq. 41), Pa. */
    struct Envelope
    {
      /** Largest normal traction, and shear traction without a normal one. */
      double tension, shear;

      /** What of shear a normal traction takes away in tension, and what pressure
       * adds. */
      double friction_in_tension, friction_under_pressure;

      /** A traction that counts as none, so that one on the envelope stays there
       * whatever rounding does. */
      double rounding;
    };

    /** The present one. */
    static Envelope
    envelope(const FaceStrength &strength, const Memory &memory)
    {
      const double left = memory.softening + memory.excess;
      return {left * strength.tensile_strength,
              left * strength.cohesion,
              strength.tan_friction_angle,
              friction(strength, memory),
              1e-9 * strength.tensile_strength};
    }

    /** Whether a traction lies inside an envelope, for its shear part
     * squared. */
    static bool
    bears(const Envelope &envelope,
          const double    normal,
          const double    shear_squared)
    {
      const double largest =
        envelope.shear + envelope.rounding -
        normal * (normal > 0 ? envelope.friction_in_tension :
                               envelope.friction_under_pressure);
      return normal <= envelope.tension + envelope.rounding && largest >= 0 &&
             shear_squared <= largest * largest;
    }

    /** What is left of a traction: its normal part, and a factor of its shear
     * part. */
    struct Borne
    {
      /** Pa and 1. */
      double normal, shear_factor;
    };

    /**
     * The part of a traction that a bond bears: in tension it is shortened to
     * the envelope, under pressure its shear part is (eq. 41).
     *
     * @param normal traction, Pa, and `shear_squared`, Pa^2.
     * @param closing normal traction that is left under pressure once the gap
     *   of an open bond has been closed, Pa (eq. 42a).
     */
    static Borne
    bear(const Envelope &envelope,
         const double    normal,
         const double    shear_squared,
         const double    closing)
    {
      if (normal > 0)
        {
          if (bears(envelope, normal, shear_squared))
            return {normal, 1};
          if (envelope.tension <= 0)
            return {0, 0};
          const double factor =
            1 / std::max(normal / envelope.tension,
                         (std::sqrt(shear_squared) +
                          envelope.friction_in_tension * normal) /
                           envelope.shear);
          return {factor * normal, factor};
        }
      const double left = std::min(0., closing);
      if (bears(envelope, left, shear_squared))
        return {left, 1};
      return {left,
              (envelope.shear - envelope.friction_under_pressure * left) /
                std::sqrt(shear_squared)};
    }

    /**
     * Damage of a step, by the work of the cohesive part of the traction (eq.
     * 43), and what is left of the excess (eq. 43a).
     *
     * @param opening, slip of the step, m.
     */
    void
    soften(const FaceStrength    &strength,
           Memory                &memory,
           const Traction        &traction,
           const double           opening,
           const Vector3<double> &slip) const
    {
      const double limit = memory.softening + memory.excess;
      if (limit <= 0)
        return;
      const double work_of_slip = dot(traction.shear, slip);
      double       by_opening = 0, by_slip = 0;
      if (traction.normal > 0)
        {
          by_opening = Softening::integral / limit * traction.normal * opening /
                       strength.fracture_energy_1;
          by_slip = Softening::integral / limit * work_of_slip /
                    strength.fracture_energy_2;
        }
      else
        by_slip = Softening::integral * strength.cohesion /
                  strength.fracture_energy_2 * work_of_slip /
                  std::max(norm(traction.shear), 1e-9 * strength.cohesion);
      const double growth = by_opening + by_slip;
      if (growth <= 0)
        return;
      constexpr double damage_of_excess = .01;
      memory.damage                     = std::min(1., memory.damage + growth);
      memory.slip_damage += by_slip;
      memory.excess = std::max(0., memory.excess - growth / damage_of_excess);
      memory.softening = softening(memory.damage);
    }

    /** f(D), as soften() computes it. */
    double
    softening_at(const double damage) const
    {
      return softening(damage);
    }

  private:
    Softening softening;
  };
} // namespace rift

#endif
