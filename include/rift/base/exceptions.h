#ifndef rift_base_exceptions_h
#define rift_base_exceptions_h

#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rift
{
  /** What the program returns to the shell. */
  enum class ExitCode
  {
    done              = 0,
    input_error       = 1,
    run_error         = 2,
    disk_error        = 3,
    stopped_by_signal = 4
  };

  /**
   * Something that ends the program and that the user can mend. The message
   * says what is wrong, the value found, where, and what to do about it.
   */
  class Error : public std::runtime_error
  {
  public:
    /** An error after which the program ends with this exit code. */
    Error(const ExitCode exit_code, const std::string &message)
      : std::runtime_error(message)
      , exit_code(exit_code)
    {
    }

    /** Exit code of the program. */
    const ExitCode exit_code;
  };

  /** The scene, its mesh, a table or the command line is wrong. */
  class InputError : public Error
  {
  public:
    /** See Error for what the message says. */
    explicit InputError(const std::string &message)
      : Error(ExitCode::input_error, message)
    {
    }
  };

  /** The computation has left the rails. */
  class RunError : public Error
  {
  public:
    /** See Error for what the message says. */
    explicit RunError(const std::string &message)
      : Error(ExitCode::run_error, message)
    {
    }
  };

  /**
   * An error that all ranks throw at the same place, so that they can still do
   * something together before the program ends.
   */
  class CollectiveError : public Error
  {
  public:
    /** An error that all ranks throw together, with this exit code and message. */
    using Error::Error;
  };

  /** A file could not be written in full. */
  class DiskError : public Error
  {
  public:
    /** See Error for what the message says. */
    explicit DiskError(const std::string &message)
      : Error(ExitCode::disk_error, message)
    {
    }
  };

  /**
   * What the user is told of any exception: an Error as it is, a lack of memory
   * and what rift does not foresee as an Error with ExitCode::run_error.
   */
  Error
  to_error(const std::exception &exception);

  /**
   * Calls all of these functions in turn, also those behind one that throws,
   * and then throws the Error of the first that has: where each saves something
   * that must not be lost because of another.
   */
  void
  call_all(const std::vector<std::function<void()>> &functions);
} // namespace rift

#endif
