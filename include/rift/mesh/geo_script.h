#ifndef rift_mesh_geo_script_h
#define rift_mesh_geo_script_h

#include <string>
#include <vector>

namespace rift
{
  /**
   * Checks that a gmsh script can be given numbers of these names, which gmsh
   * itself never tells: it ignores a number that no line uses, and a plain
   * `radius = 0.02;` silently replaces the number that was given.
   *
   * A name is accepted if its first mention, comments and strings aside, is
   * in a `DefineConstant[ ... ]` or anything but an assignment. Files that
   * the script includes are read in their place.
   *
   * @throws InputError naming the script, and the parameter or the file that
   * cannot be opened.
   */
  void
  check_geo_parameters(const std::string              &file,
                       const std::vector<std::string> &names);
} // namespace rift

#endif
