#ifndef rift_mesh_msh_file_h
#define rift_mesh_msh_file_h

#include <string>

namespace rift
{
  /**
   * Looks at the frame of a .msh file before gmsh does: gmsh accepts files
   * that end too early and takes other files for scripts.
   *
   * @throws InputError if the file cannot be read, is no MSH file of version
   * 2.2 or 4.1, or lacks a section or the end of one.
   */
  void
  check_msh_file(const std::string &file);
} // namespace rift

#endif
