#ifndef rift_app_results_h
#define rift_app_results_h

#include <rift/app/module_list.h>
#include <rift/base/stage_timer.h>
#include <rift/io/checkpoint_file.h>
#include <rift/io/probes.h>
#include <rift/io/summary.h>
#include <rift/io/vtu_output.h>
#include <rift/rigid/rigid_bodies.h>
#include <rift/time_integration/energy_ledger.h>

#include <optional>

namespace rift
{
  /** What results are made from, at one time t_n. */
  struct Snapshot
  {
    /** What is shown, with the energies and the time step, s. */
    const Body         &body;
    const Modules      &modules;
    const EnergyLedger &ledger;
    double              time_step;
  };

  /** How far the files of a run have come, for a checkpoint. */
  struct SavedResults
  {
    /** Numbers of states for ParaView and of rows of the histories. */
    std::uint64_t n_solutions = 0, n_rows = 0;

    /** Lengths of probes.csv and energy.csv in bytes. */
    std::uint64_t probes_length = 0, energy_length = 0;

    /** States in solid.pvd and fracture.pvd. */
    std::vector<SolutionSeries::WrittenState> solid, fracture;

    /** Stores it in the file of a checkpoint. */
    void
    write(CheckpointFileWriter &file) const;

    /** Reads what write() has stored. */
    static SavedResults
    read(const CheckpointFileReader &file);
  };

  /**
   * The files of a run. Each is written when it is due, none that was not
   * asked for. All ranks call the functions together; histories, the summary
   * and the like come from rank 0 alone.
   */
  class Results
  {
  public:
    /**
     * Finds the places of the probes; nothing is written before open().
     *
     * @throws InputError if a probe lies outside of the body.
     */
    Results(const Parameters &parameters, const Body &body);

    /**
     * Makes the output directory ready and writes parameters.prm. Without this
     * call nothing is ever due.
     *
     * @param energies whose names become the columns of energy.csv.
     * @throws InputError or DiskError if the directory cannot be used.
     */
    void
    open(const Parameters &parameters, const Energies &energies, Log &log);

    /**
     * Like open(), but goes on after a restart: what is behind the checkpoint
     * will be written again.
     */
    void
    reopen(const Parameters   &parameters,
           const Energies     &energies,
           const SavedResults &saved,
           Log                &log);

    /** Brings the histories to the disk and says how far all has come. */
    SavedResults
    synchronize();

    /** Whether open() has been called. */
    bool
    is_open() const
    {
      return was_opened;
    }

    /** Whether a row of the histories is due at this time. */
    bool
    is_history_due(double time, double time_step) const;

    /** Whether a state for ParaView is due at this time. */
    bool
    is_solution_due(double time, double time_step) const;

    /** Whether states for ParaView are written at all. */
    bool
    has_solutions() const
    {
      return solid.has_value();
    }

    /** Adds a row to energy.csv and probes.csv. */
    void
    write_history(const Snapshot &snapshot);

    /** Adds a state to solid.pvd and fracture.pvd, if there are any. */
    void
    write_solution(const Snapshot &snapshot);

    /** Writes what has been collected but not yet written. */
    void
    flush();

    /**
     * Writes fragments.csv and summary.json: at the end, or where the run has
     * failed.
     *
     * @param summary with what the snapshot does not tell.
     */
    void
    finish(const Snapshot &snapshot, Summary summary);

  private:
    /** What open() does on rank 0. */
    void
    open_files(const Parameters &parameters,
               const Energies   &energies,
               Log              &log);

    void
    make_series(const Parameters &parameters);

    std::vector<std::string>
    probe_columns() const;

    std::string
    path(const std::string &file) const
    {
      return directory + "/" + file;
    }

    const Communicator   communicator;
    const std::string    directory;
    const double         solution_interval, history_interval;
    const int            ranks_per_file;
    const FieldSelection output_fields;
    bool                 was_opened  = false;
    std::uint64_t        n_solutions = 0, n_rows = 0;
    const std::size_t    initial_nodes;

    std::vector<Probe> probes;

    /** On rank 0. */
    std::optional<HistoryFile> probes_file, energy_file;

    std::optional<SolutionSeries> solid, fracture;
  };
} // namespace rift

#endif
