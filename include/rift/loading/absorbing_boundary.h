#ifndef rift_loading_absorbing_boundary_h
#define rift_loading_absorbing_boundary_h

#include <rift/discretization/activity.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/work.h>
#include <rift/mesh/surface.h>
#include <rift/module/module.h>

#include <functional>
#include <vector>

namespace rift
{
  /**
   * A surface behind which the body goes on for ever: dashpots take in the
   * waves that arrive across it (Lysmer & Kuhlemeyer 1969; doc/theory.md, eq.
   * 32). They act with the mean velocity of the step, so that they neither
   * shorten the time step nor make energy.
   */
  class AbsorbingBoundary : public Module
  {
  public:
    /** Impedance, Pa s/m, of a material for waves along a normal. */
    using Impedance =
      std::function<Matrix3<double>(std::uint16_t          material,
                                    const Vector3<double> &normal)>;

    /** @param name of the surface. */
    AbsorbingBoundary(const std::string       &name,
                      const Topology          &topology,
                      const ReferenceCellData &reference,
                      Surface                  surface,
                      Impedance                impedance);

    Stage
    stage() const override
    {
      return Stage::loads;
    }

    void
    constrain(StepContext &step) override
    {
      add_to(step.body.state, step.time_step);
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

    void
    account(const Discretization &, EnergyTable &energies) const override
    {
      energies["damping"].add(work_done.sum());
    }

    void
    save(const Discretization &, Archive &archive) const override
    {
      work_done.save(archive_name, archive);
    }

    void
    load(const Discretization &, const Archive &archive) override
    {
      work_done.load(archive_name, archive);
    }

    /**
     * Adds the forces of the dashpots. To be called after all other forces but
     * those of prescribed motion.
     */
    void
    add_to(State &state, double time_step);

    /**
     * Adds up the energy that goes: to be called between the last force and the
     * kick.
     */
    void
    count_work(const State &state, double time_step);

    /** Energy that has gone up to t_n, J, as of the last count_work(). */
    Work &
    work()
    {
      return work_done;
    }

    /** Takes in nodes that a crack has made. */
    void
    update_nodes();

  private:
    const std::string        archive_name;
    const Topology          &topology;
    const ReferenceCellData &reference;
    const Surface            surface;
    const Impedance          impedance;

    /** Nodes of the surface, ascending; the dashpot of each, kg/s; the force on
     * it, N. */
    std::vector<NodeIndex>       nodes;
    std::vector<Matrix3<double>> dashpots;
    std::vector<Vector3<double>> forces;

    Work work_done;
  };
} // namespace rift

#endif
