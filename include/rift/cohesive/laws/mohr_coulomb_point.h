#ifndef rift_cohesive_laws_mohr_coulomb_point_h
#define rift_cohesive_laws_mohr_coulomb_point_h

#include <rift/cohesive/laws/fields.h>

namespace rift
{
  /**
   * What a Gauss point of a cohesive face remembers. Vectors are in the frame
   * of the face: normal, first and second tangent.
   */
  template <typename Number>
  struct MohrCoulombPoint
  {
    /** Irreversible jump: at which the elastic branch has no traction, m. */
    Vector3<Number> offset;

    /** Traction at the last update, Pa. */
    Vector3<Number> traction;

    /** Opening and slip beyond the envelope, over what separates the face
     * fully. */
    Number opening, slip;

    /** f(D): the share of the strength that is left, 1 to 0. */
    Number softening;

    /** Traction above the strength that is still held, Pa: normal, shear. */
    Number normal_excess, shear_excess;

    /** All members with their names; see PointField. */
    static constexpr auto
    fields()
    {
      using Point = MohrCoulombPoint;
      return std::make_tuple(field("offset", &Point::offset),
                             field("traction", &Point::traction),
                             field("opening", &Point::opening),
                             field("slip", &Point::slip),
                             field("softening", &Point::softening),
                             field("normal excess", &Point::normal_excess),
                             field("shear excess", &Point::shear_excess));
    }
  };

  /** What all Gauss points of a face have in common. */
  template <typename Number>
  struct MohrCoulombConstants
  {
    /** Slope k of the elastic branch at its start, Pa/m. */
    Number stiffness;

    /** Of the intact face, Pa. */
    Number tensile_strength, cohesion;

    /** Coefficients of friction of the intact and of the failed face. */
    Number tan_friction_angle, residual_friction;

    /** One over the opening and the slip beyond the envelope at which a face has
     * separated, 1/m. */
    Number inverse_opening, inverse_slip;

    /** All members with their names; see PointField. */
    static constexpr auto
    fields()
    {
      using Constants = MohrCoulombConstants;
      return std::make_tuple(
        field("stiffness", &Constants::stiffness),
        field("tensile strength", &Constants::tensile_strength),
        field("cohesion", &Constants::cohesion),
        field("tan friction angle", &Constants::tan_friction_angle),
        field("residual friction", &Constants::residual_friction),
        field("inverse opening", &Constants::inverse_opening),
        field("inverse slip", &Constants::inverse_slip));
    }

    /** Coefficient of friction of a point with this share f(D) of its strength
     * (doc/theory.md, eq. 14a). */
    Number
    friction_at(const Number &softening) const
    {
      return residual_friction +
             softening * (tan_friction_angle - residual_friction);
    }
  };
} // namespace rift

#endif
