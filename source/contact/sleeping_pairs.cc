#include <rift/contact/sleeping_pairs.h>

#include <cstring>

namespace rift
{
  void
  SleepingPairs::add(const CellPair    &cells,
                     const std::uint8_t axis,
                     const double       wake)
  {
    pairs.push_back(cells);
    axes.push_back(axis);
    wakes.push_back(wake);
  }

  std::vector<SleepingPairs::Woken>
  SleepingPairs::wake(const double path)
  {
    std::vector<Woken> woken;
    const auto         all_sleep = [&](const std::size_t begin) {
      Simd of_eight;
      std::memcpy(&of_eight, &wakes[begin], sizeof(of_eight));
      return !any(of_eight <= path);
    };
    for (std::size_t i = 0; i < wakes.size();)
      if (i + batch_size <= wakes.size() && all_sleep(i))
        i += batch_size;
      else if (wakes[i] > path)
        ++i;
      else
        {
          woken.push_back({pairs[i], axes[i]});
          pairs[i] = pairs.back();
          axes[i]  = axes.back();
          wakes[i] = wakes.back();
          pairs.pop_back();
          axes.pop_back();
          wakes.pop_back();
        }
    return woken;
  }

  void
  SleepingPairs::clear()
  {
    pairs.clear();
    axes.clear();
    wakes.clear();
  }

  void
  SleepingPairs::renumber(const std::vector<std::uint32_t> &new_positions)
  {
    for (CellPair &pair : pairs)
      pair = {new_positions[pair.a], new_positions[pair.b]};
  }
} // namespace rift
