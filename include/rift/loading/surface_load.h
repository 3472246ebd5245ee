#ifndef rift_loading_surface_load_h
#define rift_loading_surface_load_h

#include <rift/discretization/activity.h>
#include <rift/loading/loading_parameters.h>
#include <rift/loading/time_function.h>
#include <rift/mesh/surface.h>
#include <rift/module/module_with_work.h>

#include <optional>
#include <vector>

namespace rift
{
  /**
   * Pressure and traction on one named surface. Pressure acts on the current
   * area and along the current normal; traction is per undeformed area and
   * keeps its direction.
   */
  class SurfaceLoad : public ModuleWithWork
  {
  public:
    /** @param parameters must have a pressure or a traction. */
    SurfaceLoad(const Topology           &topology,
                Surface                   surface,
                const BoundaryParameters &parameters);

    /** Whether there is a pressure or a traction. */
    static bool
    is_needed(const BoundaryParameters &parameters);

    Stage
    stage() const override
    {
      return Stage::loads;
    }

    void
    check_effect(const Discretization &body,
                 const IsPrescribed   &is_prescribed) const override;

    std::vector<std::string>
    warnings(const Discretization &body,
             double                time_step,
             std::uint64_t         n_steps) const override;

    void
    add_forces(StepContext &step) override
    {
      add_to(step.body.state, step.body.activity, step.time_step);
    }

    void
    count_work(const StepContext &step) override
    {
      count_work(step.body.state, step.time_step);
    }

    void
    update_nodes(const std::vector<VertexIndex> &) override
    {
      update_nodes();
    }

    bool
    needs_fragments() const override
    {
      return acts_while_in_place;
    }

    std::vector<Warning>
    follow_fragments(const Fragments    &fragments,
                     const Communicator &communicator) override;

    void
    save(const Discretization &, Archive &archive) const override;

    void
    load(const Discretization &, const Archive &archive) override;

    /** Adds the forces at `state.time`: see TimeFunction::mean_around(). */
    void
    add_to(State &state, Activity &activity, double time_step);

    /**
     * Adds up the work of the step: to be called between the last force and
     * the kick.
     */
    void
    count_work(const State &state, double time_step);

    /** Takes in nodes that a crack has made. */
    void
    update_nodes();

  private:
    const Topology                            &topology;
    const std::string                          boundary;
    const Surface                              surface;
    const bool                                 acts_while_in_place;
    std::optional<TimeFunction>                pressure;
    std::array<std::optional<TimeFunction>, 3> traction;

    /** Nodes of the surface, ascending; those of each face as positions in
     * that list; the force on each. */
    std::vector<NodeIndex>                    nodes;
    std::vector<std::array<std::uint32_t, 3>> face_positions;
    std::vector<Vector3<double>>              forces;

    /** Whether each face bears the load. */
    std::vector<std::uint8_t> bears_load;

    bool is_loaded = false;
  };
} // namespace rift

#endif
