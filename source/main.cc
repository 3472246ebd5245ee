#include <deal.II/base/mpi.h>

#include <rift/app/execute.h>
#include <rift/base/exceptions.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

namespace
{
  void
  execute(const rift::CommandLine &command, const bool speaks)
  {
    // The other ranks have nothing to print.
    const bool   is_run = command.action == rift::CommandLine::Action::run;
    std::ostream nowhere(nullptr);
    // Results go to files: a run does not need anybody who reads what it
    // prints, and goes on when its pipe is closed or its disk full.
    if (is_run)
      std::signal(SIGPIPE, SIG_IGN);
    rift::execute(speaks ? std::cout : nowhere, command);
    if (is_run)
      return;
    if (speaks && !std::cout.flush())
      throw rift::DiskError("cannot write to the standard output.");
  }

  /**
   * Waits a little for all ranks to end with an error. Most errors are the same
   * on all of them; when one of them is alone with its error, the others would
   * wait for it for ever.
   */
  bool
  all_have_failed(const MPI_Comm communicator)
  {
    constexpr std::chrono::seconds patience(5);

    MPI_Request request;
    MPI_Ibarrier(communicator, &request);
    const auto start = std::chrono::steady_clock::now();
    int        done  = 0;
    while (std::chrono::steady_clock::now() - start < patience)
      {
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (done != 0)
          return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    return false;
  }

  /** Says what is wrong, once, and ends all ranks. */
  int
  fail(const std::string   &message,
       const rift::ExitCode exit_code,
       const MPI_Comm       communicator)
  {
    const int  code   = static_cast<int>(exit_code);
    const bool failed = all_have_failed(communicator);
    // What was printed before the error stands before it.
    std::cout.flush();
    if (!failed || dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      // In one piece, since mpirun mixes the pieces of both outputs.
      std::cerr << "rift: error: " + message + "\n";
    if (!failed)
      MPI_Abort(communicator, code);
    return code;
  }
} // namespace

int
main(int argc, char **argv)
{
  // A file beyond the limit on its size is to be an error with a message.
  std::signal(SIGXFSZ, SIG_IGN);
  // One thread: ranks are rift's only kind of parallelism.
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // Of its own, since other ranks may be in the midst of a call on the world.
  MPI_Comm for_errors;
  MPI_Comm_dup(MPI_COMM_WORLD, &for_errors);
  const bool speaks =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  int exit_code = static_cast<int>(rift::ExitCode::done);
  try
    {
      execute(rift::parse_command_line(argc, argv), speaks);
    }
  catch (const std::exception &exception)
    {
      const rift::Error error = rift::to_error(exception);
      exit_code               = fail(error.what(), error.exit_code, for_errors);
    }
  MPI_Comm_free(&for_errors);
  return exit_code;
}
