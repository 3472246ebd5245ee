#ifndef rift_app_simulation_h
#define rift_app_simulation_h

#include <rift/app/fragment_watch.h>
#include <rift/app/module_list.h>
#include <rift/app/restart.h>
#include <rift/app/results.h>
#include <rift/app/run_record.h>
#include <rift/base/signals.h>
#include <rift/io/checkpoint_writer.h>
#include <rift/time_integration/critical_time_step.h>
#include <rift/time_integration/energy_ledger.h>
#include <rift/time_integration/step_choice.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace rift
{
  /**
   * A scene in motion: the body, the modules that act on it and the loop over
   * the steps.
   */
  class Simulation
  {
  public:
    /**
     * Makes everything ready for the first step; writes no file.
     *
     * @param log must outlive this object.
     * @param communicator of the ranks among which the body is divided.
     * @param restart where to go on from; null: from the start.
     * @param record of the run so far, when its cells are divided anew.
     */
    Simulation(
      const Parameters          &parameters,
      Log                       &log,
      const Communicator        &communicator = Communicator(MPI_COMM_WORLD),
      const Restart             *restart      = nullptr,
      std::shared_ptr<RunRecord> record       = std::make_shared<RunRecord>());

    /** How run() has ended. */
    enum class Outcome
    {
      done,

      /** At a checkpoint, from which a simulation with a new division of the
       * cells among the ranks is to go on. */
      repartition
    };

    /**
     * Opens the output directory, computes all steps, writes the results and,
     * when due, checkpoints.
     *
     * @param signals that stop the run; null: none do.
     * @throws Error with ExitCode::stopped_by_signal, after a checkpoint.
     */
    Outcome
    run(const StopSignals *signals = nullptr);

    /**
     * Goes from t_n to t_(n+1); the last call stops before the kick, at the
     * end time. Writes results only within run().
     */
    void
    step();

    // What tests look at.

    /** The cells and nodes that this rank sees. */
    const Topology &
    topology() const
    {
      return body.discretization.topology;
    }

    /** Motion and forces of the nodes that this rank sees, at the time t_n. */
    const State &
    state() const
    {
      return body.discretization.state;
    }

    /** The balance of energy, at the last time at which it was due. */
    const EnergyLedger &
    energy_ledger() const
    {
      return ledger;
    }

    /** Length of the time step, s. */
    double
    time_step() const
    {
      return steps.time_step;
    }

    /** Number of the step at the end time. */
    std::uint64_t
    n_steps() const
    {
      return steps.last_step;
    }

  private:
    void
    choose_time_step(const Restart *restart);

    /** Refuses loads that cannot have any effect, and warns of others. */
    void
    check_loads() const;

    /** Makes the modules ready and moves the body to where it starts. */
    void
    prepare(const Restart *restart);

    /** What the modules see of the step. */
    StepContext
    step_context();

    /** Cuts the faces that modules have chosen. */
    TopologyChange
    cut_faces(StepContext &step);

    /** Has ghost cells follow their owners and tells other ranks of cracks.
     * Collective. */
    void
    follow_owners(StepContext &step, const TopologyChange &change);

    /**
     * Once faces have failed and when it is due: finds the pieces, and tells
     * modules and the user of them. Collective.
     *
     * @param is_end whether the run has come to its end: due in any case.
     */
    void
    follow_fragments(bool is_end = false);

    /** From time to time, and at the end: tells the user what modules warn of.
     * Collective. */
    void
    warn_of_modules(bool is_end = false);

    /** Writes a checkpoint of the state between two steps. Collective. */
    void
    write_checkpoint();

    /** Everything that a restart needs to know. Collective. */
    Archive
    archive() const;

    /** What the cells of this rank cost. Collective. */
    std::vector<CellCost>
    cell_costs() const;

    /** Time that an item of a module takes in a step over that of a cell.
     * Collective. */
    double
    cost_per_item(Stage stage, std::int64_t n_items) const;

    /** Whether one rank computes too long while the others wait. Collective. */
    bool
    is_unbalanced();

    [[noreturn]] void
    stop() const;

    /** Collective. */
    FaceCounts
    count_faces() const;

    /** What the run has come to so far. Collective. */
    Summary
    summarize() const;

    /** Writes the last results. */
    void
    finish();

    /**
     * Writes what a run has come to that has failed: a last row of the
     * histories, a last state and the summary. An error on the way goes to the
     * log, so that the first one can still be thrown. Collective.
     */
    void
    finish_failed(const std::string &message);

    /** Warnings about what the run has come to. */
    void
    warn_of_results(const FaceCounts &faces);

    /** Says how the run has ended. */
    void
    log_end(const FaceCounts &faces);

    /** What the modules have of the energies at t_n. */
    EnergyTable
    energies() const;

    /** Enters the energies at t_n into the ledger. */
    void
    enter_energies();

    /** @throws RunError on all ranks if the residual is too large. */
    void
    judge_residual() const;

    void
    write_due_results();

    /** Calls `f`; a RunError that all ranks throw there is kept in mind until
     * this step, or the next, is complete up to its results. */
    void
    guard(const std::function<void()> &f);

    /**
     * Finds out whether all ranks are well. Each rank goes on after a failure
     * until then, so that none waits for it in vain. Collective.
     *
     * @throws RunError on all ranks if something has failed on any.
     */
    void
    synchronize_status();

    /** Throws the first failure of all ranks, if there is any. Collective. */
    void
    throw_first_failure() const;

    /** "step 12, t = 1e-6 s, time step 0.9 times its safe bound" */
    std::string
    moment_text(std::uint64_t step) const;

    /** "the fastest node moves with 7 m/s at (0, 0, 0) m" */
    std::string
    fastest_node_text() const;

    Snapshot
    snapshot() const;

    const std::shared_ptr<RunRecord> record;
    StageTimer                      &timer;
    const Parameters                 parameters;
    Log                             &log;
    const MeshData                   mesh;
    Body                             body;
    Modules                          modules;
    FragmentWatch                    fragment_watch;

    CriticalTimeStep critical{};
    StepChoice       steps{};
    EnergyLedger     ledger;
    Failures         failures;
    Results          results;

    /** Where the files of a run before have come to. */
    std::optional<SavedResults>     saved_results;
    std::optional<CheckpointWriter> checkpoint_writer;

    const StopSignals *stop_signals = nullptr;
    bool               must_stop = false, is_checkpoint_due = false;
    double             busy_before = 0;

    std::chrono::steady_clock::time_point last_checkpoint;

    std::uint64_t                         next_synchronization         = 0;
    std::uint64_t                         step_of_last_synchronization = 0;
    std::chrono::steady_clock::time_point last_synchronization =
      std::chrono::steady_clock::now();
  };
} // namespace rift

#endif
