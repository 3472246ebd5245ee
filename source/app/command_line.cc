#include <rift/app/command_line.h>
#include <rift/base/exceptions.h>

#include <CLI/CLI.hpp>

namespace rift
{
  namespace
  {
    const std::string hint = " Run \"rift --help\" for what there is.";

    /** What the command line says, as it stands there. */
    struct Given
    {
      std::vector<std::string> scenes, overrides;
      std::string              output;
      bool validate = false, restart = false, defaults = false;
      bool reference = false, version = false;
    };

    void
    add_options(CLI::App &app, Given &given)
    {
      app.add_option("scene", given.scenes, "The scene, a .prm file");
      app
        .add_option("--set",
                    given.overrides,
                    "Set an entry of the scene; may be given several times. "
                    "Paths are relative to the scene.")
        ->type_name("\"Section/Name=value\"")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
      app
        .add_option("--output",
                    given.output,
                    "Where the results go; short for --set "
                    "Output/Directory=DIR")
        ->type_name("DIR");
      CLI::Option *const restart = app.add_flag(
        "--restart",
        given.restart,
        "Go on from the newest checkpoint in the output directory");
      app
        .add_flag("--validate",
                  given.validate,
                  "Check the scene and its mesh without running it; a good one "
                  "ends with \"... is a valid scene.\" and exit code 0")
        ->excludes(restart);
      app.add_flag("--defaults",
                   given.defaults,
                   "Print a scene with every entry");
      app.add_flag("--reference",
                   given.reference,
                   "Print a table of all entries in Markdown");
      app.add_flag("--version", given.version, "Print the version");
    }

    void
    check_scenes(const std::vector<std::string> &scenes)
    {
      if (scenes.empty())
        throw InputError("command line: a scene is missing." + hint);
      if (scenes.size() > 1)
        throw InputError("command line: there is more than one scene, \"" +
                         scenes[0] + "\" and \"" + scenes[1] + "\"." + hint);
    }
  } // namespace

  CommandLine
  parse_command_line(const int argc, const char *const *argv)
  {
    CommandLine result;
    Given       given;
    CLI::App app("rift: dynamic fracture of rock in three dimensions.", "rift");
    add_options(app, given);
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

    if (given.version)
      {
        result.action = CommandLine::Action::print_text;
        result.text   = "rift " RIFT_VERSION "\n";
        return result;
      }
    if (given.defaults || given.reference)
      {
        result.action = given.defaults ? CommandLine::Action::print_defaults :
                                         CommandLine::Action::print_reference;
        return result;
      }
    check_scenes(given.scenes);
    if (given.validate)
      result.action = CommandLine::Action::validate;
    result.restart   = given.restart;
    result.overrides = given.overrides;
    if (app.count("--output") > 0)
      result.overrides.push_back("Output/Directory=" + given.output);
    result.scene = given.scenes.front();
    return result;
  }
} // namespace rift
