#include <rift/contact/sleeping_pairs.h>

namespace rift
{
  void
  SleepingPairs::add(const Pair &pair, const double wake)
  {
    pairs.push_back(pair);
    wakes.push_back(wake);
  }

  void
  SleepingPairs::renumber(const std::vector<std::uint32_t> &new_positions)
  {
    for (Pair &pair : pairs)
      pair.cells = {new_positions[pair.cells.a], new_positions[pair.cells.b]};
  }
} // namespace rift
