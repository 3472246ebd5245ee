#include <rift/contact/broad_phase.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rift
{
  namespace
  {
    using GridPoint = std::array<std::int64_t, 3>;

    constexpr std::uint32_t nobody = -1;

    /** The largest of the three lengths of a box. */
    double
    size_of(const Box &box)
    {
      const Vector3<double> lengths = box.upper - box.lower;
      return *std::max_element(lengths.begin(), lengths.end());
    }

    /** The exponent of the least power of two that is larger than a size. */
    int
    level_of(const double size)
    {
      int exponent;
      std::frexp(size, &exponent);
      return exponent;
    }

    /**
     * Boxes of about the same size, each in the cell in which its centre lies.
     * No box is larger than a cell.
     */
    class Grid
    {
    public:
      Grid(const int level, const std::vector<std::uint32_t> &members)
        : level(level)
        , cell_size(std::ldexp(1., level))
        , members(members)
        , next(members.size(), nobody)
      {
        std::size_t n_slots = 1;
        while (n_slots < 2 * members.size())
          n_slots *= 2;
        slots.resize(n_slots);
      }

      GridPoint
      cell_of(const Box &box) const
      {
        GridPoint cell;
        for (unsigned int d = 0; d < 3; ++d)
          cell[d] = static_cast<std::int64_t>(
            std::floor((.5 * box.lower[d] + .5 * box.upper[d]) / cell_size));
        return cell;
      }

      /** Puts member number i into a cell, before all others there. */
      void
      insert(const GridPoint &cell, const std::uint32_t i)
      {
        Slot &slot = find(cell);
        slot.cell  = cell;
        next[i]    = slot.first;
        slot.first = i;
      }

      /** Calls f with each box in a cell. */
      template <typename Function>
      void
      for_each_in(const GridPoint &cell, const Function &f)
      {
        for (std::uint32_t i = find(cell).first; i != nobody; i = next[i])
          f(members[i]);
      }

      const int    level;
      const double cell_size;

      /** Numbers of the boxes. */
      const std::vector<std::uint32_t> members;

    private:
      /** A cell with boxes, and the first of them. */
      struct Slot
      {
        GridPoint     cell{};
        std::uint32_t first = nobody;
      };

      /** The slot of a cell, or the empty one where it would be. */
      Slot &
      find(const GridPoint &cell)
      {
        std::uint64_t hash = 0;
        for (const std::int64_t c : cell)
          {
            hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15u;
            hash ^= hash >> 32;
          }
        std::size_t i = hash & (slots.size() - 1);
        while (slots[i].first != nobody && slots[i].cell != cell)
          i = (i + 1) & (slots.size() - 1);
        return slots[i];
      }

      std::vector<Slot>          slots;
      std::vector<std::uint32_t> next;
    };

    /** The boxes by size, those of the smallest first. */
    std::vector<Grid>
    make_grids(const std::vector<Box> &boxes)
    {
      std::vector<std::pair<int, std::uint32_t>> order(boxes.size());
      for (std::uint32_t i = 0; i < boxes.size(); ++i)
        order[i] = {level_of(size_of(boxes[i])), i};
      // Levels are few: a stable sort by them alone is cheap.
      std::stable_sort(
        order.begin(),
        order.end(),
        [](const auto &a, const auto &b) { return a.first < b.first; });
      std::vector<Grid> grids;
      for (auto first = order.begin(); first != order.end();)
        {
          std::vector<std::uint32_t> members;
          auto                       last = first;
          for (; last != order.end() && last->first == first->first; ++last)
            members.push_back(last->second);
          grids.emplace_back(first->first, members);
          first = last;
        }
      return grids;
    }

    template <typename Function>
    void
    for_each_neighbour(const GridPoint &cell, const Function &f)
    {
      for (std::int64_t x = -1; x <= 1; ++x)
        for (std::int64_t y = -1; y <= 1; ++y)
          for (std::int64_t z = -1; z <= 1; ++z)
            f(GridPoint{{cell[0] + x, cell[1] + y, cell[2] + z}});
    }

    /** Sorts in linear time: first by the first boxes, of which each has few
     * partners. */
    std::vector<BoxPair>
    sorted(const std::vector<BoxPair> &pairs, const std::size_t n_boxes)
    {
      std::vector<std::size_t> begin(n_boxes + 1);
      for (const BoxPair &pair : pairs)
        ++begin[pair.first + 1];
      std::partial_sum(begin.begin(), begin.end(), begin.begin());
      std::vector<std::size_t> end(begin);
      std::vector<BoxPair>     result(pairs.size());
      for (const BoxPair &pair : pairs)
        result[end[pair.first]++] = pair;
      for (std::size_t i = 0; i < n_boxes; ++i)
        std::sort(result.begin() + begin[i], result.begin() + end[i]);
      return result;
    }
  } // namespace

  std::vector<BoxPair>
  find_touching(const std::vector<Box> &boxes, const std::size_t largest_number)
  {
    std::vector<BoxPair> pairs;
    std::vector<Grid>    grids = make_grids(boxes);
    for (auto grid = grids.rbegin(); grid != grids.rend(); ++grid)
      for (std::uint32_t i = 0; i < grid->members.size(); ++i)
        {
          const std::uint32_t box = grid->members[i];
          // Boxes of the same size meet the ones that are in already.
          for (auto other = grids.rbegin(); other <= grid; ++other)
            for_each_neighbour(
              other->cell_of(boxes[box]),
              [&](const GridPoint &cell) {
                other->for_each_in(cell, [&](const std::uint32_t partner) {
                  if (touch(boxes[box], boxes[partner]))
                    pairs.push_back(
                      {std::min(box, partner), std::max(box, partner)});
                });
              });
          if (pairs.size() > largest_number)
            return pairs;
          grid->insert(grid->cell_of(boxes[box]), i);
        }
    return sorted(pairs, boxes.size());
  }
} // namespace rift
