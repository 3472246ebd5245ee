#include <rift/cohesive/weakest_plane.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    struct PrincipalStresses
    {
      double largest, smallest;
    };

    /** By the angle of Lode. */
    PrincipalStresses
    principal_stresses(const Matrix3<double> &stress)
    {
      const double    mean = (stress[0][0] + stress[1][1] + stress[2][2]) / 3;
      Matrix3<double> deviator;
      double          square = 0;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          {
            deviator[i][j] =
              .5 * (stress[i][j] + stress[j][i]) - (i == j ? mean : 0);
            square += deviator[i][j] * deviator[i][j];
          }
      const double radius = std::sqrt(square / 6);
      if (radius == 0)
        return {mean, mean};
      const double determinant =
        dot(deviator[0], cross(deviator[1], deviator[2]));
      const double angle =
        std::acos(
          std::clamp(.5 * determinant / (radius * radius * radius), -1., 1.)) /
        3;
      return {mean + 2 * radius * std::cos(angle),
              mean + 2 * radius * std::cos(angle + 2 * M_PI / 3)};
    }
  } // namespace

  bool
  some_plane_is_at_strength(const Matrix3<double> &stress,
                            const FaceStrength    &strength)
  {
    const PrincipalStresses principal = principal_stresses(stress);
    if (principal.largest >= strength.tensile_strength)
      return true;
    // Mohr's circle: where the line of friction touches it; friction acts in
    // compression alone.
    const double tan    = strength.tan_friction_angle;
    const double secant = std::sqrt(1 + tan * tan);
    const double centre = .5 * (principal.largest + principal.smallest);
    const double radius = .5 * (principal.largest - principal.smallest);
    double       demand = radius;
    if (centre + radius * tan / secant <= 0)
      demand = centre * tan + radius * secant;
    else if (centre < 0)
      demand = std::sqrt(radius * radius - centre * centre);
    return demand >= strength.cohesion;
  }
} // namespace rift
