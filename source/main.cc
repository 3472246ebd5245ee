#include <deal.II/base/mpi.h>

#include <rift/app/command_line.h>
#include <rift/app/parameter_reference.h>
#include <rift/app/parameters.h>
#include <rift/app/run.h>
#include <rift/base/exceptions.h>

#include <csignal>
#include <iostream>
#include <new>

namespace
{
  void
  execute(const rift::CommandLine &command, const bool speaks)
  {
    using Action = rift::CommandLine::Action;
    // The other ranks have nothing to print.
    std::ostream  nowhere(nullptr);
    std::ostream &out = speaks ? std::cout : nowhere;
    switch (command.action)
      {
      case Action::print_text:
        out << command.text;
        break;
      case Action::print_defaults:
        rift::print_defaults(out);
        break;
      case Action::print_reference:
        rift::generate_reference(out);
        break;
      case Action::validate:
        rift::validate_scene(
          out,
          rift::read_parameters(command.scene, command.overrides));
        break;
      case Action::run:
        rift::run_simulation(
          rift::read_parameters(command.scene, command.overrides),
          command.restart);
        break;
      }
    if (speaks && !std::cout.flush())
      throw rift::DiskError("cannot write to the standard output.");
  }

  int
  complain(const std::string   &message,
           const rift::ExitCode exit_code,
           const bool           speaks)
  {
    if (speaks)
      std::cerr << "rift: error: " << message << std::endl;
    return static_cast<int>(exit_code);
  }
  /** For what has happened on this rank alone: the others may wait for it. */
  int
  give_up(const std::string &message)
  {
    const int exit_code = complain(message, rift::ExitCode::run_error, true);
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      MPI_Abort(MPI_COMM_WORLD, exit_code);
    return exit_code;
  }
} // namespace

int
main(int argc, char **argv)
{
  // A file beyond the limit on its size is to be an error with a message.
  std::signal(SIGXFSZ, SIG_IGN);
  // One thread: ranks are rift's only kind of parallelism.
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const bool speaks =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  try
    {
      execute(rift::parse_command_line(argc, argv), speaks);
    }
  catch (const rift::Error &error)
    {
      return complain(error.what(), error.exit_code, speaks);
    }
  catch (const std::bad_alloc &)
    {
      return give_up("the memory of this machine is too small for this "
                     "scene. Use larger elements.");
    }
  catch (const std::exception &error)
    {
      return give_up(std::string("rift has failed in a way that it does not "
                                 "foresee. Please report this: ") +
                     error.what());
    }
  return static_cast<int>(rift::ExitCode::done);
}
