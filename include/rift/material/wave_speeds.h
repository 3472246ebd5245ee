#ifndef rift_material_wave_speeds_h
#define rift_material_wave_speeds_h

#include <rift/material/elasticity.h>

namespace rift
{
  /**
   * Speeds of the three plane waves in a direction, m/s, the fastest (P, or
   * almost) first: roots of the eigenvalues of Christoffel's matrix
   * n_i C_ijkl n_l / rho (doc/theory.md, eq. 31).
   *
   * @param direction of any length, in the axes of the stiffness.
   */
  std::array<double, 3>
  wave_speeds(const StiffnessMatrix &stiffness,
              double                 density,
              const Vector3<double> &direction);

  /**
   * Impedance for plane waves along a normal, Pa s/m: what times the velocity
   * of the material in a wave that runs along the normal is the traction
   * against it. The root of density times Christoffel's matrix; in an isotropic
   * material rho c_P along the normal and rho c_S across it.
   */
  Matrix3<double>
  impedance(const StiffnessMatrix &stiffness,
            double                 density,
            const Vector3<double> &normal);
} // namespace rift

#endif
