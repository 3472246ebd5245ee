#ifndef rift_contact_sleeping_pairs_h
#define rift_contact_sleeping_pairs_h

#include <rift/contact/packed_motion.h>

#include <cstring>
#include <vector>

namespace rift
{
  /**
   * Pairs of cells that are apart. A pair sleeps until the cells may have met:
   * until a path, such as that of the fastest node, has grown by half of the gap
   * between them. So most pairs are not looked at in most steps, and nothing
   * depends on when they are.
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

      /** For the caller, who knows when the two may have met in truth. */
      double limit;
    };

    /** Adds a pair.
     * @param wake the path, m, at which it is to wake. */
    void
    add(const Pair &pair, double wake);

    /**
     * Removes the pairs that wake at a path, and returns them.
     *
     * @param next_wake of a pair that may wake: a longer path at which it is to
     *   wake instead, or this one.
     */
    template <typename Function>
    std::vector<Pair>
    wake(double path, const Function &next_wake);

    /** Number of pairs. */
    std::size_t
    size() const
    {
      return pairs.size();
    }

    /** Replaces the positions of cells. */
    void
    renumber(const std::vector<std::uint32_t> &new_positions);

  private:
    /** Whether eight pairs sleep on. */
    bool
    all_sleep(const std::size_t begin, const double path) const
    {
      Simd of_eight;
      std::memcpy(&of_eight, &wakes[begin], sizeof(of_eight));
      return sign_bits(of_eight <= path) == 0;
    }

    std::vector<Pair>   pairs;
    std::vector<double> wakes;
  };

  template <typename Function>
  std::vector<SleepingPairs::Pair>
  SleepingPairs::wake(const double path, const Function &next_wake)
  {
    std::vector<Pair> woken;
    for (std::size_t i = 0; i < wakes.size();)
      if (i + batch_size <= wakes.size() && all_sleep(i, path))
        i += batch_size;
      else if (wakes[i] > path || (wakes[i] = next_wake(pairs[i])) > path)
        ++i;
      else
        {
          woken.push_back(pairs[i]);
          pairs[i] = pairs.back();
          wakes[i] = wakes.back();
          pairs.pop_back();
          wakes.pop_back();
        }
    return woken;
  }
} // namespace rift

#endif
