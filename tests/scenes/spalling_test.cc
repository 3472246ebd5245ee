// The spalling test in small, against the one-dimensional theory, and what
// must not change its result.

#include "../temporary_directory.h"

#include <rift/app/simulation.h>
#include <rift/io/solution_fields.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

using namespace rift;

namespace
{
  /** Rows of numbers of a .csv. */
  std::vector<std::vector<double>>
  read_table(const std::string &path)
  {
    std::vector<std::vector<double>> rows;
    std::istringstream               file(read_file(path));
    std::string                      line;
    std::getline(file, line);
    while (std::getline(file, line))
      {
        rows.emplace_back();
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');)
          rows.back().push_back(std::stod(cell));
      }
    return rows;
  }

  const std::string faces = "Fracture/Cohesive law=faces";

  /** The scene of prm/spalling with coarse cells. */
  Parameters
  scene(std::vector<std::string> overrides = {})
  {
    overrides.insert(overrides.end(),
                     {"Mesh/Element size=6e-3", "Output/Solution interval=0"});
    return read_parameters(RIFT_SOURCE_DIRECTORY "/prm/spalling/spalling.prm",
                           overrides);
  }

  /** What is left of a run. */
  struct Outcome
  {
    /** Rows of time and velocity of the free end; rows of energy.csv. */
    std::vector<std::vector<double>> fspv, energy;

    std::string summary, state_hash;
  };

  Outcome
  run(Parameters parameters)
  {
    TemporaryDirectory directory;
    parameters.output.directory = directory / "results";
    Log        log(nullptr);
    Simulation simulation(parameters, log);
    simulation.run();
    return {read_table(directory / "results/probes.csv"),
            read_table(directory / "results/energy.csv"),
            read_file(directory / "results/summary.json"),
            state_hash(simulation.topology(), simulation.state())};
  }

  /** A number of summary.json. */
  double
  number(const Outcome &outcome, const std::string &key)
  {
    const auto at = outcome.summary.find("\"" + key + "\":");
    if (at == std::string::npos)
      throw std::runtime_error("no " + key + " in " + outcome.summary);
    return std::stod(outcome.summary.substr(at + key.size() + 3));
  }
} // namespace

TEST(Spalling, FreeSurfaceVelocityAndEnergy)
{
  const Outcome outcome = run(scene({faces}));

  // The 1-D reference: 7.73 m/s; with the speed of bar waves, 3920.8 m/s, half
  // of it is there after 180 mm and a sixth of the pulse of 60 us.
  double peak = 0, arrival = 0;
  for (const auto &row : outcome.fspv)
    peak = std::max(peak, row[1]);
  for (auto row = outcome.fspv.rbegin(); row != outcome.fspv.rend(); ++row)
    if ((*row)[1] >= .5 * peak)
      arrival = (*row)[0];
  EXPECT_NEAR(peak, 7.73, .03 * 7.73);
  EXPECT_NEAR(arrival, .18 / 3920.8 + 10e-6, .03 * (.18 / 3920.8 + 10e-6));

  double intact = 0, input = 0;
  for (const auto &row : outcome.energy)
    {
      input = std::max(input, row[8]);
      if (row[4] == 0 && row[3] == 0)
        intact = std::max(intact, std::abs(row[9]));
    }
  EXPECT_LE(intact, 1e-4 * input);
  EXPECT_GT(outcome.energy.back()[4], 0);
  EXPECT_LE(std::abs(outcome.energy.back()[9]), 2e-3 * input);
  EXPECT_LE(number(outcome, "energy_residual_relative"), 2e-3);
  EXPECT_NEAR(number(outcome, "time"), 200e-6, 1e-15);

  // Nothing is cut while all is in compression; in one dimension the first
  // tension that reaches the strength comes at 79.6 us.
  for (const auto &row : outcome.energy)
    {
      EXPECT_TRUE(row[0] > 76e-6 || row[3] == 0) << "at " << row[0] << " s";
    }
  EXPECT_GT(number(outcome, "faces_broken"), 0);
}

// Until some time after the first cuts.
const std::string short_end = "Time/End time=100e-6";

TEST(Spalling, RunsAreRepeatable)
{
  const Outcome first  = run(scene({faces, short_end}));
  const Outcome second = run(scene({faces, short_end}));
  EXPECT_GT(number(first, "faces_inserted"), 0);
  EXPECT_EQ(first.state_hash, second.state_hash);
  EXPECT_EQ(first.fspv, second.fspv);
}

TEST(Spalling, WeibullScatter)
{
  const std::string modulus = "Material granite/Weibull modulus=10";
  const Outcome     first =
    run(scene({faces, short_end, modulus, "Fracture/Seed=1"}));
  const Outcome second =
    run(scene({faces, short_end, modulus, "Fracture/Seed=2"}));
  EXPECT_GT(number(first, "faces_inserted"), 0);
  EXPECT_LE(number(first, "energy_residual_relative"), 2e-3);
  EXPECT_NE(first.state_hash, second.state_hash);
}

TEST(Spalling, IsotropicTensorGivenAsAnisotropic)
{
  // Until the first cut: afterwards the smallest difference decides which of
  // two equal faces opens first.
  const std::string end        = "Time/End time=76e-6";
  Parameters        parameters = scene({end});
  const Outcome     isotropic  = run(parameters);

  MaterialParameters &material = parameters.materials[0];
  const double        E = material.youngs_modulus, nu = material.poissons_ratio;
  const double        mu = E / (2 * (1 + nu));
  const double        l = E * nu / ((1 + nu) * (1 - 2 * nu)), p = l + 2 * mu;
  material.elasticity = MaterialParameters::Elasticity::anisotropic;
  material.stiffness  = {
     {p, l, l, 0, 0, 0, p, l, 0, 0, 0, p, 0, 0, 0, mu, 0, 0, mu, 0, mu}};
  // Axes at any angle: nothing may depend on them.
  material.axis_1           = {{1, 2, 3}};
  material.axis_2           = {{-2, 1, 5}};
  const Outcome anisotropic = run(parameters);

  ASSERT_EQ(isotropic.fspv.size(), anisotropic.fspv.size());
  double peak = 0, difference = 0;
  for (std::size_t i = 0; i < isotropic.fspv.size(); ++i)
    {
      peak = std::max(peak, isotropic.fspv[i][1]);
      difference =
        std::max(difference,
                 std::abs(isotropic.fspv[i][1] - anisotropic.fspv[i][1]));
    }
  EXPECT_GT(peak, 7);
  EXPECT_LE(difference, 1e-9 * peak);
}

TEST(Spalling, WithoutInsertionItIsPlainFiniteElements)
{
  const std::string end = "Time/End time=100e-6", step = "Time/Time step=1e-7";
  const Outcome     strong = run(scene({end,
                                        step,
                                        faces,
                                        "Material granite/Tensile strength=1e9",
                                        "Material granite/Cohesion=1e9"}));
  const Outcome plain = run(scene({end, step, "Fracture/Cohesive model=none"}));
  EXPECT_EQ(strong.state_hash, plain.state_hash);
  EXPECT_EQ(strong.fspv, plain.fspv);
}
