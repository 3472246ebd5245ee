#ifndef rift_contact_packed_motion_h
#define rift_contact_packed_motion_h

#include <rift/base/simd.h>

namespace rift
{
  /** Rows (x, y, z, 0) of a cell: the places of its four corners, m, and their
   * velocities, m/s. */
  struct alignas(64) PackedMotion
  {
    NodalVector position[4], velocity[4];
  };

  /** Positions of two cells in an array of PackedMotion. */
  struct CellPair
  {
    std::uint32_t a, b;
  };
} // namespace rift

#endif
