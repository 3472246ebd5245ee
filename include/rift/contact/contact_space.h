#ifndef rift_contact_contact_space_h
#define rift_contact_contact_space_h

#include <rift/contact/box_index.h>
#include <rift/contact/contact_cell.h>
#include <rift/contact/packed_motion.h>
#include <rift/contact/space_division.h>

#include <unordered_map>
#include <vector>

namespace rift
{
  /**
   * The cells in the space of this rank that may touch others, and the search
   * for pairs among them.
   */
  class ContactSpace
  {
  public:
    /** A cell of any rank as its owner has told of it, and the ranks that see
     * it. */
    struct RemoteCell : ContactCell
    {
      /** Ascending. */
      std::vector<int> subscribers;
    };

    /** Removes all cells. */
    void
    clear();

    /**
     * Takes in cells that are new or of which there is news, and finds their
     * partners.
     *
     * @param news may hold cells that have left: they are forgotten.
     * @param division of space.
     * @param rank that owns the points at which the common boxes of the pairs
     *   begin: so that each pair is found on one rank.
     * @return pairs that are not bonded and nearer to each other than their
     *   margins, of which one or both cells are among the news, as numbers of
     *   cells, the one of smaller name first, in no particular order. Until a
     *   cell has moved by its margin or is among the news again, no others
     *   touch.
     * @throws RunError if there are so many pairs that cells must lie in heaps.
     */
    std::vector<CellPair>
    update(std::vector<RemoteCell> news,
           const SpaceDivision    &division,
           int                     rank);

    /** A cell that update() has found a partner for. */
    const RemoteCell &
    cell(const std::uint32_t number) const
    {
      return cells[number];
    }

    /** Number of cells that are here: without those that have left. */
    std::size_t
    size() const
    {
      return boxes.size();
    }

    /** Bytes that it takes. */
    std::uint64_t
    bytes() const;

  private:
    /** The number of a cell, which is put in or replaced. */
    std::uint32_t
    take_in(RemoteCell cell);

    /** Whether two cells are near each other and not bonded. */
    bool
    may_touch(std::uint32_t a, std::uint32_t b) const;

    /** Those that have left keep their number, but have no box. */
    std::vector<RemoteCell>                            cells;
    std::unordered_map<GlobalCellIndex, std::uint32_t> number_by_name;
    BoxIndex                                           boxes;

    /** The number of updates, and that of the last news of each cell. */
    std::uint64_t              n_updates = 0;
    std::vector<std::uint64_t> last_news;
  };

  /** A cell and all that is nearer to it than its margin, m. */
  Box
  box_around(const ContactCell &cell);
} // namespace rift

#endif
