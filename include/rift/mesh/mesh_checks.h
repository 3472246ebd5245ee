#ifndef rift_mesh_mesh_checks_h
#define rift_mesh_mesh_checks_h

#include <rift/mesh/mesh_data.h>

namespace rift
{
  /**
   * A cell counts as flat, without volume, if its volume is not above this
   * times the cube of its longest edge.
   */
  constexpr double smallest_relative_volume = 1e-12;

  /**
   * Two vertices count as coincident if they are closer than this times the
   * diagonal of the mesh.
   */
  constexpr double coincidence_tolerance = 1e-12;

  /**
   * Checks what every later stage relies on: there are cells; all indices are
   * in range and all regions have names; coordinates are finite; cells are of
   * positive volume; every vertex belongs to a cell, and no two are at the
   * same position; no cell is there twice, no face is shared by more than two
   * cells, and two cells that share a face lie on opposite sides of it.
   *
   * Takes about a second for a million cells.
   *
   * @throws InputError that names the mesh, the first offending cell by its
   * tag, the position, and what to do.
   */
  void
  check_mesh(const MeshData &mesh);
} // namespace rift

#endif
