#ifndef rift_cohesive_laws_elastic_branch_h
#define rift_cohesive_laws_elastic_branch_h

#include <rift/base/simd.h>
#include <rift/cohesive/cohesive_model.h>

namespace rift
{
  // How the traction of a cohesive face rises to its strength. `TrialTraction`
  // is the elastic jump times the stiffness k at the start, Pa: the traction if
  // the branch was straight and endless; its peak is the strength that is left.

  /**
   * The elastic branch of the extrinsic model: straight. It is a numerical
   * device, as stiff as the time step allows, since a face that is inserted
   * carries its strength already.
   */
  struct StraightBranch
  {
    /** The model that it serves, and whether its slope is constant. */
    static constexpr CohesiveModel model       = CohesiveModel::extrinsic;
    static constexpr bool          is_straight = true;

    /** The trial at the peak, over the peak. */
    static constexpr double peak_ratio = 1;
  };

  /**
   * The rising branch of the intrinsic model: a parabola with its peak at the
   * jump 2 peak / k (doc/theory.md, eq. 14b). Shear that friction holds above
   * the peak goes on with the stiffness k.
   */
  struct ParabolicBranch
  {
    /** See StraightBranch. */
    static constexpr CohesiveModel model       = CohesiveModel::intrinsic;
    static constexpr bool          is_straight = false;
    static constexpr double        peak_ratio  = 2;

    /** Traction over trial; `ratio` is the trial over its peak. */
    template <typename Number>
    static Number
    secant(const Number &ratio)
    {
      return select(ratio < peak_ratio, 1. - .25 * ratio, 1. - 1. / ratio);
    }

    /** Elastic energy per area over trial^2 / k. */
    template <typename Number>
    static Number
    energy(const Number &ratio)
    {
      const Number inverse = 1. / ratio;
      return select(ratio < peak_ratio,
                    .5 - (1. / 12.) * ratio,
                    .5 - inverse + (4. / 3.) * inverse * inverse);
    }

    /** Trial over peak at a traction over peak of 0 to 1. */
    template <typename Number>
    static Number
    trial_ratio(const Number &traction)
    {
      return 2. * traction / (1. + sqrt(1. - traction));
    }
  };
} // namespace rift

#endif
