#ifndef rift_contact_cell_motion_h
#define rift_contact_cell_motion_h

#include <rift/base/vector3.h>

namespace rift
{
  /** The corners of a tetrahedron of positive volume, m. */
  using Tetrahedron = std::array<Vector3<double>, 4>;

  /** Where the corners of a cell are, m, and their velocities, m/s. */
  struct CellMotion
  {
    /** Of the four corners. */
    Tetrahedron                    positions;
    std::array<Vector3<double>, 4> velocities;
  };
} // namespace rift

#endif
