#ifndef rift_material_crack_fit_h
#define rift_material_crack_fit_h

#include <rift/material/microcracks.h>

#include <functional>

namespace rift
{
  /** Crack densities that bring a microcracked material nearest to something
   * measured. */
  struct CrackFit
  {
    /** The groups, with the densities that have been found. */
    std::vector<CrackGroup> groups;

    /** What remains of each measured value, in its unit. */
    std::vector<double> residuals;

    /** Their root mean square. */
    double
    mean_residual() const;
  };

  /**
   * Fits the densities of the groups, which stay positive, by least squares
   * after Levenberg and Marquardt.
   *
   * @param start groups with densities above zero.
   * @param residuals of a stiffness, Pa, as many each time: computed less
   *   measured.
   * @throws InputError if there are fewer residuals than groups, and if no
   *   minimum is found.
   */
  CrackFit
  fit_cracks(const StiffnessMatrix         &intact,
             const std::vector<CrackGroup> &start,
             CrackScheme                    scheme,
             const std::function<std::vector<double>(const StiffnessMatrix &)>
               &residuals);
} // namespace rift

#endif
