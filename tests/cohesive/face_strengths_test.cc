#include "breaking_body.h"
#include <gtest/gtest.h>

#include <map>

using namespace rift;
using namespace rift::test;

namespace
{
  MaterialParameters
  other_rock()
  {
    MaterialParameters material = granite();
    material.tensile_strength   = 20e6;
    material.cohesion           = 30e6;
    material.friction_angle     = .5;
    material.fracture_energy_1  = 300;
    material.fracture_energy_2  = 700;
    return material;
  }

  constexpr Vector3<double> tensile    = {{15e6, 10e6, 8e6}};
  constexpr Vector3<double> cohesions  = {{40e6, 35e6, 30e6}};
  constexpr Vector3<double> energies_1 = {{100, 75, 50}};
  constexpr Vector3<double> energies_2 = {{200, 120, 100}};

  /** In slanted axes. */
  MaterialParameters
  directional_granite()
  {
    MaterialParameters material = granite();
    material.tensile_strength   = {tensile[0], tensile[1], tensile[2]};
    material.cohesion           = {cohesions[0], cohesions[1], cohesions[2]};
    material.fracture_energy_1  = {energies_1[0], energies_1[1], energies_1[2]};
    material.fracture_energy_2  = {energies_2[0], energies_2[1], energies_2[2]};
    material.axis_1             = {{1, .5, -.25}};
    material.axis_2             = {{0, 3, 1}};
    return material;
  }

  /** A box whose right half is of material 1. */
  Body
  two_halves(const unsigned int n)
  {
    Body body = make_box({n, n, n});
    for (LocalCell &cell : body.cells)
      {
        double centre = 0;
        for (const VertexIndex v : cell.vertices)
          centre += .25 * body.vertices[v][0];
        cell.material = centre > .5 * n;
      }
    return body;
  }

  MaterialParameters
  scattered_granite(const double modulus)
  {
    MaterialParameters material = granite();
    material.weibull_modulus    = modulus;
    return material;
  }

  /** Strength over that without scatter of all faces. */
  std::vector<double>
  factors(const Topology    &topology,
          const double       modulus,
          const unsigned int seed = 1)
  {
    CohesiveParameters parameters;
    parameters.seed = seed;
    const ReferenceCellData unused;
    const FaceStrengths     strengths(topology,
                                  unused,
                                  {scattered_granite(modulus)},
                                  parameters);
    std::vector<double>     result;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      {
        const FaceStrength s = strengths.strength(face);
        result.push_back(s.tensile_strength /
                         granite_strength().tensile_strength);
        EXPECT_NEAR(s.cohesion / granite_strength().cohesion,
                    result.back(),
                    1e-14);
        EXPECT_EQ(s.fracture_energy_1, granite_strength().fracture_energy_1);
        EXPECT_EQ(s.fracture_energy_2, granite_strength().fracture_energy_2);
      }
    return result;
  }

  Topology
  box_topology(const unsigned int n)
  {
    return discretize(make_box({n, n, n}), {1.}).topology;
  }
} // namespace

TEST(FaceStrengths, InterfaceTakesTheWeaker)
{
  const DiscreteBody body = discretize(two_halves(4), {1., 1.});
  const std::vector<MaterialParameters> materials = {granite(), other_rock()};
  const FaceStrengths strengths(body.topology, body.reference, materials, {});
  unsigned int        n_faces[3] = {0, 0, 0};
  for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
    {
      const Face        &f = body.topology.faces[face];
      const unsigned int pair =
        body.topology.material(f.cells[0]) + body.topology.material(f.cells[1]);
      ++n_faces[pair];
      const FaceStrength s = strengths.strength(face);
      ASSERT_TRUE(strengths.is_breakable(face));
      if (pair == 1)
        {
          EXPECT_EQ(s.tensile_strength, 15e6);
          EXPECT_EQ(s.cohesion, 30e6);
          EXPECT_NEAR(s.tan_friction_angle, std::tan(.5), 1e-15);
          EXPECT_EQ(s.fracture_energy_1, 300);
          EXPECT_EQ(s.fracture_energy_2, 600);
        }
      else
        {
          const FaceStrength m =
            strength_across(materials[pair / 2], {{0, 1, 0}});
          EXPECT_EQ(s.tensile_strength, m.tensile_strength);
          EXPECT_EQ(s.cohesion, m.cohesion);
          EXPECT_EQ(s.tan_friction_angle, m.tan_friction_angle);
          EXPECT_EQ(s.fracture_energy_1, m.fracture_energy_1);
          EXPECT_EQ(s.fracture_energy_2, m.fracture_energy_2);
        }
    }
  EXPECT_EQ(n_faces[1], 32u);
  EXPECT_GT(n_faces[0], 100u);
  EXPECT_GT(n_faces[2], 100u);
}

