#include <rift/contact/sleeping_pairs.h>

#include <cstring>

namespace rift
{
  void
  SleepingPairs::add(const Pair &pair, const double wake)
  {
    pairs.push_back(pair);
    wakes.push_back(wake);
  }

  std::vector<SleepingPairs::Pair>
  SleepingPairs::wake(const double path)
  {
    std::vector<Pair> woken;
    const auto        all_sleep = [&](const std::size_t begin) {
      Simd of_eight;
      std::memcpy(&of_eight, &wakes[begin], sizeof(of_eight));
      return sign_bits(of_eight <= path) == 0;
    };
    for (std::size_t i = 0; i < wakes.size();)
      if (i + batch_size <= wakes.size() && all_sleep(i))
        i += batch_size;
      else if (wakes[i] > path)
        ++i;
      else
        {
          woken.push_back(pairs[i]);
          pairs[i] = pairs.back();
          wakes[i] = wakes.back();
          pairs.pop_back();
          wakes.pop_back();
        }
    return woken;
  }

  void
  SleepingPairs::renumber(const std::vector<std::uint32_t> &new_positions)
  {
    for (Pair &pair : pairs)
      pair.cells = {new_positions[pair.cells.a], new_positions[pair.cells.b]};
  }
} // namespace rift
