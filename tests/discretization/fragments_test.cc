// Fragments on several ranks.

#include <rift/discretization/fragment_labels.h>
#include <rift/discretization/fragments.h>

#include "../support/divided_body.h"

using namespace rift;
using namespace rift::test;

namespace
{
  const Communicator this_rank_alone;

  /** Label of each cell: the smallest of those that it hangs together with,
   * found by repetition. */
  std::vector<GlobalCellIndex>
  brute_force_labels(const DividedBody &divided)
  {
    const Topology              &topology = divided.whole.topology;
    std::vector<GlobalCellIndex> labels   = identity(topology.n_cells());
    for (bool has_changed = true; has_changed;)
      {
        has_changed = false;
        for (FaceIndex face = 0; face < topology.faces.size(); ++face)
          {
            if (divided.broken.count(triangle_of(topology, face)) > 0)
              continue;
            const CellIndex *cells = topology.faces[face].cells;
            auto            &a = labels[topology.cell_global_indices[cells[0]]];
            auto            &b = labels[topology.cell_global_indices[cells[1]]];
            has_changed |= a != b;
            a = b = std::min(a, b);
          }
      }
    return labels;
  }

  Fragments
  fragments_of(const DiscreteBody        &body,
               const Communicator        &communicator,
               const std::vector<double> &densities = test::densities)
  {
    return find_fragments(body.topology,
                          body.reference,
                          densities,
                          label_bodies(body.topology, communicator).of_cell,
                          body.state,
                          velocities(body.state),
                          communicator);
  }
} // namespace

TEST(Fragments, LabelsAreTheSmallestCells)
{
  const Communicator all(MPI_COMM_WORLD);
  for (unsigned int seed = 0; seed < 100; ++seed)
    {
      const DividedBody divided(seed, all);
      const Topology   &topology = divided.local.topology;
      const auto        expected = brute_force_labels(divided);
      const auto        labels   = label_fragments(topology, all);
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        EXPECT_EQ(labels.of_cell[cell],
                  topology.is_padding(cell) ?
                    invalid_index :
                    expected[topology.cell_global_indices[cell]])
          << "seed " << seed;

      // What is on several ranks is known as divided.
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        if (topology.owns_cell(cell))
          for (const LocalCell &other : divided.part.body.cells)
            {
              const bool is_divided = std::binary_search(labels.divided.begin(),
                                                         labels.divided.end(),
                                                         labels.of_cell[cell]);
              EXPECT_TRUE(is_divided || other.owner == all.rank() ||
                          expected[other.global_index] != labels.of_cell[cell]);
            }
    }
}

TEST(Fragments, AreTheSameToTheLastBitOnAnyNumberOfRanks)
{
  const Communicator all(MPI_COMM_WORLD);
  for (unsigned int seed = 0; seed < 100; ++seed)
    {
      const DividedBody divided(seed, all);
      const auto expected = fragments_of(divided.whole, this_rank_alone).list;
      const auto found    = fragments_of(divided.local, all).list;
      ASSERT_EQ(found.size(), expected.size()) << "seed " << seed;
      for (std::size_t i = 0; i < found.size(); ++i)
        {
          EXPECT_EQ(found[i].n_cells, expected[i].n_cells);
          EXPECT_EQ(found[i].volume, expected[i].volume);
          EXPECT_EQ(found[i].mass, expected[i].mass);
          EXPECT_EQ(found[i].centre, expected[i].centre);
          EXPECT_EQ(found[i].displacement, expected[i].displacement);
          EXPECT_EQ(found[i].velocity, expected[i].velocity);
          EXPECT_EQ(found[i].main_piece, expected[i].main_piece);
          EXPECT_LE(found[i].main_piece, i);
          if (i > 0)
            {
              EXPECT_LE(found[i].mass, found[i - 1].mass);
            }
        }
    }
}

