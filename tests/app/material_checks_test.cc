#include <rift/material/material_parameters.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using rift::MaterialParameters;

  MaterialParameters
  granite()
  {
    MaterialParameters result;
    result.name              = "granite";
    result.density           = 2641;
    result.youngs_modulus    = 40.6e9;
    result.poissons_ratio    = 0.2;
    result.tensile_strength  = 15e6;
    result.cohesion          = 36.7e6;
    result.friction_angle    = 50 * M_PI / 180;
    result.fracture_energy_1 = 400;
    result.fracture_energy_2 = 400;
    return result;
  }

  // Stiffness of an isotropic material, of given moduli of compression and
  // shear: in Kelvin's form its eigenvalues are 3 K once and 2 G five times.
  MaterialParameters
  with_moduli(const double K, const double G)
  {
    MaterialParameters result = granite();
    result.elasticity         = MaterialParameters::Elasticity::anisotropic;
    const double a = K + 4. / 3 * G, b = K - 2. / 3 * G;
    result.stiffness = {
      {a, b, b, 0, 0, 0, a, b, 0, 0, 0, a, 0, 0, 0, G, 0, 0, G, 0, G}};
    return result;
  }

  // What check() says, or nothing.
  std::string
  problem(const MaterialParameters &material)
  {
    try
      {
        material.check();
        material.check_breakable();
        return "";
      }
    catch (const rift::ParameterError &error)
      {
        EXPECT_EQ(error.section, "Material granite");
        return error.name + ": " + error.problem;
      }
  }
} // namespace

TEST(MaterialChecks, GraniteIsFine)
{
  EXPECT_EQ(problem(granite()), "");
  EXPECT_EQ(problem(with_moduli(22e9, 17e9)), "");
}

TEST(MaterialChecks, BoundsOfDensityAndWaveSpeed)
{
  MaterialParameters material = granite();
  for (const double density : {500., 25000.})
    {
      material.density = density;
      EXPECT_EQ(problem(material), "");
    }
  for (const double density : {499., 25001., -2641., double(NAN)})
    {
      material.density = density;
      EXPECT_EQ(problem(material),
                "Density: a density is between 500 and 25000 kg/m^3.");
    }

  // With nu = 0 the modulus of P-waves is E: 100 and 15000 m/s are the ends.
  material                  = granite();
  material.density          = 1000;
  material.poissons_ratio   = 0;
  material.breakable        = false;
  material.tensile_strength = material.cohesion = 0;
  for (const auto &[speed, is_good] : {std::make_pair(99.9, false),
                                       std::make_pair(100.1, true),
                                       std::make_pair(14990., true),
                                       std::make_pair(15010., false)})
    {
      material.youngs_modulus = material.density * speed * speed;
      EXPECT_EQ(problem(material).empty(), is_good) << speed;
    }
}

TEST(MaterialChecks, SmallestEigenvalue)
{
  // Bounds of a stable isotropic material: K > 0 and G > 0.
  EXPECT_EQ(problem(with_moduli(1e9, 17e9)), "");
  EXPECT_NE(problem(with_moduli(-1e9, 17e9)).find("eigenvalue is -3e+09 Pa"),
            std::string::npos);
  EXPECT_NE(problem(with_moduli(22e9, -2e9)).find("eigenvalue is -4e+09 Pa"),
            std::string::npos);
  EXPECT_NE(problem(with_moduli(0, 17e9)).find("not positive definite"),
            std::string::npos);

  // The full 6x6 case: adding v v^T with v = (1, 2, 3, 4, 5, 6) 1e5 to a
  // stable stiffness keeps it so; subtracting enough of it does not. The
  // eigenvalue of S - x w w^T with w orthogonal to nothing lies below
  // 2 G - (share of w that is a shear) x |w|^2, here checked by its sign.
  for (const double sign : {1., -1.})
    {
      MaterialParameters material = with_moduli(34e9 / 3, 17e9);
      unsigned int       k        = 0;
      // 3 K = 2 G: the Kelvin matrix is 34e9 times the identity, so that the
      // smallest eigenvalue is 34e9 - 2e9 * |w|^2 exactly.
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = i; j < 6; ++j, ++k)
          material.stiffness[k] +=
            sign * 2e9 * (i + 1.) * (j + 1.) /
            ((i < 3 ? 1 : M_SQRT2) * (j < 3 ? 1 : M_SQRT2));
      // |w|^2 = 1 + 4 + 9 + 16 + 25 + 36 = 91, and 34 - 182 = -148.
      if (sign > 0)
        EXPECT_EQ(problem(material), "");
      else
        EXPECT_NE(problem(material).find("eigenvalue is -1.48e+11 Pa"),
                  std::string::npos)
          << problem(material);
    }
}

TEST(MaterialChecks, Axes)
{
  MaterialParameters material = with_moduli(22e9, 17e9);
  material.axis_1             = {{1, 1, 0}};
  material.axis_2             = {{0, 1e-3, 0}};
  EXPECT_EQ(problem(material), "");
  material.axis_2 = {{2, 2, 1e-7}};
  EXPECT_EQ(problem(material), "Axis 2: this is parallel to Axis 1.");
}

