#ifndef rift_app_run_h
#define rift_app_run_h

#include <rift/app/parameters.h>

#include <iosfwd>

namespace rift
{
  /**
   * Prepares a scene as for a run, with its mesh, tables and probes, and says
   * what it is and how many steps it takes, without computing or writing
   * anything. Throws InputError for what a run would refuse at its start.
   */
  void
  validate_scene(std::ostream &out, const Parameters &parameters);

  /**
   * Computes a scene from its mesh to its last result. Throws InputError,
   * RunError or DiskError for what the user can mend.
   *
   * @param is_restart goes on from the newest checkpoint instead.
   */
  void
  run_simulation(const Parameters &parameters, bool is_restart = false);
} // namespace rift

#endif