TEST(FaceStrengths, BoundsLieBelowAllFaces)
{
  const DiscreteBody body = discretize(two_halves(4), {1., 1.});
  MaterialParameters hard = other_rock();
  hard.breakable          = false;
  for (const auto &second : {other_rock(), hard})
    {
      auto first            = granite();
      first.weibull_modulus = 3;
      const FaceStrengths strengths(body.topology,
                                    body.reference,
                                    {first, second},
                                    {});
      const StressBounds  bounds = strengths.stress_bounds(Communicator());
      ASSERT_EQ(bounds.materials.size(), 2u);
      EXPECT_EQ(bounds.materials[1].has_value(), second.breakable);
      ASSERT_EQ(bounds.factors.size(), body.topology.n_batches());
      for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
        for (const CellIndex cell : body.topology.faces[face].cells)
          {
            if (!strengths.is_breakable(face))
              continue;
            const auto  &bound = bounds.materials[body.topology.material(cell)];
            const double factor =
              bounds.factors[cell / batch_size][cell % batch_size];
            const auto s = strengths.strength(face);
            ASSERT_TRUE(bound);
            EXPECT_LT(factor * bound->tensile_strength, s.tensile_strength);
            EXPECT_LT(factor * bound->cohesion, s.cohesion);
            EXPECT_LE(bound->tan_friction_angle, s.tan_friction_angle);
          }
    }
}

// The bound of a cell is that of its own weakest face, not of the whole body.
TEST(FaceStrengths, ScatteredBoundsAreThoseOfTheWeakestFaces)
{
  const DiscreteBody  body = discretize(make_box({4, 4, 4}), {1.});
  const FaceStrengths strengths(body.topology,
                                body.reference,
                                {scattered_granite(5)},
                                {});
  const StressBounds  bounds = strengths.stress_bounds(Communicator());
  for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
    {
      if (body.topology.is_padding(cell))
        continue;
      double weakest = 1e30;
      for (const FaceIndex face : body.topology.cell_faces[cell])
        if (face != invalid_index)
          weakest =
            std::min(weakest, strengths.strength(face).tensile_strength);
      EXPECT_NEAR(bounds.factors[cell / batch_size][cell % batch_size] *
                    bounds.materials[0]->tensile_strength,
                  .9 * weakest,
                  1e-12 * weakest);
    }
}

TEST(StrengthAcross, IsThatOfEachAxis)
{
  const MaterialParameters material = directional_granite();
  const Matrix3<double> axes = material_axes(material.axis_1, material.axis_2);
  for (unsigned int i = 0; i < 3; ++i)
    for (const double sign : {1., -1.})
      {
        const FaceStrength s = strength_across(material, sign * axes[i]);
        EXPECT_NEAR(s.tensile_strength / tensile[i], 1, 1e-15);
        EXPECT_NEAR(s.cohesion / cohesions[i], 1, 1e-15);
        EXPECT_NEAR(s.fracture_energy_1 / energies_1[i], 1, 1e-15);
        EXPECT_NEAR(s.fracture_energy_2 / energies_2[i], 1, 1e-15);
        EXPECT_EQ(s.tan_friction_angle, granite_strength().tan_friction_angle);
      }
}

