// Brazilian and uniaxial tests.

#include "../temporary_directory.h"

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>

#include <gtest/gtest.h>

#include <map>
#include <sstream>

using namespace rift;

namespace
{
  /**
   * Mean over r < R of the stress across the load in a plane disc of radius 1
   * with the pressure 1 on two arcs of the half angle a. With Fourier's series
   * of the pressure, a_0 + a_2 cos(2 theta) + ..., and Kolosov's functions the
   * sum of the in-plane stresses has the mean -2 a_0 and their difference
   * 2 a_2 (1 - R^2/2). For R = 0 this is the formula of Hondros.
   */
  double
  mean_tension(const double half_angle, const double radius)
  {
    const double a_0 = 2 * half_angle / M_PI;
    const double a_2 = 2 / M_PI * std::sin(2 * half_angle);
    return a_2 * (1 - .5 * radius * radius) - a_0;
  }

  /** Mean over the cells of which `counts` is true of the linear elastic stress
   * along x, from the displacements of the nodes. */
  template <typename Counts>
  double
  mean_stress(const Simulation &simulation,
              const double      youngs_modulus,
              const double      poissons_ratio,
              const Counts     &counts)
  {
    const double    mu     = .5 * youngs_modulus / (1 + poissons_ratio);
    const double    lambda = 2 * mu * poissons_ratio / (1 - 2 * poissons_ratio);
    const Topology &topology = simulation.topology();
    const State    &state    = simulation.state();
    double          sum = 0, volume = 0;
    for (CellIndex cell = 0; cell < topology.n_cells(); ++cell)
      {
        std::array<Vector3<double>, 4> x, u;
        Vector3<double>                centre{};
        for (unsigned int c = 0; c < 4; ++c)
          {
            const NodeIndex node = topology.node(cell, c);
            x[c]                 = state.reference[node].vector();
            u[c]                 = state.displacement[node].vector();
            centre += .25 * x[c];
          }
        if (!counts(centre))
          continue;
        const std::array<Vector3<double>, 3> edges = {
          {x[1] - x[0], x[2] - x[0], x[3] - x[0]}};
        const double    v = dot(edges[0], cross(edges[1], edges[2]));
        Vector3<double> strain{};
        for (unsigned int e = 0; e < 3; ++e)
          {
            const Vector3<double> gradient =
              (1 / v) * cross(edges[(e + 1) % 3], edges[(e + 2) % 3]);
            for (unsigned int d = 0; d < 3; ++d)
              strain[d] += gradient[d] * (u[e + 1][d] - u[0][d]);
          }
        sum += v * (lambda * (strain[0] + strain[1] + strain[2]) +
                    2 * mu * strain[0]);
        volume += v;
      }
    return sum / volume;
  }

  /** Columns of probes.csv of a run, by their names without unit. */
  std::map<std::string, std::vector<double>>
  run(const std::string &scene, const std::vector<std::string> &overrides)
  {
    const TemporaryDirectory directory;
    Parameters               parameters =
      read_parameters(RIFT_SOURCE_DIRECTORY "/prm/" + scene, overrides);
    parameters.output.directory         = directory / "results";
    parameters.output.solution_interval = 0;
    Log log(nullptr);
    Simulation(parameters, log).run();

    std::map<std::string, std::vector<double>> columns;
    std::istringstream file(read_file(directory / "results/probes.csv"));
    std::string        line, cell;
    std::getline(file, line);
    std::vector<std::vector<double> *> by_number;
    for (std::istringstream header(line); std::getline(header, cell, ',');)
      by_number.push_back(&columns[cell.substr(0, cell.find(" ["))]);
    while (std::getline(file, line))
      {
        std::istringstream row(line);
        for (auto *column : by_number)
          {
            std::getline(row, cell, ',');
            column->push_back(std::stod(cell));
          }
      }
    return columns;
  }

  /** Platens that close in with so many m/s, reached after 50 us. */
  std::string
  platen(const std::string &name, const double speed)
  {
    return "Material " + name + "/Velocity z=" + std::to_string(speed) +
           "*min(1, t/50e-6)";
  }
} // namespace

