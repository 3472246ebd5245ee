#ifndef rift_io_fragments_h
#define rift_io_fragments_h

#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>

#include <string>
#include <vector>

namespace rift
{
  /** A piece of the body: cells that hang together by unbroken faces. */
  struct Fragment
  {
    std::size_t n_cells = 0;

    /** Volume when undeformed, m^3, and mass, kg. */
    double volume = 0, mass = 0;

    /** Centre of mass now, m, and its velocity, m/s. */
    Vector3<double> centre = {{0, 0, 0}}, velocity = {{0, 0, 0}};
  };

  struct Fragments
  {
    /** By mass, the largest first; equal ones by their first cell. */
    std::vector<Fragment> list;

    /** For each cell slot the position of its fragment in the list. */
    std::vector<std::uint32_t> of_cell;
  };

  /**
   * Finds the pieces. Faces whose cohesive element has not failed still hold
   * two cells together.
   *
   * @param velocity of each node at the time of `state`, m/s.
   */
  Fragments
  find_fragments(const Topology                     &topology,
                 const ReferenceCellData            &reference,
                 const std::vector<double>          &densities,
                 const State                        &state,
                 const std::vector<Vector3<double>> &velocity);

  /** Writes fragments.csv. */
  void
  write_fragments(const std::string &path, const Fragments &fragments);
} // namespace rift

#endif
