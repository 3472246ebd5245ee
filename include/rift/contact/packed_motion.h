#ifndef rift_contact_packed_motion_h
#define rift_contact_packed_motion_h

#include <rift/base/simd.h>
#include <rift/contact/cell_motion.h>

namespace rift
{
  /** Rows (x, y, z, 0) of a cell, for kernels that read them eight cells at a
   * time: positions of its four corners, m, then their velocities, m/s. */
  struct alignas(64) PackedMotion
  {
    /** Of the four corners. */
    NodalVector position[4], velocity[4];
  };

  static_assert(sizeof(PackedMotion) == 8 * sizeof(NodalVector),
                "kernels take an array of cells as one of rows");

  /** A pair of cells, by their places in an array of PackedMotion. */
  struct CellPair
  {
    /** The two cells. */
    std::uint32_t a, b;
  };

  /** A cell that does not move. */
  inline PackedMotion
  pack(const Tetrahedron &positions)
  {
    PackedMotion packed;
    for (unsigned int c = 0; c < 4; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        packed.position[c][d] = positions[c][d];
    return packed;
  }

  /** The rows of a cell. */
  inline PackedMotion
  pack(const CellMotion &motion)
  {
    PackedMotion packed = pack(motion.positions);
    for (unsigned int c = 0; c < 4; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        packed.velocity[c][d] = motion.velocities[c][d];
    return packed;
  }

  /** The inverse of pack(). */
  inline CellMotion
  unpack(const PackedMotion &packed)
  {
    CellMotion motion;
    for (unsigned int c = 0; c < 4; ++c)
      {
        motion.positions[c]  = packed.position[c].vector();
        motion.velocities[c] = packed.velocity[c].vector();
      }
    return motion;
  }
} // namespace rift

#endif
