#ifndef rift_mesh_child_process_h
#define rift_mesh_child_process_h

#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace rift
{
  /** The child died of a signal, left early or ran out of memory. */
  class ChildProcessError : public std::runtime_error
  {
  public:
    /** `signal` is the one that killed the child, 0 if none did. */
    ChildProcessError(const std::string &message, const int signal)
      : std::runtime_error(message)
      , signal(signal)
    {
    }

    /** Number of the signal, 0 if there was none. */
    const int signal;
  };

  /**
   * Runs `work` in a copy of this process and returns the bytes that it
   * returns. It is for libraries that crash, call exit(), print or keep state
   * where they should not: nothing of this reaches the calling process, and
   * all memory is given back at the end. What the child prints is lost.
   *
   * An InputError thrown by `work` is thrown here with the same message.
   *
   * @throws ChildProcessError when the child ends in any other way than by
   * returning or by an InputError. The message completes the sentence "the
   * child ...".
   * @throws RunError when no process can be made.
   *
   * `work` must not use MPI, which may have been started here: fork() is sound
   * then as this process only waits until its child has ended (see "gmsh's
   * process" in doc/architecture.md). The child may take `memory_limit` bytes beyond
   * those of this process, and never more than the machine has, so that a
   * nonsensical request fails at once instead of bringing the machine down.
   */
  std::string
  run_in_child_process(
    const std::function<std::string()> &work,
    const std::size_t memory_limit = std::numeric_limits<std::size_t>::max());
} // namespace rift

#endif
