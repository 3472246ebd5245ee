#ifndef rift_cohesive_laws_all_h
#define rift_cohesive_laws_all_h

#include <rift/cohesive/laws/linear_softening.h>
#include <rift/cohesive/laws/mohr_coulomb.h>

namespace rift
{
  /** A list of types. */
  template <typename... Laws>
  struct LawList
  {
  };

  /**
   * The cohesive laws that a scene can choose by their names; some laws go by
   * one name and differ in the model that they serve. doc/adding-a-law.md says
   * what a law consists of.
   */
  using CohesiveLaws = LawList<MohrCoulomb<StraightBranch>,
                               MohrCoulomb<ParabolicBranch>,
                               LinearSoftening>;
} // namespace rift

#endif
