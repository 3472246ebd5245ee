#ifndef rift_module_module_h
#define rift_module_module_h

#include <rift/base/stage_timer.h>
#include <rift/base/warning.h>
#include <rift/discretization/discretization.h>
#include <rift/discretization/field_list.h>
#include <rift/discretization/fragments.h>
#include <rift/discretization/prescribed_acceleration.h>
#include <rift/module/energy_table.h>
#include <rift/module/failures.h>
#include <rift/module/step_limits.h>

#include <functional>
#include <optional>

namespace rift
{
  /** What a module sees of the step that is being computed. */
  struct StepContext
  {
    /** The body, which changes in the step. */
    Discretization &body;

    /** s */
    const double time_step;

    /** Takes what goes wrong on this rank. */
    Failures &failures;

    /** Acceleration of a component of a node, m/s^2, where a module prescribes
     * it; empty where none does. */
    PrescribedAcceleration prescribed_acceleration;

    /** Corners of faces that open in this step; after the drift those that
     * other ranks have told of, too. */
    std::vector<OpeningCorner> openings;

    /** What this rank tells others of corners of cells; after the drift what
     * they have told. */
    std::vector<CornerNews> news;
  };

  /** Whether a component of the velocity of a node is prescribed. */
  using IsPrescribed =
    std::function<bool(NodeIndex node, unsigned int component)>;

  /** Number of things that a module computes at each cell in a step, such as
   * cohesive faces, for the division among the ranks. */
  using WorkItems = std::vector<std::uint32_t>;

  /**
   * A part of the physics. A simulation has a list of those that its scene
   * needs and knows no more of them than these hooks, which do nothing unless a
   * module overrides them. They are called in the order of the list, once per
   * stage of the step (Simulation::step), never per cell.
   *
   * Hooks marked *collective* may use the communicator. Where one throws an
   * error, it must do so on all ranks; what a rank alone finds goes to
   * StepContext::failures.
   */
  class Module
  {
  public:
    Module()               = default;
    Module(const Module &) = delete;

    /** Can be moved, but not copied. */
    Module(Module &&) noexcept = default;
    Module &
    operator=(const Module &) = delete;
    virtual ~Module()         = default;

    /** The stage in which add_forces() is called, and to which its time
     * counts. */
    virtual Stage
    stage() const = 0;

    /** Says what it needs of the time step; see StepLimits. Collective. */
    virtual void
    limit_step(StepLimits &) const
    {
    }

    /** Makes ready for the first step; the time step has been chosen. New runs
     * and restarts alike. Collective. */
    virtual void
    prepare(Discretization &, const StepBound &)
    {
    }

    /** A sentence for the log about what prepare() has made; empty: none.
     * Collective. */
    virtual std::string
    description() const
    {
      return {};
    }

    /**
     * Refuses what the scene says of it if that cannot have any effect, since
     * all velocities along its forces are prescribed. The body is undeformed.
     * Collective.
     *
     * @throws InputError on all ranks, with the subsection, the entry and its
     *   value.
     */
    virtual void
    check_effect(const Discretization &, const IsPrescribed &) const
    {
    }

    /** Sentences for the log, on rank 0, about entries of the scene that may
     * not do what they seem to, in this number of steps. Collective. */
    virtual std::vector<std::string>
    warnings(const Discretization &,
             double /*time_step*/,
             std::uint64_t /*n_steps*/) const
    {
      return {};
    }

    /** Last thing before the first step of a new run, not after a restart.
     * Collective. */
    virtual void
    begin(StepContext &)
    {
    }

    /** Adds the faces that are to be cut, ascending. All ranks that see the
     * two cells of a face must decide the same. */
    virtual void
    choose_cuts(const StepContext &, std::vector<FaceIndex> &)
    {
    }

    /** Takes in that nodes have split on this rank, in this step. */
    virtual void
    follow_cut(const StepContext &step, const TopologyChange &change)
    {
      update_nodes(vertices_of(step.body.topology, change.splits));
    }

    /** Takes in that corners at these vertices have other nodes than before.
     * Also after a restart, before load(). */
    virtual void
    update_nodes(const std::vector<VertexIndex> &)
    {
    }

    /** Adds its forces at t_n to the state's. */
    virtual void
    add_forces(StepContext &)
    {
    }

    /** Holds nodes that have parted in this step together: all forces but those
     * of constrain() are known. */
    virtual void
    hold_partings(StepContext &)
    {
    }

    /** In step 0, when all velocities have been set back by half a step: sets
     * those that it knows better. Collective. */
    virtual void
    start_velocities(StepContext &)
    {
    }

    /** Adds forces that depend on all others, or replaces them by those that a
     * constraint needs. Collective. */
    virtual void
    constrain(StepContext &)
    {
    }

    /** Adds up the work of its forces: all of them are known, and the kick is
     * still to come. */
    virtual void
    count_work(const StepContext &)
    {
    }

    /** The positions of all nodes are those at t_(n+1). Collective. */
    virtual void
    after_drift(StepContext &)
    {
    }

    /** Last in the step: takes in what has opened. */
    virtual void
    start_openings(StepContext &)
    {
    }

    /** Whether what it does depends on follow_fragments(), so that the pieces
     * are to be found often. */
    virtual bool
    needs_fragments() const
    {
      return false;
    }

    /** Takes in, from time to time once faces have failed, which pieces there
     * are. Collective.
     *
     * @return about what makes no sense any more; the same on all ranks. */
    virtual std::vector<Warning>
    follow_fragments(const Fragments &, const Communicator &)
    {
      return {};
    }

    /** About what has gone wrong so far, though not so that the run must end;
     * asked for from time to time and at the end. Collective.
     *
     * @return the same on all ranks. */
    virtual std::vector<Warning>
    warnings_so_far() const
    {
      return {};
    }

    /** Whether it prescribes a component of the velocity of a node. */
    virtual bool
    prescribes(NodeIndex, unsigned int /*component*/) const
    {
      return false;
    }

    /** Acceleration during this step of a component of a node, m/s^2, if it is
     * prescribed. */
    virtual std::optional<double>
    prescribed_acceleration(const State &,
                            double /*time_step*/,
                            NodeIndex,
                            unsigned int /*component*/) const
    {
      return {};
    }

    /** Adds the energies at t_n to the table, J; always the same names. */
    virtual void
    account(const Discretization &, EnergyTable &) const
    {
    }

    /** Declares what output and probes can show of it. A name that is new must
     * be in known_fields() (io/solution_fields.h) as well. */
    virtual void
    declare_fields(FieldList &) const
    {
    }

    /** Writes what it needs to continue. Collective. */
    virtual void
    save(const Discretization &, Archive &) const
    {
    }

    /** Continues from what save() has written on any number of ranks.
     * Collective. */
    virtual void
    load(const Discretization &, const Archive &)
    {
    }

    /** Adds 1 to the cell of each thing that it computes in a step. */
    virtual void
    count_items(const Topology &, WorkItems &) const
    {
    }
  };
} // namespace rift

#endif
