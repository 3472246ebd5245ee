// The transversely isotropic law, from a scene to its stiffness.

#include <rift/app/parameters.h>
#include <rift/material/elasticity.h>

#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <fstream>

using namespace rift;

namespace
{
  constexpr double e1 = 40e9, e3 = 25e9, nu12 = .2, nu31 = .15, g = 12e9;

  MaterialParameters
  slate(const std::string &more = "")
  {
    const TemporaryDirectory directory;
    const std::string        scene = directory / "scene.prm";
    std::ofstream(scene) << "subsection Mesh\n"
                            "  set Shape = box\n"
                            "  set Box size = 1, 1, 1\n"
                            "  set Element size = 0.5\n"
                            "  set Material = slate\n"
                            "end\n"
                            "subsection Material slate\n"
                            "  set Density = 2700\n"
                            "  set Elasticity = transversely isotropic\n"
                            "  set Young's modulus along = 40e9\n"
                            "  set Young's modulus across = 25e9\n"
                            "  set Poisson's ratio along = 0.2\n"
                            "  set Poisson's ratio across = 0.15\n"
                            "  set Shear modulus across = 12e9\n"
                         << more
                         << "end\n"
                            "subsection Time\n"
                            "  set End time = 1e-6\n"
                            "end\n";
    return read_parameters(scene).materials.at(0);
  }
} // namespace

TEST(TransverselyIsotropic, StressAlongOneAxisGivesItsConstants)
{
  const StiffnessMatrix c = stiffness_in_material_axes(slate());
  // Strains of a uniaxial stress of 1 Pa across and along the bedding.
  const std::array<double, 3> across = {{-nu31 / e3, -nu31 / e3, 1 / e3}};
  const std::array<double, 3> along  = {{1 / e1, -nu12 / e1, -nu31 / e3}};
  for (unsigned int i = 0; i < 3; ++i)
    {
      double of_across = 0, of_along = 0;
      for (unsigned int j = 0; j < 3; ++j)
        {
          of_across += c[i][j] * across[j];
          of_along += c[i][j] * along[j];
        }
      EXPECT_NEAR(of_across, i == 2, 1e-14);
      EXPECT_NEAR(of_along, i == 0, 1e-14);
    }
  EXPECT_EQ(c[3][3], g);
  EXPECT_EQ(c[4][4], g);
  EXPECT_NEAR(c[5][5], .5 * (c[0][0] - c[0][1]), 1e-4);
}

TEST(TransverselyIsotropic, BeddingLiesAcrossAxisThree)
{
  // Axis 3 along x of the mesh.
  const auto law =
    make_elasticity(slate("  set Axis 1 = 0, 1, 0\n  set Axis 2 = 0, 0, 1\n"));
  const StiffnessMatrix own  = stiffness_in_material_axes(slate());
  const StiffnessMatrix mesh = stiffness_matrix(law);
  EXPECT_NEAR(mesh[0][0], own[2][2], 1e-4);
  EXPECT_NEAR(mesh[1][1], own[0][0], 1e-4);
  EXPECT_NEAR(mesh[3][3], own[5][5], 1e-4);
  EXPECT_NEAR(mesh[5][5], own[3][3], 1e-4);
}

TEST(TransverselyIsotropic, RefusesWhatStoresNegativeEnergy)
{
  MaterialParameters material                             = slate();
  material.elastic_constants.at("Poisson's ratio across") = .6;
  try
    {
      material.check();
      FAIL();
    }
  catch (const ParameterError &error)
    {
      EXPECT_EQ(error.name, "Young's modulus along");
      EXPECT_NE(error.problem.find("not positive definite"), std::string::npos);
    }
}
