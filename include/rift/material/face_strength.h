#ifndef rift_material_face_strength_h
#define rift_material_face_strength_h

#include <algorithm>

namespace rift
{
  /** Strength of a plane in a material: what an interior face has of it. */
  struct FaceStrength
  {
    /** Tensile strength and cohesion, Pa. */
    double tensile_strength, cohesion;

    /** Coefficients of internal friction, while the face is intact and once it
     * has failed. */
    double tan_friction_angle, residual_friction;

    /** Fracture energies of modes I and II, J/m^2. */
    double fracture_energy_1, fracture_energy_2;

    /** Whether a normal stress (tension positive) and a shear stress of a plane,
     * Pa, reach it (doc/theory.md, eq. 11). */
    bool
    is_reached(const double normal, const double shear) const
    {
      return normal >= tensile_strength ||
             shear >= cohesion - std::min(normal, 0.) * tan_friction_angle;
    }

    /** With both strengths times a random factor. */
    FaceStrength
    scattered(const double factor) const
    {
      FaceStrength result = *this;
      result.tensile_strength *= factor;
      result.cohesion *= factor;
      return result;
    }
  };

  /** The weaker value of each property: that of a plane between two materials. */
  inline FaceStrength
  weaker_of(const FaceStrength &a, const FaceStrength &b)
  {
    return {std::min(a.tensile_strength, b.tensile_strength),
            std::min(a.cohesion, b.cohesion),
            std::min(a.tan_friction_angle, b.tan_friction_angle),
            std::min(a.residual_friction, b.residual_friction),
            std::min(a.fracture_energy_1, b.fracture_energy_1),
            std::min(a.fracture_energy_2, b.fracture_energy_2)};
  }
} // namespace rift

#endif
