#include <rift/app/run.h>
#include <rift/app/simulation.h>
#include <rift/base/launcher.h>
#include <rift/io/directory_lock.h>
#include <rift/io/output_directory.h>

#include <iostream>

namespace rift
{
  void
  validate_scene(std::ostream &out, const Parameters &parameters)
  {
    print_summary(out, parameters);
    const Communicator communicator(MPI_COMM_WORLD);
    Log                log(communicator.is_root() ? &out : nullptr);
    for (const std::string &warning : warnings(parameters))
      log.warn(warning);
    Simulation(parameters, log, communicator);
  }

  void
  run_simulation(const Parameters &parameters, const bool is_restart)
  {
    const Communicator communicator(MPI_COMM_WORLD);
    // To a program under mpirun a terminal and a pipe look the same.
    const bool interactive = communicator.size() == 1 && is_terminal();
    Log        log(communicator.is_root() ? &std::cout : nullptr, interactive);
    if (!parameters.title.empty())
      log.write(parameters.title);
    if (const std::string warning = warning_about_ranks(communicator.size());
        !warning.empty())
      log.warn(warning);
    // Before the mesh is made, which may take long. Rank 0 has the lock.
    std::optional<DirectoryLock> lock;
    communicator.on_root([&] {
      const OutputParameters &output = parameters.output;
      if (is_restart)
        reopen_output_directory(output.directory);
      else
        create_output_directory(output.directory);
      lock.emplace(output.directory);
      if (!is_restart)
        check_output_directory(output.directory, output.overwrite);
    });
    std::optional<Restart> restart;
    if (is_restart)
      restart = read_restart(parameters, communicator, log);
    const auto                 record = std::make_shared<RunRecord>();
    std::optional<StopSignals> signals;
    while (true)
      {
        {
          Simulation simulation(parameters,
                                log,
                                communicator,
                                restart ? &*restart : nullptr,
                                record);
          restart.reset();
          // Not before there is something to save. From then on no signal may
          // be lost, not even while the cells are divided anew.
          if (!signals)
            signals.emplace();
          if (simulation.run(&*signals) == Simulation::Outcome::done)
            return;
        }
        log.write("The ranks have unequal work: the cells are divided anew");
        restart = read_restart(parameters, communicator, log);
      }
  }
} // namespace rift
