#include <rift/base/check.h>
#include <rift/contact/broad_phase.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace rift
{
  namespace
  {
    using GridPoint = std::array<std::int64_t, 3>;

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

    struct NumberedBox
    {
      Box           box;
      std::uint32_t number;
    };

    /**
     * Boxes of about the same size, each in the cell in which its centre lies.
     * No box is larger than a cell. Cells that have boxes, and the boxes, stand
     * in the order of the columns (x, y) and of z: those of a cell and of the
     * two above and below it lie side by side in memory.
     */
    class Grid
    {
    public:
      struct Cell
      {
        GridPoint     point;
        std::uint32_t begin, end;
      };

      Grid(const int                         level,
           const std::vector<Box>           &all,
           const std::vector<std::uint32_t> &members)
        : cell_size(std::ldexp(1., level))
      {
        std::vector<std::pair<GridPoint, std::uint32_t>> order;
        order.reserve(members.size());
        for (const std::uint32_t member : members)
          order.emplace_back(point_of(all[member]), member);
        std::sort(order.begin(), order.end());
        boxes.reserve(members.size());
        for (const auto &[point, member] : order)
          {
            const auto i = static_cast<std::uint32_t>(boxes.size());
            if (cells.empty() || cells.back().point != point)
              cells.push_back({point, i, i});
            cells.back().end = i + 1;
            boxes.push_back({all[member], member});
          }
      }

      GridPoint
      point_of(const Box &box) const
      {
        GridPoint point;
        for (unsigned int d = 0; d < 3; ++d)
          point[d] = static_cast<std::int64_t>(
            std::floor((.5 * box.lower[d] + .5 * box.upper[d]) / cell_size));
        return point;
      }

      /** Calls f with the range of boxes between two cells of a column. */
      template <typename Function>
      void
      for_range(const GridPoint &first,
                const GridPoint &last,
                const Function  &f) const
      {
        auto cell = std::lower_bound(
          cells.begin(),
          cells.end(),
          first,
          [](const Cell &a, const GridPoint &b) { return a.point < b; });
        const auto begin = cell;
        while (cell != cells.end() && cell->point <= last)
          ++cell;
        if (cell != begin)
          f(boxes.data() + begin->begin, boxes.data() + (cell - 1)->end);
      }

      double                   cell_size;
      std::vector<Cell>        cells;
      std::vector<NumberedBox> boxes;
    };

    /** The boxes by size, those of the smallest first. */
    std::vector<Grid>
    make_grids(const std::vector<Box> &boxes)
    {
      std::map<int, std::vector<std::uint32_t>> members;
      for (std::uint32_t i = 0; i < boxes.size(); ++i)
        members[level_of(size_of(boxes[i]))].push_back(i);
      std::vector<Grid> grids;
      for (const auto &[level, of_level] : members)
        grids.emplace_back(level, boxes, of_level);
      return grids;
    }

    /** The columns around that of a cell: all, or those that come after it. */
    template <typename Function>
    void
    for_each_column(const GridPoint &c, const bool all, const Function &f)
    {
      for (std::int64_t x = -1; x <= 1; ++x)
        for (std::int64_t y = -1; y <= 1; ++y)
          if (all || x > 0 || (x == 0 && y > 0))
            f(GridPoint{{c[0] + x, c[1] + y, c[2] - 1}},
              GridPoint{{c[0] + x, c[1] + y, c[2] + 1}});
    }

    /** Collects pairs of boxes that touch, until there are too many. */
    class Collector
    {
    public:
      Collector(const std::size_t largest_number, const PairFilter &filter)
        : largest_number(largest_number)
        , filter(filter)
      {
      }

      bool
      is_full() const
      {
        return n_touching > largest_number;
      }

      void
      look_at(const NumberedBox &a,
              const NumberedBox *first,
              const NumberedBox *last)
      {
        if (is_full())
          return;
        for (const NumberedBox *b = first; b != last; ++b)
          if (boxes_overlap(a.box, b->box))
            {
              ++n_touching;
              const BoxPair pair{std::min(a.number, b->number),
                                 std::max(a.number, b->number)};
              if (filter(pair))
                pairs.push_back(pair);
            }
      }

      std::vector<BoxPair> pairs;

    private:
      const std::size_t largest_number;
      const PairFilter &filter;
      std::size_t       n_touching = 0;
    };

    /** Looks for the partners of the boxes of a cell, those of the same size
     * that come after them. */
    void
    look_around(const Grid       &grid,
                const Grid::Cell &cell,
                const Grid       &other,
                Collector        &collector)
    {
      const NumberedBox *const        first   = grid.boxes.data() + cell.begin,
                               *const last    = grid.boxes.data() + cell.end;
      const bool                      is_same = &grid == &other;
      const auto look = [&](const NumberedBox *begin, const NumberedBox *end) {
        for (const NumberedBox *a = first; a != last; ++a)
          collector.look_at(*a, begin, end);
      };
      // All boxes of the cell have the same one in a coarser grid.
      const GridPoint point = other.point_of(first->box);
      for_each_column(point,
                      !is_same,
                      [&](const GridPoint &bottom, const GridPoint &top) {
                        other.for_range(bottom, top, look);
                      });
      if (!is_same)
        return;
      for (const NumberedBox *a = first; a != last; ++a)
        collector.look_at(*a, a + 1, last);
      const GridPoint above{{point[0], point[1], point[2] + 1}};
      grid.for_range(above, above, look);
    }
  } // namespace

  std::optional<std::vector<BoxPair>>
  find_touching(const std::vector<Box> &boxes,
                const std::size_t       largest_number,
                const PairFilter       &filter)
  {
    Collector               collector(largest_number, filter);
    const std::vector<Grid> grids = make_grids(boxes);
    for (auto grid = grids.begin(); grid != grids.end(); ++grid)
      for (const Grid::Cell &cell : grid->cells)
        for (auto other = grid; other != grids.end(); ++other)
          {
            look_around(*grid, cell, *other, collector);
            if (collector.is_full())
              return {};
          }
    auto pairs = sort_pairs(collector.pairs, boxes.size());
    rift_check(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
    return pairs;
  }

  std::vector<BoxPair>
  sort_pairs(const std::vector<BoxPair> &pairs, const std::size_t n_boxes)
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
} // namespace rift
