#ifndef rift_app_simulation_h
#define rift_app_simulation_h

#include <rift/app/body.h>
#include <rift/app/parameters.h>
#include <rift/app/restart.h>
#include <rift/app/results.h>
#include <rift/base/signals.h>
#include <rift/base/stage_timer.h>
#include <rift/cohesive/cohesive_force.h>
#include <rift/cohesive/insertion.h>
#include <rift/contact/contact_force.h>
#include <rift/io/checkpoint_writer.h>
#include <rift/loading/absorbing_boundary.h>
#include <rift/loading/body_force.h>
#include <rift/loading/prescribed_motion.h>
#include <rift/loading/surface_load.h>
#include <rift/rigid/rigid_bodies.h>
#include <rift/solid/damping.h>
#include <rift/time_integration/critical_time_step.h>
#include <rift/time_integration/energy_ledger.h>

#include <chrono>
#include <optional>

namespace rift
{
  /**
   * A scene in motion: the body, the modules that act on it and the loop over
   * the steps. Modules that the scene does not need are not constructed.
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
     */
    Simulation(const Parameters   &parameters,
               Log                &log,
               const Communicator &communicator = Communicator(MPI_COMM_WORLD),
               const Restart      *restart      = nullptr);

    /** How run() has ended. */
    enum class End
    {
      done,

      /** At a checkpoint, from which a simulation with a new division of the
       * cells among the ranks is to go on. */
      divide_anew
    };

    /**
     * Opens the output directory, computes all steps, writes the results and,
     * when due, checkpoints.
     *
     * @param signals that stop the run; null: none do.
     * @throws Error with ExitCode::stopped_by_signal, after a checkpoint.
     */
    End
    run(const StopSignals *signals = nullptr);

    /**
     * Goes from t_n to t_(n+1); the last call stops before the kick, at the
     * end time. Writes results only within run().
     */
    void
    step();

    // What tests look at.
    const Topology &
    topology() const
    {
      return body.discretization.topology;
    }

    const State &
    state() const
    {
      return body.discretization.state;
    }

    const EnergyLedger &
    energy_ledger() const
    {
      return ledger;
    }

    double
    time_step() const
    {
      return dt;
    }

    std::uint64_t
    n_steps() const
    {
      return last_step;
    }

  private:
    /** The cohesive elements; absent without a model. */
    struct Fracture
    {
      Fracture(Topology                              &topology,
               const ReferenceCellData               &reference,
               const std::vector<MaterialParameters> &materials,
               const CohesiveParameters              &parameters,
               const FaceSlope                       &slope,
               const Communicator                    &communicator)
        : strengths(topology, reference, materials, parameters, communicator)
        , force(topology, reference, strengths, parameters, slope)
      {
      }

      FaceStrengths strengths;
      CohesiveForce force;

      /** In the extrinsic model. */
      std::optional<Insertion> insertion;
    };

    void
    make_modules();

    void
    make_fracture();

    void
    make_rigid_bodies();

    void
    make_contact();

    /** What contact has to know of the cells. */
    std::vector<ContactCellConstants>
    contact_constants() const;

    PenaltySlopes
    penalty_slopes() const;

    /** Writes a checkpoint of the state between two steps. Collective. */
    void
    write_checkpoint();

    void
    choose_time_step(const Restart *restart);

    /** Moves the intact body to where the checkpoint has it. */
    void
    restore(const Restart &restart);

    /** The sums that a checkpoint must hold, always in the same order. */
    std::vector<ExactSum *>
    work_sums();

    /** Time that a cohesive face takes in a step over that of a cell. */
    double
    face_cost() const;

    /** Whether one rank computes too long while the others wait. Collective. */
    bool
    is_unbalanced();

    [[noreturn]] void
    stop() const;

    /** Writes the last results. */
    void
    finish(double cell_steps_per_second);

    /** Cuts faces; returns the nodes that this has split. */
    TopologyChange
    split_at(const std::vector<FaceIndex> &faces);

    /** Exchanges positions with the other ranks, and what has opened. */
    void
    follow_neighbours(const std::vector<NodeSplit> &splits,
                      std::vector<OpeningCorner>   &openings);

    /** Has the loads take in new nodes. */
    void
    update_surfaces();

    void
    count_work();

    /** Enters the energies at t_n into the ledger and judges the residual. */
    void
    balance_energy();

    void
    write_due_results();

    /** Keeps in mind that a cell has left its range, until agree(). */
    void
    note_failure(const FailedCell &failed);

    void
    note_failure(const DeepOverlap &deep);

    /**
     * Finds out whether all ranks are well. Each rank goes on after a failure
     * until then, so that none waits for it in vain. Collective.
     *
     * @throws RunError on all ranks if a cell has left its range on any.
     */
    void
    agree();

    [[noreturn]] void
    stop_failed() const;

    /** "step 12, t = 1e-6 s, time step 0.9 times its safe bound" */
    std::string
    moment_text() const;

    /** "the fastest node moves with 7 m/s at (0, 0, 0) m" */
    std::string
    fastest_node_text() const;

    Snapshot
    snapshot() const;

    /** The first cell that has left its range, and when. */
    struct Failure
    {
      std::uint64_t   step;
      GlobalCellIndex cell;
      std::string     message;
    };

    StageTimer       timer;
    const Parameters parameters;
    Log             &log;
    const MeshData   mesh;
    Body             body;

    std::vector<double>             densities;
    std::vector<Elasticity>         laws;
    std::vector<StiffnessMatrix>    stiffnesses;
    InternalForce                   internal_force;
    Activity                        activity;
    std::optional<Fracture>         fracture;
    std::optional<ContactForce>     contact;
    std::optional<Damping>          damping;
    std::vector<SurfaceLoad>        surface_loads;
    std::vector<AbsorbingBoundary>  absorbing_boundaries;
    std::optional<BodyForce>        body_force;
    std::optional<PrescribedMotion> prescribed_motion;
    std::optional<RigidBodies>      rigid_bodies;

    CohesiveFrequency penalty_frequency;
    CriticalTimeStep  critical{};
    double            dt        = 0;
    std::uint64_t     last_step = 0;
    EnergyLedger      ledger;
    Results           results;

    /** Where the files of a run before have come to. */
    std::optional<SavedResults>     saved_results;
    std::optional<CheckpointWriter> checkpoint_writer;

    const StopSignals *stop_signals = nullptr;
    bool               must_stop = false, is_checkpoint_due = false;
    double             busy_before = 0;
    std::uint64_t      first_step  = 0;

    std::chrono::steady_clock::time_point last_checkpoint;

    std::optional<Failure>                failure;
    std::uint64_t                         next_agreement         = 0;
    std::uint64_t                         step_of_last_agreement = 0;
    std::chrono::steady_clock::time_point last_agreement =
      std::chrono::steady_clock::now();
  };
} // namespace rift

#endif
