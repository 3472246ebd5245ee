// Fragments on several ranks.

#include <rift/io/fragment_labels.h>
#include <rift/io/fragments.h>

#include "../support/divided_body.h"
#include "../temporary_directory.h"

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

  std::vector<Fragment>
  list(const DiscreteBody &body, const Communicator &communicator)
  {
    return list_fragments(body.topology,
                          body.reference,
                          densities,
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
                  topology.owns_cell(cell) ?
                    expected[topology.cell_global_indices[cell]] :
                    invalid_index)
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
      const auto        expected = list(divided.whole, this_rank_alone);
      const auto        found    = list(divided.local, all);
      if (!all.is_root())
        {
          EXPECT_TRUE(found.empty());
          continue;
        }
      ASSERT_EQ(found.size(), expected.size()) << "seed " << seed;
      for (std::size_t i = 0; i < found.size(); ++i)
        {
          EXPECT_EQ(found[i].n_cells, expected[i].n_cells);
          EXPECT_EQ(found[i].volume, expected[i].volume);
          EXPECT_EQ(found[i].mass, expected[i].mass);
          EXPECT_EQ(found[i].centre, expected[i].centre);
          EXPECT_EQ(found[i].velocity, expected[i].velocity);
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
      const DiscreteBody &body     = divided.local;
      const auto          labels   = brute_force_labels(divided);
      const auto          expected = list(divided.whole, this_rank_alone);
      const auto          numbers =
        number_fragments(body.topology, body.reference, densities, all);
      for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
        {
          if (!body.topology.owns_cell(cell))
            {
              EXPECT_EQ(numbers[cell], invalid_index);
              continue;
            }
          ASSERT_LT(numbers[cell], expected.size());
          const auto n_cells =
            std::count(labels.begin(),
                       labels.end(),
                       labels[body.topology.cell_global_indices[cell]]);
          EXPECT_EQ(expected[numbers[cell]].n_cells, n_cells);
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
  std::vector<FaceIndex> faces;
  for (FaceIndex face = 0; face < topology.faces.size(); ++face)
    {
      bool is_in_plane = true;
      for (const VertexIndex v : triangle_of(topology, face))
        is_in_plane &= body.state.reference[v][0] == 1;
      if (is_in_plane)
        faces.push_back(face);
    }
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

  const auto fragments = list_fragments(topology,
                                        body.reference,
                                        {2000},
                                        body.state,
                                        velocities(body.state),
                                        all);
  if (!all.is_root())
    return;
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
}

TEST(Fragments, File)
{
  const TemporaryDirectory directory;
  Fragment                 fragment{3, .5, 1000, {{1, 2, 3}}, {{4, 5, 6}}};
  write_fragments(directory / "f.csv", {fragment, fragment});
  EXPECT_EQ(read_file(directory / "f.csv"),
            "fragment,cells,volume [m^3],mass [kg],x [m],y [m],z [m],"
            "velocity x [m/s],velocity y [m/s],velocity z [m/s]\n"
            "0,3,0.5,1000,1,2,3,4,5,6\n"
            "1,3,0.5,1000,1,2,3,4,5,6\n");
}
