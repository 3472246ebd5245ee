#include <gtest/gtest.h>

#include <rift/material/elasticity.h>
#include <rift/material/strength_field.h>

#include <map>
#include <random>

#include "bonded_body.h"

using namespace rift;
using namespace rift::test;

namespace
{
  /** Two materials of different friction, which counts up to the tensile
   * strength. */
  std::vector<MaterialParameters>
  granites()
  {
    std::vector<MaterialParameters> materials = {granite(), granite()};
    materials[0].friction_angle               = 10 * M_PI / 180;
    materials[1].friction_angle               = 50 * M_PI / 180;
    materials[0].tensile_strength             = materials[1].tensile_strength =
      DirectionalValue(30e6);
    return materials;
  }

  MaterialParameters
  scattered_granite(const double modulus, const double correlation_length)
  {
    MaterialParameters material = granite();
    material.weibull_modulus    = modulus;
    material.correlation_length = correlation_length;
    return material;
  }

  /** Of two materials, under uniform stresses of all kinds. */
  void
  expect_cells_at_their_strength_are_hot(
    const std::vector<MaterialParameters> &materials)
  {
    Body body = make_box({{2, 1, 1}}, 1e-3);
    for (std::size_t i = 0; i < body.cells.size(); ++i)
      body.cells[i].material = i < body.cells.size() / 2 ? 0 : 1;
    BondedBody         bonded(body, materials);
    const Topology    &topology = bonded.topology;
    const StressBounds bounds = bonded.strengths.stress_bounds(Communicator());
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
        const auto              second =
          bonded.internal_force.stress(bonded.state, 0).second;
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
} // namespace

// A vertex at its strength has a cell that is looked at, also where materials of
// different friction meet.
TEST(NodeStrengths, CellsAtTheirStrengthAreHot)
{
  expect_cells_at_their_strength_are_hot(granites());
}

TEST(NodeStrengths, CellsAtTheirScatteredStrengthAreHot)
{
  std::vector<MaterialParameters> materials = granites();
  materials[0].weibull_modulus              = 3;
  materials[0].correlation_length           = .5e-3;
  expect_cells_at_their_strength_are_hot(materials);
  materials[1].weibull_modulus    = 5;
  materials[1].correlation_length = 2e-3;
  expect_cells_at_their_strength_are_hot(materials);
}

// Only cells with weak vertices are looked at.
TEST(NodeStrengths, BoundsAreThoseOfTheWeakestVertexOfACell)
{
  const BondedBody    bonded(make_box({{3, 3, 3}}, 1e-3),
                          {scattered_granite(4, 1e-3)});
  const StressBounds  bounds = bonded.strengths.stress_bounds(Communicator());
  const StrengthField field(1, 1e-3, 4);
  for (CellIndex cell = 0; cell < bonded.topology.n_cell_slots(); ++cell)
    if (!bonded.topology.is_padding(cell))
      {
        double weakest = 1e30;
        for (unsigned int c = 0; c < n_corners; ++c)
          weakest = std::min(
            weakest,
            field.factor(
              bonded.state.reference[bonded.topology.node(cell, c)].vector()));
        EXPECT_EQ(bounds.factors[cell / batch_size][cell % batch_size],
                  weakest);
      }
}

// One factor for both strengths, in all directions; friction and fracture
// energies do not scatter.
TEST(NodeStrengths, ScatterIsOneFactorOfBothStrengths)
{
  MaterialParameters material = scattered_granite(4, 1e-3);
  for (const bool is_directional : {false, true})
    {
      if (is_directional)
        material.tensile_strength = {5e6, 10e6, 20e6};
      const BondedBody    bonded(make_box({{2, 2, 2}}, 1e-3), {material});
      const StrengthField field(1, 1e-3, 4);
      for (VertexIndex vertex = 0; vertex < bonded.topology.n_vertices();
           ++vertex)
        for (const Vector3<double> normal :
             {Vector3<double>{{1, 0, 0}}, Vector3<double>{{0, .6, .8}}})
          {
            const double factor =
              field.factor(bonded.state.reference[vertex].vector());
            const FaceStrength mean = strength_across(material, normal);
            const FaceStrength s    = bonded.strengths.strength(vertex, normal);
            EXPECT_EQ(s.tensile_strength, mean.tensile_strength * factor);
            EXPECT_EQ(s.cohesion, mean.cohesion * factor);
            EXPECT_EQ(s.tan_friction_angle, mean.tan_friction_angle);
            EXPECT_EQ(s.fracture_energy_1, mean.fracture_energy_1);
            EXPECT_EQ(s.fracture_energy_2, mean.fracture_energy_2);
            // A pull along the normal at the strength.
            SymmetricTensor<double> pull;
            for (unsigned int i = 0; i < pull.size(); ++i)
              pull[i] = i < 3 ? s.tensile_strength : 0;
            if (!is_directional)
              {
                EXPECT_NEAR(bonded.strengths.largest_demand(vertex, pull),
                            1,
                            1e-12);
              }
          }
    }
}

// Where materials meet, the one of more scatter decides.
TEST(NodeStrengths, SmallestModulusDecidesBetweenMaterials)
{
  Body body = make_box({{2, 1, 1}}, 1e-3);
  for (std::size_t i = 0; i < body.cells.size(); ++i)
    body.cells[i].material = i < body.cells.size() / 2 ? 0 : 1;
  for (const double modulus : {0., 9.})
    {
      const BondedBody bonded(
        body,
        {scattered_granite(modulus, 2e-3), scattered_granite(4, 1e-3)});
      const StrengthField first(1, 2e-3, 9), second(1, 1e-3, 4);
      for (VertexIndex vertex = 0; vertex < bonded.topology.n_vertices();
           ++vertex)
        {
          const Vector3<double> place = bonded.state.reference[vertex].vector();
          const double factor = place[0] > .5e-3 ? second.factor(place) :
                                modulus > 0      ? first.factor(place) :
                                                   1;
          EXPECT_EQ(bonded.strengths.strength(vertex, {{1, 0, 0}}).cohesion,
                    granite().cohesion.smallest() * factor);
        }
    }
}

TEST(NodeStrengths, AreTheSameAtTheSamePlaceOfAnotherMesh)
{
  // Powers of two, so that places are the same to the last bit.
  constexpr double         size = 1. / 64;
  const MaterialParameters rock = scattered_granite(5, .7 * size);
  const BondedBody         coarse(make_box({{2, 2, 2}}, size), {rock});
  const BondedBody         fine(make_box({{4, 4, 4}}, size / 2), {rock});
  std::map<Vector3<double>, double> known;
  for (VertexIndex v = 0; v < coarse.topology.n_vertices(); ++v)
    known[coarse.state.reference[v].vector()] =
      coarse.strengths.strength(v, {{1, 0, 0}}).tensile_strength;
  unsigned int n_shared = 0;
  for (VertexIndex v = 0; v < fine.topology.n_vertices(); ++v)
    if (const auto place = known.find(fine.state.reference[v].vector());
        place != known.end())
      {
        ++n_shared;
        EXPECT_EQ(fine.strengths.strength(v, {{1, 0, 0}}).tensile_strength,
                  place->second);
      }
  EXPECT_EQ(n_shared, 27u);
}

TEST(NodeStrengths, WarnOfLengthsThatTheMeshDoesNotResolve)
{
  const Body body          = make_box({{2, 2, 2}}, 1e-3);
  const auto warnings_with = [&](const double modulus, const double length) {
    const BondedBody bonded(body, {scattered_granite(modulus, length)});
    return bonded.strengths.warnings(bonded.state.reference, Communicator());
  };
  // Cubes are divided into tetrahedra whose mean edge is 1.3 mm.
  EXPECT_EQ(warnings_with(5, 2.3e-3).size(), 1u);
  EXPECT_NE(warnings_with(5, 2.3e-3)[0].find("0.0023 m is shorter"),
            std::string::npos);
  EXPECT_TRUE(warnings_with(5, 2.9e-3).empty());
  EXPECT_TRUE(warnings_with(0, 0).empty());
}
