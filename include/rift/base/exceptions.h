#ifndef rift_base_exceptions_h
#define rift_base_exceptions_h

#include <stdexcept>
#include <string>

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
    Error(const ExitCode exit_code, const std::string &message)
      : std::runtime_error(message)
      , exit_code(exit_code)
    {
    }

    const ExitCode exit_code;
  };

  /** The scene, its mesh, a table or the command line is wrong. */
  class InputError : public Error
  {
  public:
    explicit InputError(const std::string &message)
      : Error(ExitCode::input_error, message)
    {
    }
  };

  /** The computation has left the rails. */
  class RunError : public Error
  {
  public:
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
    using Error::Error;
  };

  /** A file could not be written in full. */
  class DiskError : public Error
  {
  public:
    explicit DiskError(const std::string &message)
      : Error(ExitCode::disk_error, message)
    {
    }
  };
} // namespace rift

#endif
