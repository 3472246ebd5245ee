#include <rift/base/check.h>
#include <rift/contact/background_octree.h>
#include <rift/contact/rendezvous.h>

#include <algorithm>
#include <utility>

namespace rift
{
  namespace
  {
    /** Whether cells ascend by name and occur once. */
    bool
    do_ascend(const std::vector<ContactCell> &cells)
    {
      for (std::size_t i = 1; i < cells.size(); ++i)
        if (cells[i].cell <= cells[i - 1].cell)
          return false;
      return true;
    }

    bool
    comes_before(const CellPair &x, const CellPair &y)
    {
      return x.a != y.a ? x.a < y.a : x.b < y.b;
    }

    /** Whether pairs ascend and occur once, each with its first cell first. */
    bool
    do_ascend(const std::vector<CellPair> &pairs)
    {
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (pairs[i].a >= pairs[i].b ||
            (i > 0 && !comes_before(pairs[i - 1], pairs[i])))
          return false;
      return true;
    }

    /** Some pairs of a space, by name. */
    ContactNeighbourhood
    select(const ContactSpace &space, const std::vector<CellPair> &pairs)
    {
      // Names, and the numbers of the cells.
      using Name = std::pair<GlobalCellIndex, std::uint32_t>;
      std::vector<Name> names;
      const auto        name = [&](const std::uint32_t number) {
        return Name(space.cell(number).cell, number);
      };
      for (const CellPair &pair : pairs)
        {
          names.push_back(name(pair.a));
          names.push_back(name(pair.b));
        }
      std::sort(names.begin(), names.end());
      names.erase(std::unique(names.begin(), names.end()), names.end());
      const auto position = [&](const std::uint32_t number) {
        return static_cast<std::uint32_t>(
          std::lower_bound(names.begin(), names.end(), name(number)) -
          names.begin());
      };
      ContactNeighbourhood result;
      for (const Name &n : names)
        result.cells.push_back(space.cell(n.second));
      for (const CellPair &pair : pairs)
        result.pairs.push_back({position(pair.a), position(pair.b)});
      std::sort(result.pairs.begin(), result.pairs.end(), comes_before);
      return result;
    }

    /** No pair is in two of the parts; cells may be. */
    ContactNeighbourhood
    merge_neighbourhoods(const std::vector<ContactNeighbourhood> &parts)
    {
      ContactNeighbourhood result;
      auto                &cells = result.cells;
      for (const ContactNeighbourhood &part : parts)
        cells.insert(cells.end(), part.cells.begin(), part.cells.end());
      std::sort(cells.begin(), cells.end(), [](const auto &a, const auto &b) {
        return a.cell < b.cell;
      });
      cells.erase(std::unique(cells.begin(),
                              cells.end(),
                              [](const auto &a, const auto &b) {
                                return a.cell == b.cell;
                              }),
                  cells.end());
      const auto position = [&cells](const ContactCell &cell) {
        return static_cast<std::uint32_t>(
          std::lower_bound(
            cells.begin(),
            cells.end(),
            cell,
            [](const auto &a, const auto &b) { return a.cell < b.cell; }) -
          cells.begin());
      };
      for (const ContactNeighbourhood &part : parts)
        for (const CellPair &pair : part.pairs)
          result.pairs.push_back(
            {position(part.cells[pair.a]), position(part.cells[pair.b])});
      std::sort(result.pairs.begin(), result.pairs.end(), comes_before);
      return result;
    }
  } // namespace

  Rendezvous::Rendezvous(const Communicator &communicator,
                         Subscribers         subscribers)
    : communicator(communicator)
    , subscribers(std::move(subscribers))
  {
  }

  void
  Rendezvous::divide(const std::vector<ContactCell> &own)
  {
    std::vector<Vector3<double>> centres;
    for (const ContactCell &cell : own)
      {
        const Box box = box_around(cell);
        centres.push_back(.5 * (box.lower + box.upper));
      }
    division = divide_space(centres, communicator);
    space.clear();
    places.clear();
  }

