// Cells in a part of space: pairs among them, and cells that come and go.

#include <rift/contact/contact_space.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace rift;

namespace
{
  /** A cell of edge .1 that nothing holds, with this lower corner. */
  ContactSpace::RemoteCell
  cell_at(const GlobalCellIndex cell, const Vector3<double> &place)
  {
    ContactSpace::RemoteCell result{};
    result.cell               = cell;
    result.constants.body     = invalid_index;
    result.margin             = .01;
    result.subscribers        = {0};
    const Tetrahedron corners = {
      {{{0, 0, 0}}, {{.1, 0, 0}}, {{0, .1, 0}}, {{0, 0, .1}}}};
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        result.positions[c] = place + corners[c];
        result.groups[c]    = n_corners * cell + c;
        result.behind[c]    = invalid_index;
      }
    return result;
  }

  /** Pairs of names, the smaller one first. */
  std::vector<std::pair<GlobalCellIndex, GlobalCellIndex>>
  named(const ContactSpace &space, const std::vector<CellPair> &pairs)
  {
    std::vector<std::pair<GlobalCellIndex, GlobalCellIndex>> result;
    for (const CellPair &pair : pairs)
      result.emplace_back(space.cell(pair.a).cell, space.cell(pair.b).cell);
    std::sort(result.begin(), result.end());
    return result;
  }

  using Pairs = std::vector<std::pair<GlobalCellIndex, GlobalCellIndex>>;
} // namespace

TEST(ContactSpace, FindsPairsOfNews)
{
  ContactSpace        space;
  const SpaceDivision all_of_rank_0;
  const auto          update = [&](std::vector<ContactSpace::RemoteCell> news) {
    return named(space, space.update(std::move(news), all_of_rank_0, 0));
  };
  // 7 and 3 touch, 5 is apart.
  EXPECT_EQ(update({cell_at(7, {{0, 0, 0}}),
                    cell_at(3, {{.05, .01, .01}}),
                    cell_at(5, {{1, 0, 0}})}),
            Pairs({{3, 7}}));
  // The pair of the other two is no news.
  EXPECT_EQ(update({cell_at(5, {{.5, 0, 0}})}), Pairs());
  EXPECT_EQ(update({cell_at(5, {{-.08, .01, .01}})}), Pairs({{5, 7}}));
  EXPECT_EQ(space.size(), 3u);
  // What has a common group or a held face is none.
  auto bonded      = cell_at(5, {{-.08, .01, .01}});
  bonded.groups[2] = n_corners * 7 + 1;
  EXPECT_EQ(update({bonded}), Pairs());
  auto released       = bonded;
  released.behind[1]  = 7;
  released.is_held[1] = false;
  EXPECT_EQ(update({released}), Pairs({{5, 7}}));
  released.is_held[1] = true;
  EXPECT_EQ(update({released}), Pairs());
}

TEST(ContactSpace, ForgetsCellsThatLeave)
{
  constexpr std::uint64_t n_keys = std::uint64_t(1)
                                   << 3 * SpaceDivision::n_levels;
  // The upper half along z is of rank 1.
  const SpaceDivision halves({{0, 0, 0}}, 1, {n_keys / 2});
  ContactSpace        space;
  const auto          update = [&](std::vector<ContactSpace::RemoteCell> news) {
    return named(space, space.update(std::move(news), halves, 0));
  };
  EXPECT_EQ(update({cell_at(1, {{.2, .2, .2}}), cell_at(2, {{.21, .2, .2}})}),
            Pairs({{1, 2}}));
  EXPECT_EQ(space.size(), 2u);
  EXPECT_EQ(update({cell_at(2, {{.21, .2, .7}})}), Pairs());
  EXPECT_EQ(space.size(), 1u);
  EXPECT_EQ(update({cell_at(1, {{.22, .2, .2}})}), Pairs());
  EXPECT_EQ(update({cell_at(2, {{.21, .2, .2}})}), Pairs({{1, 2}}));
  EXPECT_EQ(space.size(), 2u);
  const std::uint64_t bytes = space.bytes();
  EXPECT_GT(bytes, 2 * sizeof(ContactSpace::RemoteCell));
  EXPECT_LT(bytes, 10000u);
  space.clear();
  EXPECT_EQ(space.size(), 0u);
}
