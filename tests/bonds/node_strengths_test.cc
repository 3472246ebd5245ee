#include <gtest/gtest.h>

#include <random>

#include "bonded_body.h"

using namespace rift;
using namespace rift::test;

// A vertex at its strength has a cell that is looked at, also where materials of
// different friction meet: under uniform stresses of all kinds.
TEST(NodeStrengths, CellsAtTheirStrengthAreHot)
{
  Body body = make_box({{2, 1, 1}}, 1e-3);
  for (std::size_t i = 0; i < body.cells.size(); ++i)
    body.cells[i].material = i < body.cells.size() / 2 ? 0 : 1;
  std::vector<MaterialParameters> materials = {granite(), granite()};
  materials[0].friction_angle               = 10 * M_PI / 180;
  materials[1].friction_angle               = 50 * M_PI / 180;
  // Friction counts up to here, in tension.
  materials[0].tensile_strength = materials[1].tensile_strength =
    DirectionalValue(30e6);
  BondedBody         bonded(body, materials);
  const Topology    &topology = bonded.topology;
  const StressBounds bounds   = bonded.strengths.stress_bounds(Communicator());
  bonded.internal_force.watch(bounds);

  std::mt19937                           random(1);
  std::uniform_real_distribution<double> value(-1, 1);
  unsigned int                           n_at_strength = 0, n_below = 0;
  for (unsigned int trial = 0; trial < 2000; ++trial)
    {
      Matrix3<double> strain;
      const double    size = 1e-3 * std::pow(value(random), 2);
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          strain[i][j] = strain[j][i] = size * value(random);
      for (NodeIndex node = 0; node < topology.n_nodes(); ++node)
        {
          const auto u = strain * bonded.state.reference[node].vector();
          for (unsigned int d = 0; d < dim; ++d)
            bonded.state.displacement[node][d] = u[d];
        }
      ASSERT_TRUE(bonded.sum_forces());
      const auto             &hot = bonded.internal_force.hot_cells();
      SymmetricTensor<double> stress;
      const auto second = bonded.internal_force.stress(bonded.state, 0).second;
      for (std::size_t i = 0; i < stress.size(); ++i)
        stress[i] = second[i][0];
      for (VertexIndex vertex = 0; vertex < topology.n_vertices(); ++vertex)
        {
          if (bonded.strengths.largest_demand(vertex, stress) < 1)
            {
              ++n_below;
              continue;
            }
          ++n_at_strength;
          EXPECT_TRUE(std::any_of(
            topology.vertex_cells_first(vertex),
            topology.vertex_cells_last(vertex),
            [&hot](const CellIndex cell) {
              return std::binary_search(hot.begin(), hot.end(), cell);
            }));
        }
    }
  EXPECT_GT(n_at_strength, 1000u);
  EXPECT_GT(n_below, 1000u);
}
