#include <rift/contact/sleeping_pairs.h>

#include <algorithm>
#include <limits>

namespace rift
{
  std::size_t
  SleepingPairs::slot_of(const double wake) const
  {
    const double slot = (wake - origin) / width;
    // Also what is not a number, as after something became infinitely fast.
    if (!(slot < n_slots))
      return n_slots;
    return slot > 0 ? static_cast<std::size_t>(slot) : 0;
  }

  void
  SleepingPairs::add(const Pair &pair, const double wake)
  {
    slots[std::max(slot_of(wake), next_slot)].push_back({pair, wake});
    ++n_pairs;
  }

  std::vector<SleepingPairs::Pair>
  SleepingPairs::wake(const double path)
  {
    std::vector<Pair> woken;
    const auto        wake_before = [&](const std::size_t end) {
      for (; next_slot < end; ++next_slot)
        {
          for (const Entry &entry : slots[next_slot])
            woken.push_back(entry.pair);
          // Its memory as well: each may once have held most of the pairs.
          slots[next_slot] = std::vector<Entry>();
        }
    };
    wake_before(slot_of(path));
    if (next_slot == n_slots)
      {
        start_anew(path);
        wake_before(slot_of(path));
      }

    std::vector<Entry> &slot = slots[next_slot];
    for (std::size_t i = 0; i < slot.size();)
      if (slot[i].wake > path)
        ++i;
      else
        {
          woken.push_back(slot[i].pair);
          slot[i] = slot.back();
          slot.pop_back();
        }
    last_path = path;
    n_pairs -= woken.size();
    return woken;
  }

  void
  SleepingPairs::start_anew(const double path)
  {
    origin    = path;
    width     = std::max(steps_per_slot * (path - last_path),
                     std::numeric_limits<double>::min());
    next_slot = 0;
    const std::vector<Entry> entries = std::move(slots[n_slots]);
    slots[n_slots].clear();
    for (const Entry &entry : entries)
      slots[slot_of(entry.wake)].push_back(entry);
  }

  void
  SleepingPairs::renumber(const std::vector<std::uint32_t> &new_positions)
  {
    for (std::vector<Entry> &slot : slots)
      for (Entry &entry : slot)
        {
          CellPair &cells = entry.pair.cells;
          cells           = {new_positions[cells.a], new_positions[cells.b]};
        }
  }
} // namespace rift
