#ifndef rift_contact_sleeping_pairs_h
#define rift_contact_sleeping_pairs_h

#include <rift/contact/packed_motion.h>

#include <vector>

namespace rift
{
  /**
   * Pairs of cells that are apart. A pair sleeps until the cells may have met:
   * until the path, the sum over the steps of how far anything may have moved,
   * has grown by half of the gap between them. So most pairs are not looked at
   * in most steps, and nothing depends on when they are.
   */
  class SleepingPairs
  {
  public:
    /** Adds a pair.
     *
     * @param axis that parts the cells; see find_gaps().
     * @param wake the path, m, at which they may have met. */
    void
    add(const CellPair &cells, std::uint8_t axis, double wake);

    /** A pair that has woken. */
    struct Woken
    {
      /** The cells, and the axis that parted them. */
      CellPair     cells;
      std::uint8_t axis;
    };

    /** Removes the pairs whose cells may have met, and returns them. */
    std::vector<Woken>
    wake(double path);

    /** Number of pairs. */
    std::size_t
    size() const
    {
      return pairs.size();
    }

    /** Removes all pairs. */
    void
    clear();

    /** Replaces the positions of cells. */
    void
    renumber(const std::vector<std::uint32_t> &new_positions);

  private:
    std::vector<CellPair>     pairs;
    std::vector<std::uint8_t> axes;
    std::vector<double>       wakes;
  };
} // namespace rift

#endif
