#include <rift/base/check.h>
#include <rift/base/memory_use.h>
#include <rift/base/types.h>
#include <rift/contact/box_index.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    /** Of an entry that holds no box. */
    constexpr int no_level = -10000;

    /** Of the cell in which x lies; what is very far away has the last one. */
    std::int64_t
    coordinate(const double x, const double cell_size)
    {
      constexpr double last = 1e15;
      return static_cast<std::int64_t>(
        std::floor(std::clamp(x / cell_size, -last, last)));
    }

    /** The exponent of the least power of two that is larger than a box. */
    int
    level_of(const Box &box)
    {
      const Vector3<double> lengths = box.upper - box.lower;
      int                   level;
      std::frexp(std::max({lengths[0], lengths[1], lengths[2]}), &level);
      return level;
    }

    std::array<std::int64_t, 3>
    centre_cell(const Box &box, const int level)
    {
      std::array<std::int64_t, 3> point;
      for (unsigned int d = 0; d < 3; ++d)
        point[d] = coordinate(.5 * box.lower[d] + .5 * box.upper[d],
                              std::ldexp(1., level));
      return point;
    }

    /** Of the block of a grid point. Points far from each other may share one:
     * their boxes do not touch. */
    std::uint64_t
    key_of(const std::array<std::int64_t, 3> &point)
    {
      std::uint64_t key = 0;
      for (const std::int64_t x : point)
        key = key << 21 | (static_cast<std::uint64_t>(x >> 2) & 0x1fffff);
      // The library takes keys as they are: neighbours must not share places.
      return key * 0x9e3779b97f4a7c15u;
    }

    unsigned int
    place_in_block(const std::array<std::int64_t, 3> &point)
    {
      return static_cast<unsigned int>((point[0] & 3) << 4 |
                                       (point[1] & 3) << 2 | (point[2] & 3));
    }
  } // namespace

  void
  BoxIndex::clear()
  {
    entries.clear();
    grids.clear();
    n_boxes = 0;
  }

  std::uint64_t
  BoxIndex::bytes() const
  {
    std::uint64_t sum = bytes_of(entries) + bytes_of(grids);
    for (const Grid &grid : grids)
      sum += bytes_of(grid.block_at) + bytes_of(grid.blocks) +
             bytes_of(grid.free_blocks);
    return sum;
  }

  BoxIndex::Grid &
  BoxIndex::grid_of(const int level)
  {
    for (Grid &grid : grids)
      if (grid.level == level)
        return grid;
    return grids.emplace_back(Grid{level, {}, {}, {}});
  }

  void
  BoxIndex::put(const std::uint32_t number, const Box &box)
  {
    rift_check(number <= entries.size());
    if (number == entries.size())
      entries.push_back({box, no_level, invalid_index});
    remove(number);

    const int       level = level_of(box);
    Grid           &grid  = grid_of(level);
    const GridPoint point = centre_cell(box, level);
    const auto [place, is_new] =
      grid.block_at.try_emplace(key_of(point), std::uint32_t(0));
    if (is_new && grid.free_blocks.empty())
      {
        place->second = static_cast<std::uint32_t>(grid.blocks.size());
        grid.blocks.emplace_back();
      }
    else if (is_new)
      {
        place->second = grid.free_blocks.back();
        grid.free_blocks.pop_back();
      }
    Block &block = grid.blocks[place->second];
    if (is_new)
      {
        block.first.fill(invalid_index);
        block.n_boxes = 0;
      }
    ++n_boxes;
    ++block.n_boxes;
    std::uint32_t &first = block.first[place_in_block(point)];
    entries[number]      = {box, level, first};
    first                = number;
  }

  void
  BoxIndex::remove(const std::uint32_t number)
  {
    Entry &entry = entries[number];
    if (entry.level == no_level)
      return;
    Grid           &grid  = grid_of(entry.level);
    const GridPoint point = centre_cell(entry.box, entry.level);
    const auto      place = grid.block_at.find(key_of(point));
    rift_check(place != grid.block_at.end());
    Block         &block = grid.blocks[place->second];
    std::uint32_t *link  = &block.first[place_in_block(point)];
    while (*link != number)
      link = &entries[*link].next;
    *link       = entry.next;
    entry.level = no_level;
    --n_boxes;
    if (--block.n_boxes == 0)
      {
        grid.free_blocks.push_back(place->second);
        grid.block_at.erase(place);
      }
  }

  void
  BoxIndex::find(const Box                  &box,
                 const int                   least_level,
                 std::vector<std::uint32_t> &numbers) const
  {
    for (const Grid &grid : grids)
      if (grid.level >= least_level)
        find_in(grid, box, numbers);
  }

  void
  BoxIndex::add_touching(const std::uint32_t         first,
                         const Box                  &box,
                         std::vector<std::uint32_t> &numbers) const
  {
    for (std::uint32_t i = first; i != invalid_index; i = entries[i].next)
      if (boxes_overlap(entries[i].box, box))
        numbers.push_back(i);
  }

  void
  BoxIndex::find_in(const Grid                 &grid,
                    const Box                  &box,
                    std::vector<std::uint32_t> &numbers) const
  {
    // No box of this grid is larger than a cell.
    const double size = std::ldexp(1., grid.level);
    GridPoint    low, high, point;
    double       n_cells = 1;
    for (unsigned int d = 0; d < 3; ++d)
      {
        low[d]  = coordinate(box.lower[d] - size / 2, size);
        high[d] = coordinate(box.upper[d] + size / 2, size);
        n_cells *= static_cast<double>(high[d] - low[d] + 1);
      }
    // A large box among few small ones
    if (n_cells > 64. * static_cast<double>(grid.block_at.size()))
      {
        for (const auto &[key, block] : grid.block_at)
          for (const std::uint32_t first : grid.blocks[block].first)
            add_touching(first, box, numbers);
        return;
      }
    std::uint64_t last_key = 0;
    auto          block    = grid.block_at.find(last_key);
    for (point[0] = low[0]; point[0] <= high[0]; ++point[0])
      for (point[1] = low[1]; point[1] <= high[1]; ++point[1])
        for (point[2] = low[2]; point[2] <= high[2]; ++point[2])
          {
            if (const std::uint64_t key = key_of(point); key != last_key)
              {
                last_key = key;
                block    = grid.block_at.find(key);
              }
            if (block != grid.block_at.end())
              add_touching(
                grid.blocks[block->second].first[place_in_block(point)],
                box,
                numbers);
          }
  }
} // namespace rift