TEST(Brazilian, ElasticDiscHasTheTensionOfHondros)
{
  EXPECT_NEAR(mean_tension(.15, 0), 2 / M_PI * (std::sin(.3) - .15), 1e-15);
  Log            log(nullptr);
  Simulation     simulation(read_parameters(RIFT_SOURCE_DIRECTORY
                                        "/prm/brazilian/elastic_disc.prm",
                                        {}),
                        log);
  FlushDenormals flush_denormals;
  while (simulation.state().step < simulation.n_steps())
    simulation.step();
  constexpr double radius = .0204, core = 3e-3;
  const double     tension =
    mean_stress(simulation, 60e9, .24, [](const Vector3<double> &centre) {
      return std::hypot(centre[0], centre[2]) < core;
    });
  EXPECT_NEAR(tension / (100e6 * mean_tension(.15, core / radius)), 1, .02);
  const Energies &energies = simulation.energy_ledger().energies();
  EXPECT_LT(energies["kinetic"], 1e-6 * energies["strain"]);
}

TEST(Uniaxial, GaugesGiveTheConstantsBack)
{
  auto probes = run("brazilian/ucs.prm",
                    {"Mesh/Element size=3e-3",
                     "Time/End time=150e-6",
                     platen("upper platen", -.5),
                     platen("lower platen", .5)});
  // Between two moments, when the platens have their speed: no insertion yet.
  const auto change = [&](const std::string &name) {
    return probes.at(name).back() - probes.at(name)[80];
  };
  const double stress =
    .5 * (change("lower force") - change("upper force")) / (M_PI * .01 * .01);
  const double axial = .5 *
                       (change("lower gauge 1") + change("lower gauge 2") -
                        change("upper gauge 1") - change("upper gauge 2")) /
                       .02;
  const double lateral =
    (change("lateral gauge 1") - change("lateral gauge 2")) / (2 * .0095);
  EXPECT_GT(std::abs(stress), 50e6);
  EXPECT_NEAR(std::abs(stress) / axial / 40.6e9, 1, .02);
  EXPECT_NEAR(lateral / axial / .2, 1, .02);
}

// The stress reaches the strength of Mohr and Coulomb, and falls.
TEST(Uniaxial, CylinderFails)
{
  const auto   probes = run("brazilian/ucs.prm",
                          {"Mesh/Element size=3e-3",
                             "Time/End time=165e-6",
                             platen("upper platen", -1),
                             platen("lower platen", 1)});
  const double phi    = 50 * M_PI / 180;
  const double strength =
    2 * 36.7e6 * std::cos(phi) / (1 - std::sin(phi)) * M_PI * .01 * .01;
  const auto &upper = probes.at("upper force"),
             &lower = probes.at("lower force");
  double force = 0, largest = 0;
  for (std::size_t i = 0; i < upper.size(); ++i)
    {
      force   = .5 * (std::abs(upper[i]) + std::abs(lower[i]));
      largest = std::max(largest, force);
    }
  EXPECT_NEAR(largest / strength, 1, .05);
  EXPECT_LT(force, .5 * largest);
}

// Of the cube of prm/contact, with bonds.
TEST(Uniaxial, StrengthIsThatOfMohrAndCoulomb)
{
  const double phi = 50 * M_PI / 180;
  const double strength =
    2 * 36.7e6 * std::cos(phi) / (1 - std::sin(phi)) * .02 * .02;
  const auto largest_force = [&](const std::string &law) {
    const auto probes  = run("contact/crush.prm",
                            {"Mesh/Element size=3.5e-3",
                              "Time/End time=190e-6",
                              "Material granite/Residual friction angle=31",
                              "Fracture/Cohesive law=" + law,
                              platen("upper platen", -1)});
    double     largest = 0;
    for (const double force : probes.at("reaction"))
      largest = std::max(largest, std::abs(force));
    return largest;
  };
  EXPECT_NEAR(largest_force("bonds") / strength, 1, .1);
  // By the law of faces it has not broken yet.
  EXPECT_GT(largest_force("faces") / strength, 1.15);
}
