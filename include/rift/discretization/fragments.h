#ifndef rift_discretization_fragments_h
#define rift_discretization_fragments_h

#include <rift/base/communicator.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>

#include <vector>

namespace rift
{
  /**
   * A piece of the body: cells that hang together by unbroken faces. Faces
   * whose cohesive element has not failed still hold two cells together.
   */
  struct Fragment
  {
    /** Number of cells. */
    std::uint64_t n_cells = 0;

    /** Volume when undeformed, m^3, and mass, kg. */
    double volume = 0, mass = 0;

    /** Centre of mass now, its displacement, m, and its velocity, m/s. */
    Vector3<double> centre       = {{0, 0, 0}};
    Vector3<double> displacement = {{0, 0, 0}};
    Vector3<double> velocity     = {{0, 0, 0}};

    /** Position in the list of the largest piece of the same body: cells that
     * hung together at the start. */
    std::uint32_t main_piece = 0;
  };

  /** The pieces of the whole body, the same on all ranks. */
  struct Fragments
  {
    /** By mass, the largest first; equal ones by their first cell. */
    std::vector<Fragment> list;

    /** For each cell slot the position of its piece in the list; invalid_index
     * for padding. */
    std::vector<std::uint32_t> of_cell;

    /** Whether a piece has come off its body and left its place: its centre has
     * moved, compared with that of the largest piece, by more than the edge of
     * a cube of its volume. If the largest piece spins, that may be true of
     * pieces that only spin with it. */
    bool
    has_left(std::uint32_t fragment) const;
  };

  /**
   * Finds the pieces. Sums are exact: they do not depend on how the body is
   * divided among the ranks. Collective.
   *
   * @param densities kg/m^3 of each material.
   * @param bodies labels of all cells by label_bodies().
   * @param velocity of each node at the time of `state`, m/s.
   */
  Fragments
  find_fragments(const Topology                     &topology,
                 const ReferenceCellData            &reference,
                 const std::vector<double>          &densities,
                 const std::vector<GlobalCellIndex> &bodies,
                 const State                        &state,
                 const std::vector<Vector3<double>> &velocity,
                 const Communicator                 &communicator);
} // namespace rift

#endif
