#include <rift/cohesive/weakest_plane.h>
#include <rift/solid/principal_stresses.h>

#include <cmath>

namespace rift
{
  bool
  some_plane_is_at_strength(const Matrix3<double> &stress,
                            const FaceStrength    &strength)
  {
    const Vector3<double> principal = principal_stresses(stress);
    const double          largest = principal[0], smallest = principal[2];
    if (largest >= strength.tensile_strength)
      return true;
    // Mohr's circle: where the line of friction touches it; friction acts in
    // compression alone.
    const double tan    = strength.tan_friction_angle;
    const double secant = std::sqrt(1 + tan * tan);
    const double centre = .5 * (largest + smallest);
    const double radius = .5 * (largest - smallest);
    double       demand = radius;
    if (centre + radius * tan / secant <= 0)
      demand = centre * tan + radius * secant;
    else if (centre < 0)
      demand = std::sqrt(radius * radius - centre * centre);
    return demand >= strength.cohesion;
  }
} // namespace rift
