// Cohesive faces of a body that is divided among the ranks: energies and
// counts are the same as of the whole body.

#include "../support/distributed_body.h"
#include "../support/random_cuts.h"
#include "breaking_body.h"

using namespace rift;
using namespace rift::test;

namespace
{
  std::vector<MaterialParameters>
  materials()
  {
    std::vector<MaterialParameters> result = {granite(), granite()};
    result[1].tensile_strength             = 7.5e6;
    result[1].weibull_modulus              = 5;
    // Enough for cells of a metre.
    result[1].fracture_energy_1 = 4e6;
    result[1].fracture_energy_2 = 6e6;
    return result;
  }

  /** Numbers in [-1, 1] that depend on nothing but these two. */
  Vector3<double>
  random_vector(const unsigned int seed, const unsigned int place)
  {
    std::seed_seq                          seeds{seed, place};
    std::mt19937                           random(seeds);
    std::uniform_real_distribution<double> number(-1, 1);
    return {{number(random), number(random), number(random)}};
  }

  /** Cuts all faces, which take over forces that held them. */
  void
  cut_all(BreakingBody &body, const double force)
  {
    body.split(body.all_faces());
    ASSERT_TRUE(body.sum_forces());
    for (OpeningCorner &corner : body.openings)
      {
        const Face &face = body.topology.faces[corner.face];
        const auto  cell = body.topology.cell_global_indices[face.cells[0]];
        corner.force =
          force *
          random_vector(12 * cell + 3 * face.local_faces[0], corner.corner);
      }
    body.start_openings();
  }

  /** Moves each corner of each cell at random and updates the faces. */
  void
  move_all(BreakingBody &body, const double size, const unsigned int step)
  {
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          if (body.topology.is_padding(cell))
            continue;
          const auto global = body.topology.cell_global_indices[cell];
          const auto u      = size * random_vector(4 * global + c, step);
          for (unsigned int d = 0; d < 3; ++d)
            body.state.displacement[body.topology.node(cell, c)][d] = u[d];
        }
    body.force.add_to(body.state, body.activity);
  }
} // namespace

TEST(DividedFaces, EnergiesAndCountsAreThoseOfTheWhole)
{
  const Communicator all(MPI_COMM_WORLD);
  FaceCounts         sum;
  for (unsigned int seed = 0; seed < 20; ++seed)
    {
      std::mt19937 random(seed);
      Body         body = random_body(random);
      order(body);
      const BodyPart part =
        part_of(body,
                random_owners(body.cells.size(), all.size(), random),
                all.rank());
      BreakingBody whole(body, materials());
      BreakingBody own(part,
                       materials(),
                       .25,
                       parameters_of(CohesiveModel::extrinsic),
                       all);
      cut_all(whole, 1e6);
      cut_all(own, 1e6);

      double size = 1e-5;
      for (unsigned int step = 0; step < 6; ++step, size *= 8)
        {
          move_all(whole, size, step);
          move_all(own, size, step);
          const Energies expected = whole.energies(1), found = own.energies(1);
          EXPECT_EQ(found["cohesive"], expected["cohesive"]);
          EXPECT_EQ(found["fracture"], expected["fracture"]);
          EXPECT_EQ(found["friction"], expected["friction"]);

          const FaceCounts of_whole = whole.force.count_faces(Communicator());
          const FaceCounts of_all   = own.force.count_faces(all);
          EXPECT_EQ(of_all.inserted, of_whole.inserted);
          EXPECT_EQ(of_all.opened, of_whole.opened);
          EXPECT_EQ(of_all.failed, of_whole.failed);
          EXPECT_EQ(of_all.too_short, of_whole.too_short);
          sum.inserted += of_all.inserted;
          sum.opened += of_all.opened;
          sum.failed += of_all.failed;
          sum.too_short += of_all.too_short;
        }
    }
  // Faces of each kind are among them.
  EXPECT_GT(sum.failed, 0u);
  EXPECT_GT(sum.opened, sum.failed);
  EXPECT_GT(sum.too_short, 0u);
  EXPECT_GT(sum.inserted, sum.too_short);
}
