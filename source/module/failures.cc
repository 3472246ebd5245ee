#include <rift/module/failures.h>

#include <limits>
#include <tuple>

namespace rift
{
  std::optional<Failure>
  Failures::first_of_ranks(const Communicator &communicator) const
  {
    struct Key
    {
      std::uint64_t   step;
      GlobalCellIndex cell;
      int             rank;
    };
    Key own{std::numeric_limits<std::uint64_t>::max(),
            invalid_index,
            communicator.rank()};
    if (first)
      {
        own.step = first->step;
        own.cell = first->cell;
      }
    const Key key =
      communicator.first_of_ranks(own, [](const Key &a, const Key &b) {
        return std::tie(a.step, a.cell, a.rank) <
               std::tie(b.step, b.cell, b.rank);
      });
    if (key.step == std::numeric_limits<std::uint64_t>::max())
      return {};
    const auto what   = communicator.all_gather(first ? first->what : "");
    const auto advice = communicator.all_gather(first ? first->advice : "");
    return Failure{key.step, key.cell, what[key.rank], advice[key.rank]};
  }
} // namespace rift
