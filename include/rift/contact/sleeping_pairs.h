#ifndef rift_contact_sleeping_pairs_h
#define rift_contact_sleeping_pairs_h

#include <rift/base/memory_use.h>
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
    /** A pair that is apart. */
    struct Pair
    {
      /** The cells, and the axis that parts them; see find_gaps(). */
      CellPair     cells;
      std::uint8_t axis;
    };

    /** Adds a pair.
     * @param wake the path, m, at which the cells may have met. */
    void
    add(const Pair &pair, double wake);

    /** Removes the pairs whose cells may have met, and returns them. */
    std::vector<Pair>
    wake(double path);

    /** Number of pairs. */
    std::size_t
    size() const
    {
      return pairs.size();
    }

    /** Bytes that they take. */
    std::uint64_t
    bytes() const
    {
      return bytes_of(pairs) + bytes_of(wakes);
    }

    /** Replaces the positions of cells. */
    void
    renumber(const std::vector<std::uint32_t> &new_positions);

  private:
    std::vector<Pair>   pairs;
    std::vector<double> wakes;
  };
} // namespace rift

#endif
