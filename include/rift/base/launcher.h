#ifndef rift_base_launcher_h
#define rift_base_launcher_h

#include <string>

namespace rift
{
  /**
   * A warning if what has started this process speaks of more than the
   * `n_ranks` that MPI knows of; else empty. Each of these processes may then
   * take itself for the only one and compute the whole scene.
   */
  std::string
  warning_about_ranks(int n_ranks);
} // namespace rift

#endif
