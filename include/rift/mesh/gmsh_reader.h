#ifndef rift_mesh_gmsh_reader_h
#define rift_mesh_gmsh_reader_h

#include <rift/mesh/mesh_data.h>
#include <rift/mesh/mesh_parameters.h>

namespace rift
{
  /**
   * Makes or reads the mesh that the scene asks for, through gmsh:
   *
   * - a `.geo` script is meshed now. `geo_parameters` and, if positive,
   *   `element_size` are given to it as numbers of these names, which the
   *   script must use: DefineConstant[ element_size = 2.5e-3 ];
   * - a `.msh` file of version 2.2 or 4.1, ASCII or binary, is read as it is;
   * - the built-in box has a corner at the origin and the boundaries `x_min`,
   *   `x_max`, `y_min`, ...;
   * - the built-in cylinder along x begins at x = 0 and has the boundaries
   *   `start`, `end` and `side`.
   *
   * Physical volumes name the materials and physical surfaces the boundaries.
   * The same request always gives the same mesh. gmsh runs in a process of its
   * own, so that it prints nothing and that a file that crashes it leads to a
   * message like any other. This function may be called by one rank alone.
   *
   * All that a file can hold and a mesh must not is for check_mesh() to find.
   *
   * @throws InputError naming the file, the parameter or what gmsh says.
   */
  MeshData
  read_mesh(const MeshParameters &parameters);
} // namespace rift

#endif
