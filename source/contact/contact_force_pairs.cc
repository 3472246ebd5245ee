#include <rift/base/check.h>
#include <rift/contact/contact_force.h>
#include <rift/contact/separation.h>

#include <algorithm>

// Which pairs are active: their start, sleep and end.
namespace rift
{
  namespace
  {
    /** Two cells may have closed their gap when each has moved by half of it;
     * a little earlier, so that rounding decides nothing. */
    constexpr double earliest = .5 * (1 - 1e-9);
  } // namespace

  ContactPair
  ContactForce::make_pair(const CellPair &cells) const
  {
    const ContactMembers::Member &a = members[cells.a], &b = members[cells.b];
    ContactPair                   pair{};
    pair.cells     = cells;
    pair.constants = {penalty_of(cells),
                      interface.friction[a.material][b.material],
                      interface.damping,
                      1 / (1 / a.mass + 1 / b.mass)};
    return pair;
  }

  void
  ContactForce::merge(std::vector<ContactPair> pairs)
  {
    if (pairs.empty())
      return;
    const auto comes_before = [this](const ContactPair &x,
                                     const ContactPair &y) {
      return name_of(x.cells) < name_of(y.cells);
    };
    std::sort(pairs.begin(), pairs.end(), comes_before);
    const auto n_before = static_cast<std::ptrdiff_t>(active.size());
    active.insert(active.end(), pairs.begin(), pairs.end());
    std::inplace_merge(active.begin(),
                       active.begin() + n_before,
                       active.end(),
                       comes_before);
  }

  void
  ContactForce::start_pairs(const State &state)
  {
    // Of those that could touch before, and those that could not.
    std::vector<SleepingPairs::Pair> meeting, released;
    for (const FoundPair &pair : found)
      {
        members.pack(state, pair.cells);
        (pair.may_overlap ? released : meeting)
          .push_back({pair.cells, no_axis});
      }
    found.clear();
    std::vector<ContactPair> new_pairs;
    for (const CellPair &pair : put_to_sleep(meeting))
      new_pairs.push_back(make_pair(pair));
    const std::vector<CellPair>   near  = put_to_sleep(released);
    const std::vector<CommonPart> parts = common_parts(members.motions(), near);
    for (std::size_t i = 0; i < near.size(); ++i)
      {
        new_pairs.push_back(make_pair(near[i]));
        new_pairs.back().memory.initial_potential = parts[i].potential;
      }
    merge(std::move(new_pairs));
  }

  std::vector<CellPair>
  ContactForce::put_to_sleep(const std::vector<SleepingPairs::Pair> &pairs)
  {
    std::vector<CellPair>     cells;
    std::vector<std::uint8_t> axes;
    for (const SleepingPairs::Pair &pair : pairs)
      {
        cells.push_back(pair.cells);
        axes.push_back(pair.axis);
      }
    std::vector<double> gaps(cells.size());
    find_gaps(members.motions(),
              cells.data(),
              cells.size(),
              axes.data(),
              gaps.data());

    std::vector<CellPair> near;
    for (std::size_t i = 0; i < cells.size(); ++i)
      {
        // Farther than where they have been searched for, and where they may
        // have gone since: they will be found again.
        const double far =
          2 * (members[cells[i].a].margin + members[cells[i].b].margin);
        if (!(gaps[i] > 0))
          near.push_back(cells[i]);
        else if (gaps[i] > far)
          members.disconnect(cells[i]);
        else
          sleeping.add({cells[i], axes[i]}, path + earliest * gaps[i]);
      }
    return near;
  }

  void
  ContactForce::wake_pairs(const State &state)
  {
    const std::vector<SleepingPairs::Pair> woken = sleeping.wake(path);
    for (const SleepingPairs::Pair &pair : woken)
      members.pack(state, pair.cells);
    std::vector<ContactPair> new_pairs;
    for (const CellPair &pair : put_to_sleep(woken))
      new_pairs.push_back(make_pair(pair));
    merge(std::move(new_pairs));
  }

  void
  ContactForce::put_parted_to_sleep(
    const std::vector<SleepingPairs::Pair> &parted)
  {
    if (parted.empty())
      return;
    const std::vector<CellPair> near      = put_to_sleep(parted);
    auto                        next      = parted.begin();
    auto                        next_near = near.begin();
    const auto                  is = [](const CellPair &x, const CellPair &y) {
      return x.a == y.a && x.b == y.b;
    };
    active.erase(std::remove_if(
                   active.begin(),
                   active.end(),
                   [&](const ContactPair &pair) {
                     if (next == parted.end() || !is(next->cells, pair.cells))
                       return false;
                     ++next;
                     if (next_near == near.end() || !is(*next_near, pair.cells))
                       return true;
                     ++next_near;
                     return false;
                   }),
                 active.end());
  }
} // namespace rift