TEST(StrengthAcross, BetweenTheAxes)
{
  const MaterialParameters material = directional_granite();
  const Matrix3<double> axes = material_axes(material.axis_1, material.axis_2);
  // (1, 1, 1) in material axes: the mean of the three.
  const FaceStrength mean =
    strength_across(material,
                    std::sqrt(1. / 3) * (axes[0] + axes[1] + axes[2]));
  EXPECT_NEAR(mean.tensile_strength, 11e6, 1e-8);
  EXPECT_NEAR(mean.cohesion, 35e6, 1e-7);
  EXPECT_NEAR(mean.fracture_energy_1, 75, 1e-12);
  EXPECT_NEAR(mean.fracture_energy_2, 140, 1e-12);
  // 30 degrees from axis 1 towards axis 3.
  const FaceStrength slanted =
    strength_across(material, std::sqrt(.75) * axes[0] + .5 * axes[2]);
  EXPECT_NEAR(slanted.tensile_strength, 13.25e6, 1e-8);
  EXPECT_NEAR(slanted.cohesion, 37.5e6, 1e-7);
  EXPECT_NEAR(slanted.fracture_energy_1, 87.5, 1e-12);
  EXPECT_NEAR(slanted.fracture_energy_2, 175, 1e-12);
}

TEST(StrengthAcross, EqualValuesAreIsotropicToTheLastBit)
{
  MaterialParameters material = granite();
  const double       strength = 15e6 / 7;
  material.tensile_strength   = {strength, strength, strength};
  material.axis_1             = {{1, 2, 3}};
  EXPECT_FALSE(material.has_directional_strength());
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (unsigned int sample = 0; sample < 100; ++sample)
    {
      const Vector3<double> n = {{number(random), number(random), .1}};
      EXPECT_EQ(strength_across(material, (1 / norm(n)) * n).tensile_strength,
                strength);
    }
}

// With normals from the vertices; between the materials, which have axes and
// values of their own, the weaker one.
TEST(FaceStrengths, FollowTheNormalsOfFaces)
{
  Body         shape = make_box({4, 4, 4}, 1, .2);
  std::mt19937 random(1);
  for (LocalCell &cell : shape.cells)
    cell.material = random() % 2;
  const DiscreteBody body                         = discretize(shape, {1., 1.});
  MaterialParameters other                        = directional_granite();
  other.tensile_strength                          = {6e6, 12e6, 15e6};
  other.axis_1                                    = {{0, 0, 2}};
  const std::vector<MaterialParameters> materials = {directional_granite(),
                                                     other};
  const FaceStrengths strengths(body.topology, body.reference, materials, {});
  const StressBounds  bounds = strengths.stress_bounds(Communicator());
  EXPECT_TRUE(bounds.factors.empty());
  unsigned int n_first[2] = {0, 0};
  for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
    {
      const Face     &f = body.topology.faces[face];
      Vector3<double> x[3];
      for (unsigned int c = 0; c < 3; ++c)
        x[c] =
          body.state
            .reference[body.topology.node(f.cells[0],
                                          face_corners[f.local_faces[0]][c])]
            .vector();
      Vector3<double> normal = cross(x[1] - x[0], x[2] - x[0]);
      normal                 = (1 / norm(normal)) * normal;
      double weakest         = 1e9;
      for (const CellIndex cell : f.cells)
        weakest = std::min(
          weakest,
          strength_across(materials[body.topology.material(cell)], normal)
            .tensile_strength);
      const FaceStrength s = strengths.strength(face);
      EXPECT_NEAR(s.tensile_strength / weakest, 1, 1e-13);
      for (const CellIndex cell : f.cells)
        {
          const auto &bound = bounds.materials[body.topology.material(cell)];
          EXPECT_LT(bound->tensile_strength, s.tensile_strength);
          EXPECT_LT(bound->cohesion, s.cohesion);
        }
      if (body.topology.material(f.cells[0]) !=
          body.topology.material(f.cells[1]))
        ++n_first[weakest ==
                  strength_across(materials[0], normal).tensile_strength];
    }
  EXPECT_GT(n_first[0], 50u);
  EXPECT_GT(n_first[1], 50u);
}

