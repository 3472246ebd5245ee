#ifndef rift_contact_contact_search_h
#define rift_contact_contact_search_h

#include <rift/contact/contact_cell.h>
#include <rift/contact/space_division.h>

#include <vector>

namespace rift
{
  /** A tetrahedron and all that is nearer to it than the margin, m. */
  Box
  box_around(const Tetrahedron &t, double margin);

  /**
   * Pairs of cells that are nearer to each other than the skin and not bonded,
   * as positions in the list, in ascending order: until some corner has moved
   * by half of the skin, no other pair touches.
   *
   * @param cells in ascending order.
   * @param skin m.
   * @param division of space.
   * @param rank that owns the points at which the common boxes of the pairs
   *   begin.
   * @throws RunError if there are so many pairs that cells must lie in heaps.
   */
  std::vector<BoxPair>
  find_candidates(const std::vector<ContactCell> &cells,
                  double                          skin,
                  const SpaceDivision            &division,
                  int                             rank);
} // namespace rift

#endif
