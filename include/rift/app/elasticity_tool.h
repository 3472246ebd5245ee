#ifndef rift_app_elasticity_tool_h
#define rift_app_elasticity_tool_h

#include <iosfwd>

namespace rift
{
  /**
   * What the program rift-elasticity does: prints the stiffness and the wave
   * speeds of the elastic materials of a scene, and fits densities of
   * microcracks to a measured stiffness or to measured speeds. All in material
   * axes.
   *
   * @throws InputError
   */
  void
  run_elasticity_tool(int argc, const char *const *argv, std::ostream &out);
} // namespace rift

#endif
