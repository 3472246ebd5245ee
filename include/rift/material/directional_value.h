#ifndef rift_material_directional_value_h
#define rift_material_directional_value_h

#include <rift/base/vector3.h>

#include <algorithm>

namespace rift
{
  /**
   * A property of the planes in a material, by their normal n:
   *   X(n) = X_1 n_1^2 + X_2 n_2^2 + X_3 n_3^2
   * in material axes (doc/theory.md, eq. 11a).
   */
  class DirectionalValue
  {
  public:
    /** The same in all directions. */
    DirectionalValue(const double value)
      : values{{value, value, value}}
    {
    }

    /** Of planes across the axes 1, 2 and 3. */
    DirectionalValue(const double across_1,
                     const double across_2,
                     const double across_3)
      : values{{across_1, across_2, across_3}}
    {
    }

    /** Whether it is the same in all directions. */
    bool
    is_isotropic() const
    {
      return values[0] == values[1] && values[1] == values[2];
    }

    /** Smallest of the three values. */
    double
    smallest() const
    {
      return *std::min_element(values.begin(), values.end());
    }

    /** Largest of the three values. */
    double
    largest() const
    {
      return *std::max_element(values.begin(), values.end());
    }

    /** @param normal of unit length, in material axes. */
    double
    at(const Vector3<double> &normal) const
    {
      // Not a bit of what is the same everywhere is lost in the sum.
      if (is_isotropic())
        return values[0];
      return values[0] * normal[0] * normal[0] +
             values[1] * normal[1] * normal[1] +
             values[2] * normal[2] * normal[2];
    }

  private:
    Vector3<double> values;
  };
} // namespace rift

#endif
