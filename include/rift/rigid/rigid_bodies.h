#ifndef rift_rigid_rigid_bodies_h
#define rift_rigid_rigid_bodies_h

#include <rift/base/communicator.h>
#include <rift/discretization/activity.h>
#include <rift/discretization/field_list.h>
#include <rift/loading/time_function.h>
#include <rift/material/material_parameters.h>
#include <rift/module/module_with_work.h>
#include <rift/rigid/rigid_motion.h>
#include <rift/rigid/rigid_pieces.h>

#include <optional>
#include <vector>

namespace rift
{
  /**
   * The bodies whose cells do not deform. All ranks know the motion of all of
   * them; each moves the nodes that it sees. The forces on the nodes are
   * replaced by those that move them as a body, so that kick, drift and ledger
   * need not know of it. Mass and inertia are those of the lumped masses.
   */
  class RigidBodies : public ModuleWithWork
  {
  public:
    /**
     * Collective.
     *
     * @param state of the undeformed bodies.
     * @param materials by material index.
     */
    RigidBodies(const Topology                        &topology,
                const State                           &state,
                const RigidPieces                     &pieces,
                const std::vector<MaterialParameters> &materials,
                const Communicator                    &communicator);

    Stage
    stage() const override
    {
      return Stage::loads;
    }

    std::string
    description() const override
    {
      return "Rigid bodies: " + std::to_string(n_bodies());
    }

    std::vector<std::string>
    warnings(const Discretization &body,
             double                time_step,
             std::uint64_t         n_steps) const override;

    void
    start_velocities(StepContext &step) override
    {
      start(step.body.state, step.time_step);
    }

    void
    constrain(StepContext &step) override
    {
      move(step.body.state, step.body.activity, step.time_step);
    }

    void
    declare_fields(FieldList &list) const override
    {
      declare_fields(list, this);
    }

    void
    save(const Discretization &, Archive &archive) const override;

    void
    load(const Discretization &, const Archive &archive) override;

    /**
     * Sets the velocities half a step before the start, as
     * start_velocities() does for all else, which must have been called.
     * Collective.
     */
    void
    start(State &state, double time_step);

    /**
     * Moves the bodies to t_(n+1) and puts the forces on their nodes that take
     * those there. To be called between the last force and the kick.
     * Collective.
     *
     * @throws CollectiveError when a body turns too fast for the step; the
     *   others have been moved then.
     */
    void
    move(State &state, Activity &activity, double time_step);

    /** Number of bodies, on all ranks the same. */
    std::uint32_t
    n_bodies() const
    {
      return static_cast<std::uint32_t>(bodies.size());
    }

    /** The body that a cell belongs to, or invalid_index. */
    std::uint32_t
    body(const CellIndex cell) const
    {
      return body_of_slot[cell];
    }

    /** Whether nothing but its velocities moves a material. */
    bool
    is_driven(std::uint16_t material) const;

    bool
    prescribes(NodeIndex node, unsigned int component) const override;

    /** Force on all bodies of a material as of the last move(), N: of contact,
     * loads and gravity. The part of this rank. */
    std::array<ExactSum, dim>
    force(const std::string &material) const;

    /** Declares the force on the bodies of a material.
     * @param bodies null: the names alone. */
    static void
    declare_fields(FieldList &list, const RigidBodies *bodies);

  private:
    struct Body
    {
      std::uint16_t material;

      /** Those of its nodes that this rank moves, ascending. */
      std::vector<NodeIndex> nodes;
      RigidMass              mass;
      RigidMotion            motion;

      /** The part of this rank of force, N, and torque about the centre of
       * mass, Nm. */
      std::array<ExactSum, dim> force, torque;
      bool                      is_awake = false;
    };

    /** Velocities that are prescribed for all bodies of a material. */
    using Drive = std::array<std::optional<TimeFunction>, dim>;

    /** Force, N, and torque about the centre of mass, Nm. */
    struct Load
    {
      Vector3<double> force, torque;
    };

    void
    find_nodes();

    /** For each body the exact sums over its nodes of `terms(body, x)` times the
     * mass, for a node at x. Collective. */
    template <std::size_t n, typename Terms>
    std::vector<std::array<double, n>>
    sum_over_nodes(const State &state, const Terms &terms) const;

    /** Collective. */
    void
    compute_mass_properties(const State &state);

    /** Makes the sums of all bodies. */
    void
    sum_forces(const State &state);

    /** Of the bodies that move freely, on all ranks. Collective. */
    std::vector<Load>
    total_loads() const;

    /** What is prescribed, m/s. */
    using DrivenVelocity = std::array<std::optional<double>, dim>;

    /** By material, for a step from a time: see TimeFunction::mean_after(). */
    std::vector<DrivenVelocity>
    driven_velocities(double time, double time_step) const;

    /** The motion with the velocities after a kick. */
    RigidMotion
    kicked(const Body           &body,
           const Load           &load,
           const DrivenVelocity &driven,
           double                time_step) const;

    /** Has the nodes of a body go from where they are to where it is. */
    void
    move_nodes(const Body &body, State &state, double time_step);

    const Topology            &topology;
    const Communicator        &communicator;
    std::vector<std::uint32_t> body_of_slot;
    std::vector<Body>          bodies;
    std::vector<Drive>         drives;
    std::vector<std::string>   material_names;
  };
} // namespace rift

#endif
