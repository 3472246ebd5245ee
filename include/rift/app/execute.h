#ifndef rift_app_execute_h
#define rift_app_execute_h

#include <rift/app/command_line.h>

#include <iosfwd>

namespace rift
{
  /**
   * Does what the command line asks for. Throws InputError, RunError or
   * DiskError for what the user can mend.
   *
   * @param out where the answer is printed; a run prints its log by itself.
   */
  void
  execute(std::ostream &out, const CommandLine &command);
} // namespace rift

#endif
