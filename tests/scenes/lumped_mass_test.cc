// The lumped mass against the row sums of deal.II's consistent mass matrix.

#include <rift/discretization/discretize.h>
#include <rift/mesh/cell_ordering.h>
#include <rift/mesh/gmsh_reader.h>
#include <rift/mesh/triangulation.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe.h>

#include <gtest/gtest.h>

#include <map>

using namespace rift;

TEST(LumpedMass, RowSumsOfTheConsistentMassMatrix)
{
  MeshParameters parameters;
  parameters.shape           = MeshParameters::Shape::cylinder;
  parameters.cylinder_radius = 19e-3;
  parameters.cylinder_length = 60e-3;
  parameters.element_size    = 8e-3;
  MeshData mesh              = read_mesh(parameters);
  // Two materials, so that nodes between them have a part of each.
  mesh.material_names = {"light", "heavy"};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    mesh.cell_materials[c] = mesh.vertices[mesh.cells[c][0]][0] > 30e-3;
  order_cells(mesh);
  const std::vector<double> densities = {2000, 5000};

  const auto triangulation =
    make_triangulation(mesh,
                       std::vector<int>(mesh.cells.size(), 0),
                       MPI_COMM_SELF);
  const auto discretization =
    discretize(*triangulation, densities, Communicator());

  const dealii::FE_SimplexP<dim>            fe(1);
  const dealii::MappingFE<dim>              mapping(fe);
  const dealii::QGaussSimplex<dim>          quadrature(2);
  dealii::FEValues<dim>                     values(mapping,
                               fe,
                               quadrature,
                               dealii::update_values |
                                 dealii::update_JxW_values);
  std::map<std::array<double, dim>, double> row_sums;
  double                                    total = 0;
  for (const auto &cell : triangulation->active_cell_iterators())
    {
      values.reinit(cell);
      for (unsigned int i = 0; i < n_corners; ++i)
        for (unsigned int j = 0; j < n_corners; ++j)
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const auto  &x = cell->vertex(i);
              const double m = densities[cell->material_id()] *
                               values.shape_value(i, q) *
                               values.shape_value(j, q) * values.JxW(q);
              row_sums[{{x[0], x[1], x[2]}}] += m;
              total += m;
            }
    }

  const State &state = discretization.state;
  ASSERT_EQ(state.n_nodes(), row_sums.size());
  double sum = 0;
  for (std::size_t i = 0; i < state.n_nodes(); ++i)
    {
      const auto x       = state.reference[i].vector();
      const auto row_sum = row_sums.find({{x[0], x[1], x[2]}});
      ASSERT_NE(row_sum, row_sums.end()) << "node " << i;
      EXPECT_NEAR(state.mass[i] / row_sum->second, 1, 1e-12) << "node " << i;
      sum += state.mass[i];
    }
  EXPECT_NEAR(sum / total, 1, 1e-12);
}
