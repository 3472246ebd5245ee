#ifndef rift_app_command_line_h
#define rift_app_command_line_h

#include <string>
#include <vector>

namespace rift
{
  /** What the user has asked for on the command line. */
  struct CommandLine
  {
    /** What the program does. */
    enum class Action
    {
      /** Compute the scene. */
      run,

      /** Read and check the scene, and say what it is. */
      validate,

      /** Print `text` and stop: help, version. */
      print_text,

      /** Print a scene with every entry. */
      print_defaults,

      /** Print doc/parameters.md. */
      print_reference
    };

    /** What is asked for. */
    Action action = Action::run;

    /** Path of the scene. */
    std::string scene;

    /** `Section/Name=value`, in their order; `--output` is one of them. */
    std::vector<std::string> overrides;

    /** Go on from the newest checkpoint in the output directory. */
    bool restart = false;

    /** What Action::print_text prints. */
    std::string text;
  };

  /** Throws InputError, with a hint to --help, for anything not understood. */
  CommandLine
  parse_command_line(int argc, const char *const *argv);
} // namespace rift

#endif