  ContactNeighbourhood
  Rendezvous::update(std::vector<ContactCell> news)
  {
    rift_check(do_ascend(news));
    const bool is_new = needs_all();
    if (is_new && communicator.size() > 1)
      divide(news);
    std::vector<ContactSpace::RemoteCell> remote_cells =
      send_to_space_owners(std::move(news));
    std::vector<CellPair> pairs;
    communicator.collectively([&] {
      pairs =
        space.update(std::move(remote_cells), division, communicator.rank());
    });
    if (communicator.size() > 1)
      largest_number = communicator.max(static_cast<double>(space.size()));
    if (is_new)
      largest_number_at_first = std::max(1., largest_number);

    ContactNeighbourhood result =
      communicator.size() > 1 ? return_pairs(pairs) : select(space, pairs);
    rift_check(do_ascend(result.cells) && do_ascend(result.pairs));
    return result;
  }

  std::vector<ContactSpace::RemoteCell>
  Rendezvous::send_to_space_owners(std::vector<ContactCell> news)
  {
    std::vector<ContactSpace::RemoteCell> remote_cells;
    if (communicator.size() == 1)
      {
        for (ContactCell &cell : news)
          remote_cells.push_back({std::move(cell), {0}});
        return remote_cells;
      }
    std::map<int, std::vector<ContactCell>> cells;
    // Of each cell the number of those who see it, and these.
    std::map<int, std::vector<int>> views;
    for (const ContactCell &cell : news)
      {
        std::vector<int>  now   = division.ranks_of(box_around(cell));
        std::vector<int> &place = places[cell.cell];
        std::vector<int>  told;
        std::set_union(now.begin(),
                       now.end(),
                       place.begin(),
                       place.end(),
                       std::back_inserter(told));
        const std::vector<int> ranks = subscribers(cell);
        rift_check(std::is_sorted(ranks.begin(), ranks.end()));
        for (const int rank : told)
          {
            cells[rank].push_back(cell);
            std::vector<int> &view = views[rank];
            view.push_back(static_cast<int>(ranks.size()));
            view.insert(view.end(), ranks.begin(), ranks.end());
          }
        place = std::move(now);
      }

    const auto new_cells = communicator.exchange(cells);
    const auto new_views = communicator.exchange(views);
    for (const auto &[rank, message] : new_cells)
      {
        auto view = new_views.at(rank).begin();
        for (const ContactCell &cell : message)
          {
            remote_cells.push_back({cell, {view + 1, view + 1 + *view}});
            view += 1 + *view;
          }
      }
    return remote_cells;
  }

  ContactNeighbourhood
  Rendezvous::return_pairs(const std::vector<CellPair> &pairs) const
  {
    std::map<int, std::vector<CellPair>> concerned;
    for (const CellPair &pair : pairs)
      {
        std::vector<int> ranks;
        const auto      &of_a = space.cell(pair.a).subscribers,
                   &of_b      = space.cell(pair.b).subscribers;
        std::set_union(of_a.begin(),
                       of_a.end(),
                       of_b.begin(),
                       of_b.end(),
                       std::back_inserter(ranks));
        for (const int rank : ranks)
          concerned[rank].push_back(pair);
      }
    std::map<int, std::vector<ContactCell>> cells;
    std::map<int, std::vector<CellPair>>    told;
    for (const auto &[rank, of_rank] : concerned)
      {
        ContactNeighbourhood part = select(space, of_rank);
        cells[rank]               = std::move(part.cells);
        told[rank]                = std::move(part.pairs);
      }
    const auto                        new_cells = communicator.exchange(cells);
    const auto                        new_pairs = communicator.exchange(told);
    std::vector<ContactNeighbourhood> parts;
    for (const auto &[rank, of_rank] : new_cells)
      parts.push_back({of_rank, new_pairs.at(rank)});
    return merge_neighbourhoods(parts);
  }
} // namespace rift
