#ifndef rift_contact_contact_search_h
#define rift_contact_contact_search_h

#include <rift/base/communicator.h>
#include <rift/contact/contact_cell.h>

#include <vector>

namespace rift
{
  /** Two cells that may touch, as positions in a list of cells. */
  struct ContactCandidate
  {
    std::uint32_t a, b;
  };

  /**
   * Pairs of cells that are nearer to each other than the skin and not bonded,
   * in ascending order: until some corner has moved by half of the skin, no
   * other pair touches.
   *
   * @param cells in ascending order.
   * @param skin m.
   * @throws RunError if there are so many pairs that cells must lie in heaps.
   */
  std::vector<ContactCandidate>
  find_candidates(const std::vector<ContactCell> &cells, double skin);

  /** The cells of all ranks, ascending, on all ranks. Collective. */
  std::vector<ContactCell>
  gather_cells(const std::vector<ContactCell> &own,
               const Communicator             &communicator);
} // namespace rift

#endif
