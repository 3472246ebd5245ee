#ifndef rift_contact_box_index_h
#define rift_contact_box_index_h

#include <rift/base/vector3.h>

#include <array>
#include <cstdint>
#include <unordered_map>
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

  /**
   * Boxes that can be put in, moved and asked for by place. They are in grids,
   * one for each power of two of their size, each in the cell in which its
   * centre lies, so that the time to find those at a place does not depend on
   * their number (the hierarchical form of the search of Munjiza, The Combined
   * Finite-Discrete Element Method, chapter 3). Cells lie in blocks of
   * 4 x 4 x 4; where there is nothing, there is no block.
   */
  class BoxIndex
  {
  public:
    /** Removes all boxes. */
    void
    clear();

    /** Puts a box in, or moves it.
     * @param box with finite bounds.
     * @param number of it: at most one more than the largest so far. */
    void
    put(std::uint32_t number, const Box &box);

    /** Takes a box out, if it is there. */
    void
    remove(std::uint32_t number);

    /** A box that has been put in. */
    const Box &
    box(const std::uint32_t number) const
    {
      return entries[number].box;
    }

    /** Number of boxes that are in. */
    std::size_t
    size() const
    {
      return n_boxes;
    }

    /** Bytes that it takes. */
    std::uint64_t
    bytes() const;

    /** The exponent of the power of two that it is sorted by. */
    int
    level(const std::uint32_t number) const
    {
      return entries[number].level;
    }

    /** Appends the numbers of all boxes that touch this one.
     * @param least_level smaller boxes are passed over. */
    void
    find(const Box                  &box,
         int                         least_level,
         std::vector<std::uint32_t> &numbers) const;

  private:
    using GridPoint = std::array<std::int64_t, 3>;

    struct Entry
    {
      Box           box;
      int           level;
      std::uint32_t next;
    };

    /** The first box in each of its cells. */
    struct Block
    {
      std::array<std::uint32_t, 64> first;
      std::uint32_t                 n_boxes;
    };

    /** The blocks of a level that hold boxes, by key, and where there is room
     * for others. */
    struct Grid
    {
      int                                              level;
      std::unordered_map<std::uint64_t, std::uint32_t> block_at;
      std::vector<Block>                               blocks;
      std::vector<std::uint32_t>                       free_blocks;
    };

    Grid &
    grid_of(int level);

    /** Appends the numbers of those boxes of a list that touch a box. */
    void
    add_touching(std::uint32_t               first,
                 const Box                  &box,
                 std::vector<std::uint32_t> &numbers) const;

    /** Likewise those of a grid. */
    void
    find_in(const Grid                 &grid,
            const Box                  &box,
            std::vector<std::uint32_t> &numbers) const;

    std::vector<Entry> entries;
    std::vector<Grid>  grids;
    std::size_t        n_boxes = 0;
  };
} // namespace rift

#endif
