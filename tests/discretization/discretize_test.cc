// What is taken from deal.II's finite element against closed formulas.

#include <rift/discretization/discretize.h>
#include <rift/mesh/triangulation.h>

#include "../support/test_body.h"
#include <gtest/gtest.h>

using namespace rift;

namespace
{
  const std::vector<double> densities = {2641, 7850};

  test::Body
  make_body()
  {
    test::Body box = test::make_box({{3, 4, 2}}, .01, .15);
    for (LocalCell &cell : box.cells)
      cell.material = box.vertices[cell.vertices[0]][1] < .015 ? 0 : 1;
    test::order(box);
    return box;
  }

  Discretization
  discretized_by_dealii(const test::Body &body)
  {
    MeshData mesh;
    mesh.source         = "test";
    mesh.vertices       = body.vertices;
    mesh.material_names = {"granite", "steel"};
    for (const LocalCell &cell : body.cells)
      {
        mesh.cells.push_back(cell.vertices);
        mesh.cell_tags.push_back(mesh.cells.size());
        mesh.cell_materials.push_back(cell.material);
      }
    return discretize(
      *make_triangulation(mesh,
                          std::vector<int>(mesh.cells.size(), 0),
                          MPI_COMM_SELF),
      densities,
      Communicator());
  }
} // namespace

TEST(Discretize, CellsAreThoseOfTheMesh)
{
  const test::Body     body     = make_body();
  const Discretization result   = discretized_by_dealii(body);
  const Topology      &topology = result.topology;
  ASSERT_EQ(topology.n_cells(), body.cells.size());
  ASSERT_EQ(topology.n_nodes(), body.vertices.size());
  for (const LocalCell &cell : body.cells)
    {
      const CellIndex slot = topology.find_cell(cell.global_index);
      ASSERT_NE(slot, invalid_index);
      EXPECT_EQ(topology.material(slot), cell.material);
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          const NodeIndex node = topology.node(slot, c);
          for (unsigned int d = 0; d < dim; ++d)
            EXPECT_EQ(result.state.reference[node][d],
                      body.vertices[cell.vertices[c]][d]);
        }
    }
}

// Cells of the same shape, at places that no binary number has, whatever the
// cell before: other ranks see other cells.
TEST(Discretize, CellsDoNotDependOnOthers)
{
  test::Body body = test::make_box({{4, 3, 3}}, .1 / 3, 0.);
  test::order(body);
  const Discretization whole = discretized_by_dealii(body);
  std::mt19937         random(1);
  for (unsigned int run = 0; run < 10; ++run)
    {
      test::Body part = body;
      std::shuffle(part.cells.begin(), part.cells.end(), random);
      part.cells.resize(part.cells.size() / 3);
      test::order(part);
      const Discretization result = discretized_by_dealii(part);
      // Found again by their corners, which keep their places.
      unsigned int n_same = 0;
      for (const LocalCell &cell : part.cells)
        for (const LocalCell &other : body.cells)
          {
            bool is_same = true;
            for (unsigned int c = 0; c < n_corners; ++c)
              is_same &= part.vertices[cell.vertices[c]] ==
                         body.vertices[other.vertices[c]];
            if (!is_same)
              continue;
            ++n_same;
            const CellIndex a = result.topology.find_cell(cell.global_index);
            const CellIndex b = whole.topology.find_cell(other.global_index);
            EXPECT_EQ(result.reference[a / batch_size].volume[a % batch_size],
                      whole.reference[b / batch_size].volume[b % batch_size]);
            for (unsigned int c = 0; c < n_corners; ++c)
              EXPECT_EQ(
                result.reference[a / batch_size].gradient(c, a % batch_size),
                whole.reference[b / batch_size].gradient(c, b % batch_size));
          }
      EXPECT_EQ(n_same, part.cells.size());
    }
}

TEST(Discretize, GradientsVolumesAndMasses)
{
  const test::Body         body     = make_body();
  const Discretization     result   = discretized_by_dealii(body);
  const test::DiscreteBody expected = test::discretize(body, densities);
  ASSERT_EQ(result.topology.n_cell_slots(), expected.topology.n_cell_slots());
  const double volume = 1e-6 / 6, gradient = 100;
  for (std::size_t b = 0; b < expected.reference.size(); ++b)
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      {
        EXPECT_NEAR(result.reference[b].volume[lane],
                    expected.reference[b].volume[lane],
                    1e-13 * volume);
        for (unsigned int c = 0; c < n_corners; ++c)
          EXPECT_LT(norm(result.reference[b].gradient(c, lane) -
                         expected.reference[b].gradient(c, lane)),
                    1e-12 * gradient);
      }

  double mass = 0, exact_mass = 0;
  for (const LocalCell &cell : body.cells)
    {
      const auto &x = body.vertices;
      const auto &v = cell.vertices;
      exact_mass += densities[cell.material] *
                    test::signed_volume(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
    }
  for (const double m : result.state.mass)
    {
      EXPECT_GT(m, 0);
      mass += m;
    }
  EXPECT_NEAR(mass, exact_mass, 1e-13 * exact_mass);
  EXPECT_NEAR(exact_mass, .03 * .02 * (.02 * 2641 + .02 * 7850), .2 * mass);
}
