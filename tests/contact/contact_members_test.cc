// Cells in pairs: which are kept, and under which number.

#include <rift/contact/contact_members.h>

#include "../support/test_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  ContactCell
  cell_of(const CellIndex cell)
  {
    ContactCell result{};
    result.cell      = cell;
    result.constants = {1. + cell, invalid_index};
    result.stiffness = {10. + cell, 1};
    result.margin    = .1 * cell;
    return result;
  }
} // namespace

TEST(ContactMembers, KeepTheirPairsWhenOthersAreForgotten)
{
  DiscreteBody       body = discretize(make_box({{4, 4, 4}}), {1});
  const Communicator alone;
  ContactMembers     members(body.topology, alone);
  // Pairs of cells that follow each other: 0 and 1, 2 and 3, ...
  const CellIndex n = 360;
  ASSERT_LE(n, body.topology.n_cells());
  for (CellIndex cell = 0; cell < n; ++cell)
    EXPECT_EQ(members.take_in(cell_of(cell)), cell);
  for (std::uint32_t i = 0; i < n; i += 2)
    {
      EXPECT_TRUE(members.connect({i, i + 1}));
      EXPECT_FALSE(members.connect({i, i + 1}));
      members.pack(body.state, {i, i + 1});
    }
  EXPECT_TRUE(members.tidy().empty());

  // Every fifth pair remains.
  for (std::uint32_t i = 0; i < n; i += 2)
    if (i % 10 != 4)
      members.disconnect({i, i + 1});
  const auto positions = members.tidy();
  ASSERT_EQ(positions.size(), n);
  ASSERT_EQ(members.size(), n / 5);
  std::uint32_t next = 0;
  for (CellIndex cell = 0; cell < n; ++cell)
    {
      if (cell / 2 % 5 != 2)
        {
          EXPECT_EQ(positions[cell], invalid_index);
          continue;
        }
      ASSERT_EQ(positions[cell], next);
      EXPECT_EQ(members[next].cell, cell);
      EXPECT_EQ(members[next].mass, 1. + cell);
      EXPECT_EQ(members[next].stiffness.per_area, 10. + cell);
      EXPECT_EQ(members[next].margin, .1 * cell);
      EXPECT_EQ(members[next].n_pairs, 1u);
      EXPECT_EQ(members.own_cell(next), cell);
      for (unsigned int c = 0; c < n_corners; ++c)
        EXPECT_EQ(members.motions()[next].position[c][0],
                  body.state.reference[body.topology.node(cell, c)][0]);
      ++next;
    }
  EXPECT_FALSE(members.connect({positions[4], positions[5]}));

  // What has been forgotten comes back at the end, and not twice.
  EXPECT_EQ(members.take_in(cell_of(7)), n / 5);
  EXPECT_EQ(members.take_in(cell_of(4)), positions[4]);
  EXPECT_TRUE(members.connect({positions[4], n / 5}));
  EXPECT_EQ(members.size(), n / 5 + 1);
}

TEST(ContactMembers, KnowWhenAStiffnessHasChanged)
{
  DiscreteBody       body = discretize(make_box({{1, 1, 1}}), {1});
  const Communicator alone;
  ContactMembers     members(body.topology, alone);
  members.take_in(cell_of(2));
  members.set_stiffness_of(2, {12, 1});
  EXPECT_FALSE(members.have_stiffnesses_changed());
  members.set_stiffness_of(3, {5, 1});
  EXPECT_FALSE(members.have_stiffnesses_changed());
  members.set_stiffness_of(2, {11, 1});
  EXPECT_TRUE(members.have_stiffnesses_changed());
  EXPECT_FALSE(members.have_stiffnesses_changed());
  // What others tell when they find a pair is older.
  members.take_in(cell_of(2));
  EXPECT_EQ(members[0].stiffness.per_area, 11);
}