TEST(FaceStrengths, NothingScattersWithoutModulus)
{
  for (const double factor : factors(box_topology(3), 0))
    EXPECT_EQ(factor, 1);
}

TEST(FaceStrengths, ScatterIsWeibullOfMeanOne)
{
  const Topology topology = box_topology(14);
  for (const double modulus : {1.5, 4., 12.})
    for (const unsigned int seed : {1u, 2u, 77u})
      {
        auto         values = factors(topology, modulus, seed);
        const double n      = values.size();
        ASSERT_GT(n, 30000);
        const double gamma = std::tgamma(1 + 1 / modulus);
        const double deviation =
          std::sqrt(std::tgamma(1 + 2 / modulus) / (gamma * gamma) - 1);
        const double mean =
          std::accumulate(values.begin(), values.end(), 0.) / n;
        EXPECT_NEAR(mean, 1, 4 * deviation / std::sqrt(n));

        // Kolmogorov and Smirnov: beyond 1.95/sqrt(n) in 1 of 1000 samples.
        std::sort(values.begin(), values.end());
        double distance = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
          {
            const double law =
              1 - std::exp(-std::pow(gamma * values[i], modulus));
            distance = std::max(
              {distance, std::abs(law - i / n), std::abs(law - (i + 1) / n)});
          }
        EXPECT_LT(distance, 1.95 / std::sqrt(n));
      }
}

TEST(FaceStrengths, NeighbouringFacesAreIndependent)
{
  const Topology topology = box_topology(14);
  const auto     values   = factors(topology, 4);
  double         product = 0, square = 0;
  std::size_t    n = 0;
  for (CellIndex cell = 0; cell < topology.n_cells(); ++cell)
    {
      const FaceIndex a = topology.cell_faces[cell][0];
      const FaceIndex b = topology.cell_faces[cell][1];
      if (a == invalid_index || b == invalid_index)
        continue;
      product += (values[a] - 1) * (values[b] - 1);
      square += (values[a] - 1) * (values[a] - 1);
      ++n;
    }
  EXPECT_LT(std::abs(product / square), 4 / std::sqrt(n));
}

TEST(FaceStrengths, SeedChangesTheScatter)
{
  const Topology topology = box_topology(4);
  const auto     first    = factors(topology, 5, 1);
  EXPECT_EQ(first, factors(topology, 5, 1));
  const auto   second  = factors(topology, 5, 2);
  unsigned int n_equal = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    n_equal += first[i] == second[i];
  EXPECT_EQ(n_equal, 0u);
}

// A rank sees a part of the body, in other slots and with other vertices; the
// faces must be as strong as in the whole.
TEST(FaceStrengths, PartOfTheBodyHasTheSameScatter)
{
  Body body = make_box({4, 3, 3});
  order(body);
  const auto faces_of = [](const std::vector<LocalCell> &cells,
                           const std::size_t             n_vertices) {
    const Topology topology(cells, n_vertices);
    const auto     values = factors(topology, 5);
    std::map<std::pair<GlobalCellIndex, GlobalCellIndex>, double> result;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      {
        const auto &cell = topology.faces[face].cells;
        result[{topology.cell_global_indices[cell[0]],
                topology.cell_global_indices[cell[1]]}] = values[face];
      }
    return result;
  };
  const auto whole = faces_of(body.cells, body.vertices.size());

  std::vector<LocalCell> part;
  for (const LocalCell &cell : body.cells)
    if (cell.global_index % 5 != 0 && cell.global_index > 30)
      part.push_back(cell);
  for (LocalCell &cell : part)
    for (VertexIndex &v : cell.vertices)
      v = body.vertices.size() - 1 - v;
  const auto of_part = faces_of(part, body.vertices.size());
  EXPECT_GT(of_part.size(), 100u);
  EXPECT_LT(of_part.size(), whole.size());
  for (const auto &[cells, value] : of_part)
    EXPECT_EQ(value, whole.at(cells));
}
