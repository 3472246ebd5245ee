#ifndef rift_solid_damping_h
#define rift_solid_damping_h

#include <rift/discretization/activity.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>

#include <vector>

namespace rift
{
  /**
   * Viscous stress eta d, with d the rate of deformation (doc/theory.md,
   * eq. 8), taken at the velocity of half a step ago. Only constructed when a
   * material has a viscosity.
   */
  class Damping
  {
  public:
    /** @param viscosities Pa s, one for each material index. */
    Damping(const Topology          &topology,
            const ReferenceCellData &reference,
            std::vector<double>      viscosities);

    /** Adds the viscous forces of all cells that are awake. */
    void
    add_to(State &state, const Activity &activity);

    /** Adds up what the step dissipates; between last force and kick. */
    void
    count_work(const State &state, double time_step);

    /** Energy dissipated up to t_n, J, as of the last count_work(). */
    double
    dissipated() const
    {
      return dissipated_until_now;
    }

  private:
    const Topology           &topology;
    const ReferenceCellData  &reference;
    const std::vector<double> viscosities;

    std::vector<NodalVector> forces;
    double dissipated_until_now = 0, dissipated_in_half_step = 0;
  };
} // namespace rift

#endif
