#ifndef rift_time_integration_central_difference_h
#define rift_time_integration_central_difference_h

#include <rift/base/exact_sum.h>
#include <rift/discretization/activity.h>
#include <rift/discretization/state.h>

namespace rift
{
  /**
   * Kick and drift of the central differences: v += dt f/m, u += dt v. Forces
   * are set to zero for the next step. Nodes that have never moved are passed
   * over.
   */
  void
  advance(State &state, const Activity &activity, double time_step);

  /**
   * Moves the velocities from t_0, at which they are given, half a step back,
   * where the first kick expects them.
   */
  void
  start_velocities(State &state, double time_step);

  /**
   * Kinetic energy at t_n of the nodes that this rank owns, from the velocities
   * before and after the kick, m v^- v^+ / 2, J: the form that central
   * differences conserve (doc/theory.md, eq. 23). To be called between the last
   * force and the kick.
   */
  ExactSum
  kinetic_energy(const Topology &topology,
                 const State    &state,
                 double          time_step);
} // namespace rift

#endif
