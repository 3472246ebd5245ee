#ifndef rift_contact_sleeping_pairs_h
#define rift_contact_sleeping_pairs_h

#include <rift/base/memory_use.h>
#include <rift/contact/packed_motion.h>

#include <array>
#include <limits>
#include <vector>

namespace rift
{
  /**
   * Pairs of cells that are apart. A pair sleeps until the cells may have met:
   * until the path, the sum over the steps of how far anything may have moved,
   * has grown by half of the gap between them. So most pairs are not looked at
   * in most steps, and nothing depends on when they are. They wait in slots of
   * some steps each, so that those that sleep on are not even asked.
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
      return n_pairs;
    }

    /** Bytes that they take. */
    std::uint64_t
    bytes() const
    {
      std::uint64_t sum = 0;
      for (const std::vector<Entry> &slot : slots)
        sum += bytes_of(slot);
      return sum;
    }

    /** Replaces the positions of cells. */
    void
    renumber(const std::vector<std::uint32_t> &new_positions);

  private:
    /** A pair and the path at which it wakes. */
    struct Entry
    {
      Pair   pair;
      double wake;
    };

    static constexpr std::size_t n_slots = 64;

    /** Width of the slots, over the last step. */
    static constexpr double steps_per_slot = 1;

    /** The slot of a path, the later the longer; n_slots if it is far. */
    std::size_t
    slot_of(double wake) const;

    /** Divides the paths from here on into slots. To be called when all but the
     * last are empty. */
    void
    start_anew(double path);

    /** Of the paths origin + i width to origin + (i + 1) width; the last one of
     * all beyond. Those before next_slot are empty. */
    std::array<std::vector<Entry>, n_slots + 1> slots;

    double origin = 0, width = std::numeric_limits<double>::min(),
           last_path      = 0;
    std::size_t next_slot = n_slots, n_pairs = 0;
  };
} // namespace rift

#endif
