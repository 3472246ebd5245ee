#ifndef rift_contact_rendezvous_h
#define rift_contact_rendezvous_h

#include <rift/base/communicator.h>
#include <rift/contact/contact_space.h>

#include <functional>
#include <unordered_map>
#include <vector>

namespace rift
{
  /** Pairs of cells, and the cells in them. */
  struct ContactNeighbourhood
  {
    /** Ascending. */
    std::vector<ContactCell> cells;

    /** Positions in `cells`; ascending. */
    std::vector<CellPair> pairs;
  };

  /**
   * Finds pairs of cells on ranks that need know nothing of each other: each
   * cell goes to the ranks that own the space around it, which keep it, look
   * for pairs and tell all ranks that see one of the two. A pair is found by
   * the rank that owns the point at which the common box of the two begins, so
   * that it is found once. A single rank meets itself.
   */
  class Rendezvous
  {
  public:
    /** The ranks that see a cell of this rank, itself included; ascending. */
    using Subscribers = std::function<std::vector<int>(const ContactCell &)>;

    /** The communicator must outlive this object. */
    Rendezvous(const Communicator &communicator, Subscribers subscribers);

    /** Whether space is to be divided anew, so that the next update must be
     * with all cells; the same on all ranks. */
    bool
    needs_all() const
    {
      return !(largest_number < largest_growth * largest_number_at_first);
    }

    /**
     * The pairs of cells of which this rank sees one, that are nearer than
     * their margins and not bonded, and of which a cell is among the news of
     * any rank. Collective.
     *
     * @param news cells of this rank that have not been here yet, or have
     *   changed or moved; ascending.
     * @throws RunError or CollectiveError, on all ranks, if there are too many
     *   on one.
     */
    ContactNeighbourhood
    update(std::vector<ContactCell> news);

    /** Bytes that the cells in the space of this rank take. */
    std::uint64_t
    bytes() const
    {
      return space.bytes();
    }

  private:
    /** Space is divided anew when the rank with most cells has so many times
     * what it had when that was done last. */
    static constexpr double largest_growth = 1.5;

    void
    divide(const std::vector<ContactCell> &own);

    /** Sends cells to the ranks whose space they are in, or have been in. */
    std::vector<ContactSpace::RemoteCell>
    send_to_space_owners(std::vector<ContactCell> news);

    /** Tells all ranks of the pairs that concern them. */
    ContactNeighbourhood
    return_pairs(const std::vector<CellPair> &pairs) const;

    const Communicator &communicator;
    const Subscribers   subscribers;

    SpaceDivision division;
    ContactSpace  space;

    /** The ranks that have each cell of this rank, where there are several. */
    std::unordered_map<GlobalCellIndex, std::vector<int>> places;

    /** The largest number of cells on a rank after the first update with this
     * division, and now. */
    double largest_number_at_first = 0, largest_number = 0;
  };
} // namespace rift

#endif
