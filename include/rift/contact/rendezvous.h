#ifndef rift_contact_rendezvous_h
#define rift_contact_rendezvous_h

#include <rift/base/communicator.h>
#include <rift/contact/contact_search.h>

#include <functional>
#include <vector>

namespace rift
{
  /** Pairs of cells, and the cells in them. */
  struct ContactNeighbourhood
  {
    /** Ascending. */
    std::vector<ContactCell> cells;

    /** Positions in `cells`; ascending. */
    std::vector<BoxPair> pairs;
  };

  /**
   * Finds pairs of cells on ranks that need know nothing of each other: each
   * cell goes to the ranks that own the space around it, which look for pairs
   * among those that have come and tell all ranks that see one of the two. A
   * pair is found by the rank that owns the point at which the common box of
   * the two begins, so that it is found once. A single rank meets itself.
   */
  class Rendezvous
  {
  public:
    /** The ranks that see a cell of this rank, itself included; ascending. */
    using Subscribers = std::function<std::vector<int>(const ContactCell &)>;

    /** The communicator must outlive this object. */
    Rendezvous(const Communicator &communicator, Subscribers subscribers);

    /**
     * All pairs of cells of which this rank sees one, nearer than the skin and
     * not bonded. Collective.
     *
     * @param own cells of this rank, ascending.
     * @param skin m; on all ranks the same.
     * @throws RunError or CollectiveError, on all ranks, if there are too many
     *   on one.
     */
    ContactNeighbourhood
    search(std::vector<ContactCell> own, double skin);

    /** Global indices of two cells, the smaller first. */
    using NamedPair = std::pair<GlobalCellIndex, GlobalCellIndex>;

    /**
     * Brings together the cells of pairs that are known. Collective.
     *
     * @param own cells of this rank, ascending.
     * @param pairs of all ranks, ascending.
     */
    ContactNeighbourhood
    join(const std::vector<ContactCell> &own,
         const std::vector<NamedPair>   &pairs) const;

  private:
    /** Cells of which a rank is told, and who sees them. */
    struct ReceivedCells
    {
      std::vector<ContactCell>      cells;
      std::vector<std::vector<int>> subscribers;
    };

    using Destinations = std::function<std::vector<int>(const ContactCell &)>;

    void
    divide(const std::vector<ContactCell> &own);

    ReceivedCells
    send_to_space_owners(const std::vector<ContactCell> &own,
                         const Destinations             &destinations) const;

    /** Tells all ranks of the pairs that concern them. */
    ContactNeighbourhood
    return_pairs(const ReceivedCells        &received,
                 const std::vector<BoxPair> &pairs) const;

    const Communicator &communicator;
    const Subscribers   subscribers;

    SpaceDivision division;

    /** The largest number of received cells in the first search with this
     * division, and in the last one. */
    double largest_number_at_first = 0, largest_number = 0;
  };
} // namespace rift

#endif
