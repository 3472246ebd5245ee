// Lumped masses before and after splits.

#include "../support/test_body.h"
#include <gtest/gtest.h>

#include <numeric>
#include <random>

using namespace rift;
using namespace rift::test;

namespace
{
  const std::vector<double> densities = {2641, 7850};

  /** A jittered box of 4 x 3 x 3 unit cubes, steel beyond x = 2. */
  DiscreteBody
  make_two_materials(const unsigned int seed)
  {
    Body box = make_box({{4, 3, 3}}, 1, .1, seed);
    for (LocalCell &cell : box.cells)
      {
        double x = 0;
        for (const VertexIndex v : cell.vertices)
          x += box.vertices[v][0] / 4;
        cell.material = x < 2 ? 0 : 1;
      }
    return discretize(box, densities);
  }

  double
  mass_of_cells(const DiscreteBody &body)
  {
    double sum = 0;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      sum += densities[body.topology.material(cell)] *
             body.reference[cell / batch_size].volume[cell % batch_size];
    return sum;
  }

  double
  mass_of_nodes(const DiscreteBody &body)
  {
    double sum = 0;
    for (NodeIndex node = 0; node < body.topology.n_nodes(); ++node)
      sum += lumped_mass(body.topology, body.reference, densities, node);
    return sum;
  }
} // namespace

TEST(LumpedMass, SumsToTheMass)
{
  const DiscreteBody body = make_two_materials(1);
  EXPECT_GT(body.topology.n_cell_slots(), body.topology.n_cells());
  EXPECT_NEAR(mass_of_nodes(body), mass_of_cells(body), 1e-8);
  for (NodeIndex node = 0; node < body.topology.n_nodes(); ++node)
    EXPECT_NEAR(lumped_mass(body.topology, body.reference, densities, node),
                body.state.mass[node],
                1e-13 * body.state.mass[node]);

  // Without jitter the two halves have their volumes.
  Body box = make_box({{2, 2, 2}}, .5);
  EXPECT_NEAR(mass_of_nodes(discretize(box, densities)), 2641, 1e-10);
}

TEST(LumpedMass, SumsToTheMassAfterSplits)
{
  std::mt19937 random(1);
  for (unsigned int seed = 0; seed < 5; ++seed)
    {
      DiscreteBody           body  = make_two_materials(seed);
      const double           mass  = mass_of_cells(body);
      const std::size_t      start = body.topology.n_nodes();
      std::vector<FaceIndex> order(body.topology.faces.size());
      std::iota(order.begin(), order.end(), FaceIndex{0});
      std::shuffle(order.begin(), order.end(), random);
      while (!order.empty())
        {
          const std::size_t      n = std::min<std::size_t>(order.size(), 40);
          std::vector<FaceIndex> faces(order.end() - n, order.end());
          order.resize(order.size() - n);
          std::sort(faces.begin(), faces.end());
          const TopologyChange change = split_nodes(body.topology, faces);
          for (const NodeSplit &split : change.splits)
            {
              // The parts have together what the node had.
              double sum = 0;
              for (const NodeIndex part : split.parts)
                {
                  const double of_part =
                    lumped_mass(body.topology, body.reference, densities, part);
                  EXPECT_GT(of_part, 0);
                  sum += of_part;
                }
              EXPECT_NEAR(sum, body.state.mass[split.parts[0]], 1e-12 * sum);
            }
          body.state.grow(change);
          for (const NodeSplit &split : change.splits)
            for (const NodeIndex part : split.parts)
              body.state.mass[part] =
                lumped_mass(body.topology, body.reference, densities, part);
          EXPECT_EQ(body.state.n_nodes(), body.topology.n_nodes());
          EXPECT_NEAR(mass_of_nodes(body), mass, 1e-12 * mass);
        }
      // All cells are loose: each corner has a quarter of its cell.
      EXPECT_GT(body.topology.n_nodes(), start);
      EXPECT_EQ(body.topology.n_nodes(), 4 * body.topology.n_cells());
      for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < 4 && !body.topology.is_padding(cell); ++c)
          EXPECT_DOUBLE_EQ(
            body.state.mass[body.topology.node(cell, c)],
            densities[body.topology.material(cell)] / 4 *
              body.reference[cell / batch_size].volume[cell % batch_size]);
    }
}

TEST(ReferenceCellData, AreaVectorsAreThoseOfTheFaces)
{
  const DiscreteBody body = make_two_materials(3);
  for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
    {
      if (body.topology.is_padding(cell))
        continue;
      Vector3<double> x[4];
      for (unsigned int c = 0; c < 4; ++c)
        x[c] = body.state.reference[body.topology.node(cell, c)].vector();
      for (unsigned int f = 0; f < 4; ++f)
        {
          const auto &a = x[(f + 1) % 4], &b = x[(f + 2) % 4],
                     &c        = x[(f + 3) % 4];
          Vector3<double> area = .5 * cross(b - a, c - a);
          if (dot(area, x[f] - a) > 0)
            area = -1. * area;
          EXPECT_LT(norm(reference_area_vector(body.reference, cell, f) - area),
                    1e-13);
        }
    }
}
