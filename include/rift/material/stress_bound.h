#ifndef rift_material_stress_bound_h
#define rift_material_stress_bound_h

#include <rift/base/simd.h>

#include <optional>
#include <vector>

namespace rift
{
  /**
   * A bound below which no face of a cell can be at its strength. From the
   * mean stress m and the norm |s| of the deviator (doc/theory.md, eq. 10):
   * no plane has a normal stress above m + sqrt(2/3) |s|, nor a shear stress
   * less friction above |s|/sqrt(2)/cos(phi) + tan(phi) (m + |s|/sqrt(24)).
   */
  struct StressBound
  {
    /** Cells with a larger squared norm of the strain are always examined. */
    static constexpr double small_strain_squared = 1e-3;

    /** Smallest strengths of the faces, times a margin, Pa. */
    double tensile_strength;
    double cohesion;

    /** Of the smallest friction angle: the least friction allows the most
     * shear in compression. */
    double tan_friction_angle;

    /** A coefficient of friction that falls with the squared norm of the
     * strain. */
    struct ReducedFriction
    {
      /** Without strain, and what it loses per squared norm of the strain. */
      double initial, slope;

      /** @tparam Number double or Simd. */
      template <typename Number>
      Number
      at(const Number &strain_squared) const
      {
        return initial - slope * strain_squared;
      }
    };

    /**
     * Friction on planes under pressure, where the shear that the second
     * Piola-Kirchhoff stress gives differs from that of the traction by a part
     * of the normal stress: less than tan(phi) by (2 tan(phi) + 1.42) times an
     * upper estimate of the norm of the strain, which holds up to
     * small_strain_squared (doc/theory.md, eq. 10a).
     */
    ReducedFriction
    friction_under_pressure() const
    {
      // sqrt(x) lies below its tangent at x = e^2, (e + x/e)/2.
      constexpr double e      = .008;
      const double     factor = tan_friction_angle + .71;
      return {tan_friction_angle - factor * e, factor / e};
    }
  };

  /** The bounds of all cells that a rank sees. */
  struct StressBounds
  {
    /** For each material index, of its weakest faces without scatter; nothing
     * where the material does not break. */
    std::vector<std::optional<StressBound>> materials;

    /** Factor of both strengths for each cell, by batches: the smallest one of
     * its faces or vertices. Empty where nothing scatters. */
    std::vector<Simd> factors;
  };

  /** The values of cell slots as StressBounds::factors has them. */
  inline std::vector<Simd>
  by_batches(const std::vector<double> &values)
  {
    std::vector<Simd> result(values.size() / batch_size);
    for (std::size_t i = 0; i < values.size(); ++i)
      result[i / batch_size][i % batch_size] = values[i];
    return result;
  }
} // namespace rift

#endif
