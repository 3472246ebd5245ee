#include <rift/app/command_line.h>
#include <rift/base/exceptions.h>

#include <CLI/CLI.hpp>

namespace rift
{
  CommandLine
  parse_command_line(const int argc, const char *const *argv)
  {
    CommandLine              result;
    std::vector<std::string> scenes;
    std::string              output;
    bool validate = false, defaults = false, reference = false;
    bool version = false;

    CLI::App app("rift: dynamic fracture of rock in three dimensions.", "rift");
    app.add_option("scene", scenes, "The scene, a .prm file");
    app
      .add_option("--set",
                  result.overrides,
                  "Set an entry of the scene; may be given several times. "
                  "Paths are relative to the scene.")
      ->type_name("\"Section/Name=value\"")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
    const CLI::Option *has_output =
      app
        .add_option("--output",
                    output,
                    "Where the results go; short for --set "
                    "Output/Directory=DIR")
        ->type_name("DIR");
    CLI::Option *const restart =
      app.add_flag("--restart",
                   result.restart,
                   "Go on from the newest checkpoint in the output directory");
    app
      .add_flag("--validate",
                validate,
                "Check the scene and its mesh without running it; a good one "
                "ends with \"... is a valid scene.\" and exit code 0")
      ->excludes(restart);
    app.add_flag("--defaults", defaults, "Print a scene with every entry");
    app.add_flag("--reference",
                 reference,
                 "Print a table of all entries in Markdown");
    app.add_flag("--version", version, "Print the version");

    const std::string hint = " Run \"rift --help\" for what there is.";
    try
      {
        app.parse(argc, argv);
      }
    catch (const CLI::CallForHelp &)
      {
        result.action = CommandLine::Action::print_text;
        result.text   = app.help();
        return result;
      }
    catch (const CLI::ParseError &error)
      {
        throw InputError(std::string("command line: ") + error.what() + "." +
                         hint);
      }

    if (version)
      {
        result.action = CommandLine::Action::print_text;
        result.text   = "rift " RIFT_VERSION "\n";
        return result;
      }
    if (defaults || reference)
      {
        result.action = defaults ? CommandLine::Action::print_defaults :
                                   CommandLine::Action::print_reference;
        return result;
      }
    if (scenes.size() != 1)
      throw InputError("command line: " +
                       (scenes.empty() ?
                          std::string("a scene is missing.") :
                          "there is more than one scene, \"" + scenes[0] +
                            "\" and \"" + scenes[1] + "\".") +
                       hint);
    if (validate)
      result.action = CommandLine::Action::validate;
    if (has_output->count() > 0)
      result.overrides.push_back("Output/Directory=" + output);
    result.scene = scenes.front();
    return result;
  }
} // namespace rift
