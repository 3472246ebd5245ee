#ifndef rift_cohesive_weakest_plane_h
#define rift_cohesive_weakest_plane_h

#include <rift/base/types.h>
#include <rift/base/vector3.h>
#include <rift/material/face_strength.h>

namespace rift
{
  /**
   * Whether a plane of some direction is at the strength of eq. (11) under a
   * stress, all planes having the same strength (doc/theory.md, eq. 11b).
   *
   * @param stress Pa, of which the symmetric part is taken.
   */
  bool
  some_plane_is_at_strength(const Matrix3<double> &stress,
                            const FaceStrength    &strength);
} // namespace rift

#endif
