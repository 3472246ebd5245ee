#ifndef rift_cohesive_cohesive_model_h
#define rift_cohesive_cohesive_model_h

namespace rift
{
  /** When faces get their cohesive elements. */
  enum class CohesiveModel
  {
    /** Never: nothing breaks. */
    none,
    /** When the stress on a face has reached its strength. */
    extrinsic,
    /** All breakable faces, before the first step. */
    intrinsic
  };
} // namespace rift

#endif
