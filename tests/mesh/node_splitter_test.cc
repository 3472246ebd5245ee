#include "../support/random_cuts.h"

using namespace rift;
using namespace rift::test;

// Random cuts against brute force; node_splitter_cases_test.cc has the cases
// with names.
namespace
{
  /** What the corners of all cells see of their nodes. */
  std::vector<double>
  corner_fields(const DiscreteBody &body)
  {
    std::vector<double> values;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < 4 && !body.topology.is_padding(cell); ++c)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const NodeIndex node = body.topology.node(cell, c);
            values.push_back(body.state.reference[node][d]);
            values.push_back(body.state.displacement[node][d]);
            values.push_back(body.state.velocity[node][d]);
          }
    return values;
  }

  /** Mass and the three components of the momentum. */
  std::array<double, 4>
  mass_and_momentum(const State &state)
  {
    std::array<double, 4> sum{};
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      {
        sum[3] += state.mass[i];
        for (unsigned int d = 0; d < dim; ++d)
          sum[d] += state.mass[i] * state.velocity[i][d];
      }
    return sum;
  }
} // namespace

TEST(NodeSplitter, RandomCutsAgreeWithBruteForce)
{
  std::mt19937 random(7);
  std::size_t  n_splits = 0, n_into_three = 0;
  for (unsigned int sample = 0; sample < 1000; ++sample)
    {
      DiscreteBody       body  = discretize(random_body(random), densities);
      const CellVertices cells = vertices_of_cells(body.topology);
      move_at_random(body.state, random);
      const DiscreteBody before = body;

      const auto         faces   = shuffled_faces(body.topology, random);
      const unsigned int percent = 1 + random() % 100;
      std::set<Triangle> cuts;
      for (std::size_t i = 0; i < faces.size();)
        {
          std::vector<FaceIndex> now;
          for (std::size_t n = 1 + random() % 20; n > 0 && i < faces.size();
               --n, ++i)
            if (random() % 100 < percent)
              {
                now.push_back(faces[i]);
                cuts.insert(triangle_of(body.topology, faces[i]));
              }
          for (const NodeSplit &split : cut(body, now).splits)
            {
              ++n_splits;
              n_into_three += split.parts.size() > 2;
            }
          ASSERT_EQ(partition_of(body.topology),
                    brute_force_partition(cells, cuts))
            << "sample " << sample;
        }

      // All but mass and force is inherited to the last bit.
      ASSERT_EQ(corner_fields(body), corner_fields(before));
      const auto now = mass_and_momentum(body.state);
      const auto was = mass_and_momentum(before.state);
      for (unsigned int d = 0; d < 4; ++d)
        ASSERT_NEAR(now[d], was[d], 1e-13 * was[3]);
      std::vector<double> masses(body.topology.n_nodes(), 0.);
      for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < 4 && !body.topology.is_padding(cell); ++c)
          masses[body.topology.node(cell, c)] +=
            densities[body.topology.material(cell)] *
            body.reference[cell / batch_size].volume[cell % batch_size] / 4;
      ASSERT_EQ(masses, body.state.mass);
    }
  // The samples were worth their while.
  EXPECT_GT(n_splits, 10000u);
  EXPECT_GT(n_into_three, 1000u);
}

TEST(NodeSplitter, OrderOfCutsDoesNotMatter)
{
  std::mt19937 random(8);
  for (unsigned int sample = 0; sample < 100; ++sample)
    {
      const DiscreteBody body  = discretize(random_body(random), densities);
      auto               faces = shuffled_faces(body.topology, random);
      faces.resize(faces.size() / 2);

      DiscreteBody at_once = body;
      cut(at_once, faces);
      for (unsigned int repetition = 0; repetition < 5; ++repetition)
        {
          std::shuffle(faces.begin(), faces.end(), random);
          DiscreteBody in_parts = body;
          cut_in_several_calls(in_parts, faces, random);
          ASSERT_EQ(partition_of(in_parts.topology),
                    partition_of(at_once.topology));
          ASSERT_EQ(in_parts.topology.n_nodes(), at_once.topology.n_nodes());
        }
    }
}

TEST(NodeSplitter, CuttingAllFacesDetachesAllCells)
{
  std::mt19937 random(9);
  for (unsigned int sample = 0; sample < 50; ++sample)
    {
      DiscreteBody body = discretize(random_body(random), densities);
      cut_in_several_calls(body, shuffled_faces(body.topology, random), random);
      EXPECT_EQ(body.topology.n_nodes(), 4 * body.topology.n_cells());
      const Partition nodes = partition_of(body.topology);
      EXPECT_EQ(std::set<std::size_t>(nodes.begin(), nodes.end()).size(),
                nodes.size());
    }
}

TEST(NodeSplitter, PieceOfTheSmallestCellKeepsTheNode)
{
  std::mt19937 random(10);
  DiscreteBody body =
    discretize(make_box({2, 2, 2}, 1, .2, random()), densities);
  std::size_t n_splits = 0;
  for (const FaceIndex face : shuffled_faces(body.topology, random))
    {
      const std::size_t n_before = body.topology.n_nodes();
      for (const NodeSplit &split : cut(body, {face}).splits)
        {
          ++n_splits;
          EXPECT_LT(split.parts[0], n_before);
          const VertexIndex v = body.topology.node_vertices[split.parts[0]];
          CellIndex         last_smallest = 0;
          for (std::size_t i = 0; i < split.parts.size(); ++i)
            {
              if (i > 0)
                {
                  EXPECT_GE(split.parts[i], n_before);
                }
              EXPECT_EQ(body.topology.node_vertices[split.parts[i]], v);
              auto cell = body.topology.vertex_cells_first(v);
              while (
                body.topology.node(*cell,
                                   body.topology.corner_at_vertex(*cell, v)) !=
                split.parts[i])
                ++cell;
              EXPECT_TRUE(i == 0 || *cell > last_smallest);
              last_smallest = *cell;
            }
        }
    }
  EXPECT_EQ(n_splits, 4 * body.topology.n_cells() - 27);
}
