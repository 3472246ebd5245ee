#ifndef rift_io_fragments_h
#define rift_io_fragments_h

#include <rift/base/communicator.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>

#include <string>
#include <vector>

namespace rift
{
  /**
   * A piece of the body: cells that hang together by unbroken faces. Faces
   * whose cohesive element has not failed still hold two cells together.
   */
  struct Fragment
  {
    /** Number of its cells. */
    std::size_t n_cells = 0;

    /** Volume when undeformed, m^3, and mass, kg. */
    double volume = 0, mass = 0;

    /** Centre of mass now, m, and its velocity, m/s. */
    Vector3<double> centre = {{0, 0, 0}}, velocity = {{0, 0, 0}};
  };

  // Both functions sum without rounding: their results do not depend on how
  // the body is divided among the ranks.

  /**
   * For each cell slot that this rank owns the position of its fragment in
   * list_fragments(); invalid_index for others. Collective.
   *
   * @param densities kg/m^3 of each material.
   */
  std::vector<std::uint32_t>
  number_fragments(const Topology            &topology,
                   const ReferenceCellData   &reference,
                   const std::vector<double> &densities,
                   const Communicator        &communicator);

  /**
   * All fragments by mass, the largest first; equal ones by their first cell.
   * On rank 0; the others get an empty list. Collective.
   *
   * @param velocity of each node at the time of `state`, m/s.
   */
  std::vector<Fragment>
  list_fragments(const Topology                     &topology,
                 const ReferenceCellData            &reference,
                 const std::vector<double>          &densities,
                 const State                        &state,
                 const std::vector<Vector3<double>> &velocity,
                 const Communicator                 &communicator);

  /** Writes fragments.csv. */
  void
  write_fragments(const std::string           &path,
                  const std::vector<Fragment> &fragments);
} // namespace rift

#endif
