#ifndef rift_discretization_work_h
#define rift_discretization_work_h

#include <rift/base/archive.h>
#include <rift/base/exact_sum.h>
#include <rift/discretization/state.h>

namespace rift
{
  /**
   * Work of forces on the nodes that this rank owns. A force works over half a
   * step with the velocity before the kick and over half a step with that
   * after: the trapezoidal rule over time, for which the energy of the central
   * differences is exact (doc/theory.md, section 7).
   */
  class Work
  {
  public:
    /** The topology must outlive this object. */
    explicit Work(const Topology &topology)
      : topology(topology)
    {
    }

    /** To be called in each step before the first add(). */
    void
    begin_step()
    {
      until_now.add(after_kick);
      after_kick = ExactSum();
    }

    /** Adds a force, N, on a node; between the last force and the kick. */
    void
    add(const State           &state,
        const NodeIndex        node,
        const Vector3<double> &force,
        const double           time_step)
    {
      const double power = dot(force, state.velocity[node].vector());
      add(node,
          power,
          power + time_step / state.mass[node] *
                    dot(force, state.force[node].vector()),
          time_step);
    }

    /** Adds the power of a force on a node before and after the kick, W. */
    void
    add(const NodeIndex node,
        const double    power_before,
        const double    power_after,
        const double    time_step)
    {
      if (!topology.owns_node(node))
        return;
      until_now.add(.5 * time_step * power_before);
      after_kick.add(.5 * time_step * power_after);
    }

    /** Work up to t_n, J. */
    const ExactSum &
    sum() const
    {
      return until_now;
    }

    /** Writes it under the name of what does the work. */
    void
    save(const std::string &name, Archive &archive) const
    {
      archive.write_sum(name + ": work until now", until_now);
      archive.write_sum(name + ": work after the kick", after_kick);
    }

    /** Continues from what save() has written under this name. */
    void
    load(const std::string &name, const Archive &archive)
    {
      until_now  = archive.read_sum(name + ": work until now");
      after_kick = archive.read_sum(name + ": work after the kick");
    }

  private:
    const Topology &topology;
    ExactSum        until_now, after_kick;
  };
} // namespace rift

#endif
