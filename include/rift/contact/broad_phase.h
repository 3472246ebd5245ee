#ifndef rift_contact_broad_phase_h
#define rift_contact_broad_phase_h

#include <rift/base/vector3.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace rift
{
  /** A box along the axes, m. */
  struct Box
  {
    /** The corners with the smallest and the largest coordinates. */
    Vector3<double> lower, upper;
  };

  /** Whether two boxes have a point in common. */
  inline bool
  boxes_overlap(const Box &a, const Box &b)
  {
    bool result = true;
    for (unsigned int d = 0; d < 3; ++d)
      result &= a.lower[d] <= b.upper[d] && b.lower[d] <= a.upper[d];
    return result;
  }

  /** Numbers of two boxes, the smaller first. */
  struct BoxPair
  {
    /** Positions in the list of boxes. */
    std::uint32_t first, second;
  };

  /** By the first number, then by the second. */
  inline bool
  operator<(const BoxPair &a, const BoxPair &b)
  {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }

  /** Whether both numbers are equal. */
  inline bool
  operator==(const BoxPair &a, const BoxPair &b)
  {
    return a.first == b.first && a.second == b.second;
  }

  /** Whether a pair of boxes that touch is wanted. */
  using PairFilter = std::function<bool(const BoxPair &)>;

  /**
   * All pairs of boxes that touch and are wanted, in ascending order. The time
   * is linear, but for sorting, in the number of boxes and of pairs that touch,
   * also where large and small ones lie side by side: boxes are put into grids,
   * one for each power of two of their size, and looked for in the 27 cells
   * around in the grid of their own size and in those of larger ones (the
   * hierarchical form of the search of Munjiza, The Combined Finite-Discrete
   * Element Method, chapter 3). Cells in which there is nothing take no memory.
   *
   * @param boxes with finite bounds.
   * @param largest_number of pairs that touch.
   * @return nothing if there are more: the search stops then, so that time
   *   and memory stay bounded.
   */
  std::optional<std::vector<BoxPair>>
  find_touching(const std::vector<Box> &boxes,
                std::size_t             largest_number,
                const PairFilter       &filter);

  /**
   * Pairs in ascending order, in linear time where each box is in few of them.
   */
  std::vector<BoxPair>
  sort_pairs(const std::vector<BoxPair> &pairs, std::size_t n_boxes);
} // namespace rift

#endif
