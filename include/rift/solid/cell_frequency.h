#ifndef rift_solid_cell_frequency_h
#define rift_solid_cell_frequency_h

#include <rift/discretization/reference_cell_data.h>
#include <rift/material/elasticity.h>

namespace rift
{
  /**
   * Upper bound, at most 3 % above the truth, for the square of the largest
   * frequency of a loose tetrahedron with lumped mass, 1/s^2: the largest
   * eigenvalue of (4/rho) C B B^T from the trace of its 64th power
   * (doc/theory.md, eq. 20). No mesh of such cells has a higher frequency.
   *
   * @param stiffness in Voigt's notation, Pa (or Pa s of a viscosity: the
   *   result is then a rate of decay, 1/s).
   */
  double
  largest_frequency_squared(const ReferenceBatch  &reference,
                            unsigned int           lane,
                            const StiffnessMatrix &stiffness,
                            double                 density);
} // namespace rift

#endif
