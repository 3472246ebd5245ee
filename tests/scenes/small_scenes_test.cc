// Small scenes, whose physics is in SCENE.output with few digits.

#include "../temporary_directory.h"

#include <rift/app/simulation.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace rift;

namespace
{
  struct Extreme
  {
    double value = 0, time = 0;
  };

  /** Three digits, "8.04 * 10^-7". */
  std::string
  digits(const double value)
  {
    if (value == 0)
      return "0";
    const int exponent =
      static_cast<int>(std::floor(std::log10(std::abs(value))));
    return fmt::format("{:.2f} * 10^{}",
                       value / std::pow(10., exponent),
                       exponent);
  }

  /** Nothing for what is but rounding when compared with `scale`. */
  std::string
  line_of(const std::string &name, const Extreme &extreme, const double scale)
  {
    if (std::abs(extreme.value) <= 1e-9 * scale)
      return "";
    return fmt::format("{}: {} at {:.3g} us\n",
                       name,
                       digits(extreme.value),
                       1e6 * extreme.time);
  }

  /** Largest and smallest value of each probe with their times. */
  std::string
  extremes_of_probes(const std::string &path)
  {
    std::ifstream file(path);
    std::string   line, cell;
    std::getline(file, line);
    std::vector<std::string> names;
    for (std::istringstream header(line); std::getline(header, cell, ',');)
      names.push_back(cell);
    std::vector<Extreme> largest(names.size()), smallest(names.size());
    while (std::getline(file, line))
      {
        std::istringstream row(line);
        double             time = 0;
        for (std::size_t i = 0; std::getline(row, cell, ','); ++i)
          {
            const double value = std::stod(cell);
            if (i == 0)
              time = value;
            if (value > largest[i].value)
              largest[i] = {value, time};
            if (value < smallest[i].value)
              smallest[i] = {value, time};
          }
      }
    std::string text;
    for (std::size_t i = 1; i < names.size(); ++i)
      {
        const double scale = largest[i].value - smallest[i].value;
        text += line_of("largest " + names[i], largest[i], scale) +
                line_of("smallest " + names[i], smallest[i], scale);
      }
    return text;
  }

  /** What happens in a scene of this folder. */
  std::string
  physics_of(const std::string &scene)
  {
    const TemporaryDirectory directory;
    Parameters               parameters =
      read_parameters(RIFT_SOURCE_DIRECTORY "/tests/scenes/" + scene + ".prm");
    parameters.output.directory = directory / "results";
    Log         log(nullptr);
    Simulation  simulation(parameters, log);
    std::string text = fmt::format("cells: {}, nodes: {}\n",
                                   simulation.topology().n_owned_cells(),
                                   simulation.topology().n_owned_nodes());
    simulation.run();
    const EnergyLedger &ledger = simulation.energy_ledger();
    text +=
      fmt::format("steps: {}, time: {:.4g} us\n"
                  "work of the loads: {} J\n"
                  "energy balance closes to 1e-4: {}\n",
                  simulation.state().step,
                  1e6 * simulation.state().time,
                  digits(ledger.energies()["loads"]),
                  ledger.largest_relative_residual() <= 1e-4 ? "yes" : "no");
    return text + extremes_of_probes(directory / "results/probes.csv");
  }
} // namespace

TEST(SmallScenes, HaveThePhysicsOfTheirFiles)
{
  for (const std::string scene : {"bar", "falling_box", "spalling"})
    EXPECT_EQ(
      physics_of(scene),
      read_file(RIFT_SOURCE_DIRECTORY "/tests/scenes/" + scene + ".output"))
      << scene;
}
