#ifndef rift_cohesive_face_means_h
#define rift_cohesive_face_means_h

namespace rift
{
  /** Means over an open face, for output. */
  struct FaceMeans
  {
    /** 0: intact, 1: separated. */
    double damage = 0;

    /** Jumps, m, and tractions, Pa: normal and in magnitude the rest. */
    double opening = 0, slip = 0, normal = 0, shear = 0;

    /** Squares of the two parts of the damage. */
    double opening_damage = 0, slip_damage = 0;

    /** Times at which it has begun to open, and at which it has failed, s; the
     * latter is negative before. */
    double start_time = 0, failure_time = -1;

    /** Share of sliding in the damage, from 0 to 1. */
    double
    mode() const
    {
      const double total = opening_damage + slip_damage;
      return total > 0 ? slip_damage / total : 0;
    }
  };
} // namespace rift

#endif
