#include <rift/app/execute.h>
#include <rift/app/parameter_reference.h>
#include <rift/app/parameters.h>
#include <rift/app/run.h>

#include <ostream>

namespace rift
{
  void
  execute(std::ostream &out, const CommandLine &command)
  {
    using Action = CommandLine::Action;
    switch (command.action)
      {
      case Action::print_text:
        out << command.text;
        break;
      case Action::print_defaults:
        print_defaults(out);
        break;
      case Action::print_reference:
        generate_reference(out);
        break;
      case Action::validate:
        validate_scene(out, read_parameters(command.scene, command.overrides));
        out << command.scene << " is a valid scene.\n";
        break;
      case Action::run:
        run_simulation(read_parameters(command.scene, command.overrides),
                       command.restart);
        break;
      }
  }
} // namespace rift