TEST(Fragments, CellsHaveTheNumbersOfTheList)
{
  const Communicator all(MPI_COMM_WORLD);
  for (unsigned int seed = 0; seed < 30; ++seed)
    {
      const DividedBody   divided(seed, all);
      const DiscreteBody &body   = divided.local;
      const auto          labels = brute_force_labels(divided);
      const auto [list, numbers] = fragments_of(body, all);
      for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
        {
          if (body.topology.is_padding(cell))
            {
              EXPECT_EQ(numbers[cell], invalid_index);
              continue;
            }
          ASSERT_LT(numbers[cell], list.size());
          const auto n_cells =
            std::count(labels.begin(),
                       labels.end(),
                       labels[body.topology.cell_global_indices[cell]]);
          EXPECT_EQ(list[numbers[cell]].n_cells,
                    static_cast<std::size_t>(n_cells));
        }
    }
}

TEST(Fragments, TwoHalvesOfABar)
{
  // A plane at x = 1 has failed; of its parts the longer one moves.
  const Communicator all(MPI_COMM_WORLD);
  Body               bar = make_box({3, 1, 1});
  order(bar);
  std::mt19937 random(7);
  const auto   owners   = random_owners(bar.cells.size(), all.size(), random);
  DiscreteBody body     = discretize(part_of(bar, owners, all.rank()), {2000});
  Topology    &topology = body.topology;
  const auto   faces    = faces_in_plane(body, 1);
  body.state.grow(split_nodes(topology, faces));
  for (const FaceIndex face : faces)
    topology.face_states[face] = FaceState::failed;
  for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
    {
      double centre = 0;
      for (unsigned int c = 0; c < n_corners; ++c)
        centre += .25 * body.state.reference[topology.node(cell, c)][0];
      for (unsigned int c = 0; c < n_corners && centre > 1; ++c)
        {
          body.state.displacement[topology.node(cell, c)][2] = .5;
          body.state.velocity[topology.node(cell, c)][1]     = 3;
        }
    }

  const auto  found     = fragments_of(body, all, {2000});
  const auto &fragments = found.list;
  ASSERT_EQ(fragments.size(), 2u);
  EXPECT_EQ(fragments[0].n_cells, 12u);
  EXPECT_EQ(fragments[1].n_cells, 6u);
  EXPECT_NEAR(fragments[0].volume, 2, 1e-15);
  EXPECT_NEAR(fragments[1].volume, 1, 1e-15);
  EXPECT_NEAR(fragments[0].mass, 4000, 1e-12);
  EXPECT_NEAR(norm(fragments[0].centre - Vector3<double>{{2, .5, 1}}),
              0,
              1e-15);
  EXPECT_NEAR(norm(fragments[1].centre - Vector3<double>{{.5, .5, .5}}),
              0,
              1e-15);
  EXPECT_NEAR(norm(fragments[0].velocity - Vector3<double>{{0, 3, 0}}),
              0,
              1e-15);
  EXPECT_EQ(norm(fragments[1].velocity), 0);
  EXPECT_NEAR(norm(fragments[0].displacement - Vector3<double>{{0, 0, .5}}),
              0,
              1e-15);

  // Both are of one body.
  EXPECT_EQ(fragments[0].main_piece, 0u);
  EXPECT_EQ(fragments[1].main_piece, 0u);
}

TEST(Fragments, HaveLeftWhenFartherAwayThanTheirSize)
{
  // The second has come off the first, the third is a body of its own.
  Fragments fragments;
  fragments.list.resize(3);
  fragments.list[1].volume       = 1e-6;
  fragments.list[0].displacement = {{0, 1, 0}};
  fragments.list[1].displacement = {{0, 1.009, 0}};
  fragments.list[2]              = {1, 1e-6, 1, {}, {{7, 7, 7}}, {}, 2};
  EXPECT_FALSE(fragments.has_left(1));
  fragments.list[1].displacement = {{.0072, 1.0072, 0}};
  EXPECT_TRUE(fragments.has_left(1));
  EXPECT_FALSE(fragments.has_left(0));
  EXPECT_FALSE(fragments.has_left(2));
}
