#ifndef rift_io_output_directory_h
#define rift_io_output_directory_h

#include <string>

namespace rift
{
  /**
   * The first line of the parameters.prm that a run leaves among its results.
   * A file of that name without this line is taken for a scene of the user,
   * and never overwritten.
   */
  constexpr const char *parameters_marker = "# All parameters as used by rift";

  /**
   * Creates `directory` with the folders above it if need be.
   *
   * @throws InputError if it is not a directory.
   * @throws DiskError if it cannot be created.
   */
  void
  create_output_directory(const std::string &directory);

  /**
   * Creates `directory` as above and sees to it that a run may write its results
   * there, and can.
   *
   * @throws InputError if it is not a directory, if it holds results of an
   *   older run and `overwrite` is false, or if it holds a parameters.prm that
   *   rift did not write; nothing has been changed then.
   * @throws DiskError if it cannot be created or written.
   */
  void
  check_output_directory(const std::string &directory, bool overwrite);

  /**
   * Makes `directory` ready for the results of a run: checks it as above and
   * removes the results of an older run: exactly the files that rift gives its
   * names to, solid.pvd, solid-00000.vtu and so on, its checkpoints, and
   * nothing else. Throws what check_output_directory() does.
   */
  void
  prepare_output_directory(const std::string &directory, bool overwrite);

  /**
   * Sees to it that a run can go on after a restart in `directory`, which keeps
   * all that is there.
   *
   * @throws InputError if there is no such directory, or if it holds a
   *   parameters.prm that rift did not write.
   * @throws DiskError if it cannot be written.
   */
  void
  reopen_output_directory(const std::string &directory);

  /**
   * Removes the results that a run writes at its end, as a run that goes on is
   * no longer at its end.
   *
   * @throws DiskError if they cannot be removed.
   */
  void
  remove_results_of_end(const std::string &directory);

  /** Whether rift gives this name (without folder) to a file of results. */
  bool
  is_result_file(const std::string &name);
} // namespace rift

#endif
