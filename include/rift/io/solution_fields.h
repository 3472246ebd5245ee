#ifndef rift_io_solution_fields_h
#define rift_io_solution_fields_h

#include <rift/base/communicator.h>
#include <rift/cohesive/cohesive_force.h>
#include <rift/discretization/state.h>
#include <rift/io/vtu_output.h>
#include <rift/solid/internal_force.h>

#include <string>
#include <vector>

namespace rift
{
  /**
   * The cells that this rank owns, at their place in the undeformed body:
   * displacement and velocity of their nodes, Cauchy stress, material and
   * fragment.
   *
   * @param fragments number for each cell slot; see number_fragments().
   */
  Solution
  solid_solution(const Topology                     &topology,
                 const State                        &state,
                 const InternalForce                &internal_force,
                 const std::vector<Vector3<double>> &velocity,
                 const std::vector<std::uint32_t>   &fragments);

  /**
   * The cohesive elements of this rank that have begun to open, each a triangle
   * at its place in the undeformed body: displacement halfway between its
   * sides, damage, mode (0: opening, 1: sliding), opening, slip, normal and
   * shear traction as means over the Gauss points, times of insertion and of
   * failure (-1: has not failed).
   */
  Solution
  fracture_solution(const Topology      &topology,
                    const State         &state,
                    const CohesiveForce &cohesive_force);

  /**
   * Hash of displacements and velocities of all corners of all cells, as
   * hexadecimal text: equal if and only if two states are, on any number of
   * ranks. Collective.
   */
  std::string
  state_hash(const Topology     &topology,
             const State        &state,
             const Communicator &communicator = {});
} // namespace rift

#endif
