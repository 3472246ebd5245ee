#include <rift/base/check.h>
#include <rift/contact/background_octree.h>
#include <rift/contact/rendezvous.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** Space is divided anew when the rank with most cells has so many times
     * what it had when that was done last. */
    constexpr double largest_growth = 1.5;

    bool
    comes_before(const ContactCell &cell, const GlobalCellIndex name)
    {
      return cell.cell < name;
    }

    /** Where a cell that is there stands. */
    std::uint32_t
    position_of(const GlobalCellIndex           name,
                const std::vector<ContactCell> &cells)
    {
      return static_cast<std::uint32_t>(
        std::lower_bound(cells.begin(), cells.end(), name, comes_before) -
        cells.begin());
    }

    /** Whether cells ascend by name and occur once. */
    bool
    do_ascend(const std::vector<ContactCell> &cells)
    {
      for (std::size_t i = 1; i < cells.size(); ++i)
        if (cells[i].cell <= cells[i - 1].cell)
          return false;
      return true;
    }

    /** Whether a cell is at a position. */
    bool
    is_at(const std::uint32_t             position,
          const GlobalCellIndex           name,
          const std::vector<ContactCell> &cells)
    {
      return position < cells.size() && cells[position].cell == name;
    }

    /** Whether pairs ascend and occur once, each with its first cell first. */
    bool
    do_ascend(const std::vector<BoxPair> &pairs)
    {
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (pairs[i].first >= pairs[i].second ||
            (i > 0 && !(pairs[i - 1] < pairs[i])))
          return false;
      return true;
    }

    /** Some pairs and the cells in them. */
    ContactNeighbourhood
    select(const std::vector<ContactCell> &cells,
           const std::vector<BoxPair>     &pairs)
    {
      std::vector<std::uint32_t> position(cells.size(), invalid_index);
      for (const BoxPair &pair : pairs)
        position[pair.first] = position[pair.second] = 0;
      ContactNeighbourhood result;
      for (std::size_t i = 0; i < cells.size(); ++i)
        if (position[i] != invalid_index)
          {
            position[i] = static_cast<std::uint32_t>(result.cells.size());
            result.cells.push_back(cells[i]);
          }
      for (const BoxPair &pair : pairs)
        result.pairs.push_back({position[pair.first], position[pair.second]});
      return result;
    }

    /** No pair is in two of the parts; cells may be. */
    ContactNeighbourhood
    merge_neighbourhoods(const std::vector<ContactNeighbourhood> &parts)
    {
      std::vector<const ContactCell *> found;
      for (const ContactNeighbourhood &part : parts)
        for (const ContactCell &cell : part.cells)
          found.push_back(&cell);
      std::sort(found.begin(), found.end(), [](const auto *a, const auto *b) {
        return a->cell < b->cell;
      });
      ContactNeighbourhood result;
      auto                &cells = result.cells;
      for (const ContactCell *cell : found)
        if (cells.empty() || cells.back().cell != cell->cell)
          cells.push_back(*cell);

      for (const ContactNeighbourhood &part : parts)
        {
          std::vector<std::uint32_t> position;
          for (const ContactCell &cell : part.cells)
            {
              position.push_back(position_of(cell.cell, cells));
              rift_check(is_at(position.back(), cell.cell, cells));
            }
          for (const BoxPair &pair : part.pairs)
            result.pairs.push_back(
              {position[pair.first], position[pair.second]});
        }
      result.pairs = sort_pairs(result.pairs, cells.size());
      rift_check(do_ascend(result.cells) && do_ascend(result.pairs));
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
        const Box box = box_around(cell.motion.positions, 0);
        centres.push_back(.5 * (box.lower + box.upper));
      }
    division = divide_space(centres, communicator);
  }

  ContactNeighbourhood
  Rendezvous::search(std::vector<ContactCell> own, const double skin)
  {
    rift_check(do_ascend(own));
    if (communicator.size() == 1)
      {
        std::vector<BoxPair> pairs = find_candidates(own, skin, division, 0);
        rift_check(do_ascend(pairs));
        return {std::move(own), std::move(pairs)};
      }

    const bool is_new =
      !(largest_number < largest_growth * largest_number_at_first);
    if (is_new)
      divide(own);
    const ReceivedCells received =
      send_to_space_owners(own, [&](const ContactCell &cell) {
        return division.ranks_of(box_around(cell.motion.positions, skin / 2));
      });
    largest_number = communicator.max(received.cells.size());
    if (is_new)
      largest_number_at_first = largest_number;

    std::vector<BoxPair> pairs;
    communicator.collectively([&] {
      pairs =
        find_candidates(received.cells, skin, division, communicator.rank());
    });
    return return_pairs(received, pairs);
  }

  ContactNeighbourhood
  Rendezvous::join(const std::vector<ContactCell> &own,
                   const std::vector<NamedPair>   &pairs) const
  {
    rift_check(do_ascend(own));
    // The two cells of a pair meet at a rank that follows from their names.
    const auto place_of = [this](const NamedPair &pair) {
      return static_cast<int>(pair.first % communicator.size());
    };
    std::map<GlobalCellIndex, std::vector<int>> places;
    for (const NamedPair &pair : pairs)
      for (const GlobalCellIndex cell : {pair.first, pair.second})
        {
          const std::uint32_t position = position_of(cell, own);
          if (position < own.size() && own[position].cell == cell)
            places[cell].push_back(place_of(pair));
        }
    for (auto &[cell, ranks] : places)
      {
        std::sort(ranks.begin(), ranks.end());
        ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
      }

    const ReceivedCells received =
      send_to_space_owners(own, [&](const ContactCell &cell) {
        const auto found = places.find(cell.cell);
        return found == places.end() ? std::vector<int>() : found->second;
      });
    std::vector<BoxPair> own_pairs;
    for (const NamedPair &pair : pairs)
      if (place_of(pair) == communicator.rank())
        {
          own_pairs.push_back({position_of(pair.first, received.cells),
                               position_of(pair.second, received.cells)});
          rift_check(
            is_at(own_pairs.back().first, pair.first, received.cells) &&
            is_at(own_pairs.back().second, pair.second, received.cells));
        }
    return return_pairs(received, own_pairs);
  }

  Rendezvous::ReceivedCells
  Rendezvous::send_to_space_owners(const std::vector<ContactCell> &own,
                                   const Destinations &destinations) const
  {
    std::map<int, std::vector<ContactCell>> cells;
    // Of each cell the number of those who see it, and these.
    std::map<int, std::vector<int>> views;
    for (const ContactCell &cell : own)
      for (const int place : destinations(cell))
        {
          cells[place].push_back(cell);
          const std::vector<int> ranks = subscribers(cell);
          std::vector<int>      &view  = views[place];
          view.push_back(static_cast<int>(ranks.size()));
          view.insert(view.end(), ranks.begin(), ranks.end());
        }

    const auto                    new_cells = communicator.exchange(cells);
    std::vector<std::vector<int>> new_viewers;
    for (const auto &[rank, message] : communicator.exchange(views))
      for (auto i = message.begin(); i != message.end(); i += 1 + *i)
        new_viewers.emplace_back(i + 1, i + 1 + *i);
    std::vector<std::pair<const ContactCell *, std::vector<int> *>> order;
    for (const auto &[rank, message] : new_cells)
      for (const ContactCell &cell : message)
        order.emplace_back(&cell, &new_viewers[order.size()]);
    rift_check(order.size() == new_viewers.size());
    std::sort(order.begin(), order.end(), [](const auto &a, const auto &b) {
      return a.first->cell < b.first->cell;
    });
    ReceivedCells received;
    received.cells.reserve(order.size());
    for (const auto &[cell, ranks] : order)
      {
        received.cells.push_back(*cell);
        rift_check(std::is_sorted(ranks->begin(), ranks->end()));
        received.subscribers.push_back(std::move(*ranks));
      }
    rift_check(do_ascend(received.cells));
    return received;
  }

  ContactNeighbourhood
  Rendezvous::return_pairs(const ReceivedCells        &received,
                           const std::vector<BoxPair> &pairs) const
  {
    std::map<int, std::vector<BoxPair>> concerned;
    for (const BoxPair &pair : pairs)
      {
        const auto &of_first  = received.subscribers[pair.first],
                   &of_second = received.subscribers[pair.second];
        for (const int rank : of_first)
          concerned[rank].push_back(pair);
        for (const int rank : of_second)
          if (!std::binary_search(of_first.begin(), of_first.end(), rank))
            concerned[rank].push_back(pair);
      }
    std::map<int, std::vector<ContactCell>> cells;
    std::map<int, std::vector<BoxPair>>     told;
    for (auto &[rank, of_rank] : concerned)
      {
        ContactNeighbourhood part = select(received.cells, of_rank);
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
