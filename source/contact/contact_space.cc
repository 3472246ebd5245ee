#include <rift/base/check.h>
#include <rift/base/exceptions.h>
#include <rift/base/memory_use.h>
#include <rift/contact/contact_space.h>
#include <rift/contact/separation.h>

#include <algorithm>
#include <limits>

namespace rift
{
  namespace
  {
    /** So many boxes touch another one only when bodies have collapsed. */
    constexpr std::size_t largest_pairs_per_cell = 200;

    Vector3<double>
    lower_corner_of_common_box(const Box &a, const Box &b)
    {
      Vector3<double> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = std::max(a.lower[d], b.lower[d]);
      return corner;
    }
  } // namespace

  Box
  box_around(const ContactCell &cell)
  {
    Box box{cell.positions[0], cell.positions[0]};
    for (const Vector3<double> &x : cell.positions)
      for (unsigned int d = 0; d < dim; ++d)
        {
          box.lower[d] = std::min(box.lower[d], x[d]);
          box.upper[d] = std::max(box.upper[d], x[d]);
        }
    for (unsigned int d = 0; d < dim; ++d)
      {
        box.lower[d] -= cell.margin;
        box.upper[d] += cell.margin;
      }
    return box;
  }

  void
  ContactSpace::clear()
  {
    cells.clear();
    number_by_name.clear();
    boxes.clear();
    last_news.clear();
  }

  std::uint64_t
  ContactSpace::bytes() const
  {
    std::uint64_t sum = bytes_of(cells) + bytes_of(number_by_name) +
                        bytes_of(last_news) + boxes.bytes();
    for (const RemoteCell &cell : cells)
      sum += bytes_of(cell.subscribers);
    return sum;
  }

  std::uint32_t
  ContactSpace::take_in(RemoteCell cell)
  {
    const auto [place, is_new] =
      number_by_name.try_emplace(cell.cell,
                                 static_cast<std::uint32_t>(cells.size()));
    const std::uint32_t number = place->second;
    if (is_new)
      {
        cells.emplace_back();
        last_news.push_back(0);
      }
    boxes.put(number, box_around(cell));
    cells[number]     = std::move(cell);
    last_news[number] = n_updates;
    return number;
  }

  bool
  ContactSpace::may_touch(const std::uint32_t a, const std::uint32_t b) const
  {
    const ContactCell &x = cells[a], &y = cells[b];
    const double       reach = x.margin + y.margin;
    return !are_bonded(x, y) &&
           FacePlanes(x.positions).distance_to(y.positions) <= reach &&
           FacePlanes(y.positions).distance_to(x.positions) <= reach;
  }

  std::vector<CellPair>
  ContactSpace::update(std::vector<RemoteCell> news,
                       const SpaceDivision    &division,
                       const int               rank)
  {
    ++n_updates;
    const bool                 are_all_new = cells.empty();
    std::vector<std::uint32_t> numbers;
    for (RemoteCell &cell : news)
      {
        numbers.push_back(take_in(std::move(cell)));
        const auto ranks = division.ranks_of(boxes.box(numbers.back()));
        if (!std::binary_search(ranks.begin(), ranks.end(), rank))
          {
            boxes.remove(numbers.back());
            numbers.pop_back();
          }
      }

    const std::size_t          limit      = largest_pairs_per_cell * size();
    std::size_t                n_touching = 0;
    std::vector<CellPair>      pairs;
    std::vector<std::uint32_t> found;
    for (const std::uint32_t i : numbers)
      {
        // Of two among the news, the smaller one finds the other.
        const auto is_found_here = [&](const std::uint32_t j) {
          if (last_news[j] != n_updates)
            return true;
          if (are_all_new && boxes.level(i) != boxes.level(j))
            return boxes.level(i) < boxes.level(j);
          return i < j;
        };
        found.clear();
        boxes.find(boxes.box(i),
                   are_all_new ? boxes.level(i) :
                                 std::numeric_limits<int>::min(),
                   found);
        n_touching += found.size();
        if (n_touching > 2 * limit)
          throw RunError(
            "contact: the " + std::to_string(size()) +
            " cells at surfaces have more than " + std::to_string(limit) +
            " pairs that may touch. Bodies lie in each other, or cells of very "
            "different size meet: look at the last results in ParaView.");
        for (const std::uint32_t j : found)
          if (j != i && is_found_here(j) &&
              division.rank_of(
                lower_corner_of_common_box(boxes.box(i), boxes.box(j))) ==
                rank &&
              may_touch(i, j))
            pairs.push_back(cells[i].cell < cells[j].cell ? CellPair{i, j} :
                                                            CellPair{j, i});
      }
    return pairs;
  }
} // namespace rift
