#ifndef rift_io_solution_fields_h
#define rift_io_solution_fields_h

#include <rift/cohesive/cohesive_force.h>
#include <rift/discretization/state.h>
#include <rift/io/fragments.h>
#include <rift/io/vtu_output.h>
#include <rift/solid/internal_force.h>

#include <string>
#include <vector>

namespace rift
{
  /**
   * The body as it is now: displacement and velocity of the nodes, Cauchy
   * stress, material and fragment of the cells.
   */
  Solution
  solid_solution(const Topology                     &topology,
                 const State                        &state,
                 const InternalForce                &internal_force,
                 const std::vector<Vector3<double>> &velocity,
                 const Fragments                    &fragments);

  /**
   * The cohesive elements that have begun to open, each a triangle halfway
   * between its sides: damage, mode (0: opening, 1: sliding), opening, slip,
   * normal and shear traction as means over the Gauss points, times of
   * insertion and of failure (-1: has not failed).
   */
  Solution
  fracture_solution(const State &state, const CohesiveForce &cohesive_force);

  /**
   * Hash of displacements and velocities of all corners of all cells in canonical
   * order, as hexadecimal text: equal if and only if two states are.
   */
  std::string
  state_hash(const Topology &topology, const State &state);
} // namespace rift

#endif