TEST(MaterialChecks, Strength)
{
  MaterialParameters material = granite();
  material.friction_angle     = 80 * M_PI / 180;
  EXPECT_EQ(problem(material), "");
  material.friction_angle = -0.01;
  EXPECT_EQ(problem(material),
            "Friction angle: this must be between 0 and 80 degrees. Steeper "
            "friction is not covered by the bound of the time step.");

  // What does not break needs no strength.
  material.friction_angle   = 0;
  material.tensile_strength = 0;
  EXPECT_NE(problem(material), "");
  material.breakable = false;
  EXPECT_EQ(problem(material), "");
}

TEST(MaterialChecks, StrengthByDirection)
{
  MaterialParameters material = granite();
  material.tensile_strength   = {15e6, 10e6, 8e6};
  EXPECT_EQ(problem(material), "");
  material.axis_2 = {{2, 0, 0}};
  EXPECT_EQ(problem(material), "Axis 2: this is parallel to Axis 1.");
  material.axis_2            = {{0, 1, 0}};
  material.fracture_energy_2 = {400, 0, 300};
  EXPECT_EQ(problem(material),
            "Fracture energy II: this must be greater than zero where cracks "
            "may run. Set it, or Breakable = false.");
  material.fracture_energy_2 = 400;
  material.cohesion          = {30e6, 30e6, -1};
  EXPECT_EQ(problem(material), "Cohesion: this cannot be negative.");
  material.cohesion = {36.7, 30e6, 30e6};
  EXPECT_EQ(problem(material).substr(0, 40),
            "Cohesion: this is 9.039e-10 of the modul");
  material.cohesion = {30e6, 41e9, 30e6};
  EXPECT_EQ(problem(material).substr(0, 40),
            "Cohesion: this is more than the modulus ");
}

TEST(MaterialChecks, StrengthInAnotherUnit)
{
  MaterialParameters material = granite();
  material.tensile_strength   = 15;
  EXPECT_EQ(problem(material),
            "Tensile strength: this is 3.695e-10 of the modulus of elasticity; "
            "no rock, glass or metal is so weak. Is it in MPa? rift uses Pa: "
            "write 1.5e+07.");
  material.tensile_strength = 41e9;
  EXPECT_EQ(problem(material),
            "Tensile strength: this is more than the modulus of elasticity, "
            "4.06e+10 Pa; no rock, glass or metal is so strong. Is one of the "
            "two in another "
            "unit? rift uses Pa.");
  for (const double strength : {4.1e3, 40e9})
    {
      material.tensile_strength = material.cohesion = strength;
      EXPECT_EQ(problem(material), "") << strength;
    }
  material.cohesion = 36.7;
  EXPECT_EQ(problem(material).substr(0, 40),
            "Cohesion: this is 9.039e-10 of the modul");

  // The largest entry of the stiffness is 36 GPa.
  material                  = with_moduli(20e9, 12e9);
  material.tensile_strength = 3.5e3;
  EXPECT_EQ(problem(material).substr(0, 42),
            "Tensile strength: this is 9.722e-08 of the");
  material.tensile_strength = 3.7e3;
  EXPECT_EQ(problem(material), "");
}

TEST(MaterialChecks, FractureEnergyInAnotherUnit)
{
  MaterialParameters material = granite();
  material.fracture_energy_1  = 1;
  EXPECT_TRUE(material.warnings().empty());
  material.fracture_energy_2 = .4;
  ASSERT_EQ(material.warnings().size(), 1u);
  EXPECT_EQ(
    material.warnings()[0],
    "Material granite/Fracture energy II = 0.4 is less than rock, glass "
    "and metal have. Is it in N/mm or kJ/m^2? rift uses J/m^2.");
}

TEST(MaterialChecks, InertEntries)
{
  using Elasticity            = MaterialParameters::Elasticity;
  MaterialParameters material = granite();
  const auto         is_inert = [&material](const std::string &name) {
    for (const auto &entries : material.inert_entries())
      for (const std::string &entry : entries.names)
        if (entry == name)
          return true;
    return false;
  };
  const std::vector<std::string> names = {"Young's modulus",
                                          "Stiffness",
                                          "Axis 2",
                                          "Cohesion",
                                          "Breakable",
                                          "Viscosity",
                                          "Velocity y",
                                          "Initial velocity",
                                          "Density"};
  const auto expect_inert = [&](const std::vector<std::string> &expected) {
    std::vector<std::string> found;
    for (const std::string &name : names)
      if (is_inert(name))
        found.push_back(name);
    EXPECT_EQ(found, expected);
  };
  expect_inert({"Stiffness", "Axis 2", "Velocity y"});
  material.cohesion = {1e6, 2e6, 3e6};
  expect_inert({"Stiffness", "Velocity y"});
  material.breakable = false;
  expect_inert({"Stiffness", "Axis 2", "Cohesion", "Velocity y"});
  material.breakable  = true;
  material.elasticity = Elasticity::anisotropic;
  material.breakable  = false;
  expect_inert({"Young's modulus", "Cohesion", "Velocity y"});
  material.elasticity = Elasticity::rigid;
  expect_inert({"Young's modulus",
                "Stiffness",
                "Axis 2",
                "Cohesion",
                "Breakable",
                "Viscosity"});
}
