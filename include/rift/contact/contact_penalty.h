#ifndef rift_contact_contact_penalty_h
#define rift_contact_contact_penalty_h

#include <rift/discretization/reference_cell_data.h>

#include <algorithm>

namespace rift
{
  /**
   * The largest penalty, Pa, at which contact on all faces of a loose cell adds
   * no more than this to the square of its frequencies (doc/theory.md, eq. 27).
   *
   * @param density kg/m^3.
   * @param room 1/s^2.
   */
  inline double
  largest_penalty(const ReferenceBatch &batch,
                  const unsigned int    lane,
                  const double          density,
                  const double          room)
  {
    double steepest = 0;
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        const Vector3<double> gradient = batch.gradient(c, lane);
        steepest = std::max(steepest, dot(gradient, gradient));
      }
    return density * room / (48 * steepest);
  }
} // namespace rift

#endif
