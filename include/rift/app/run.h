#ifndef rift_app_run_h
#define rift_app_run_h

#include <rift/app/parameters.h>

namespace rift
{
  /**
   * Computes a scene from its mesh to its last result. Throws InputError,
   * RunError or DiskError for what the user can mend.
   */
  void
  run_simulation(const Parameters &parameters);
} // namespace rift

#endif
