// Runs a scene on any number of ranks and prints its physics with few digits,
// for numdiff:
//   scene_driver SCENE.prm
// Results go to the folder "results" of the current one.

#include <rift/app/simulation.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

using namespace rift;

namespace
{
  struct Extreme
  {
    double value = 0, time = 0;
  };

  /**
   * Three digits and a power of ten apart, "8.04 * 10^-7": numdiff takes all
   * numbers below 1e-6 for the same.
   */
  std::string
  digits(const double value)
  {
    if (value == 0)
      return "0";
    const int exponent =
      static_cast<int>(std::floor(std::log10(std::abs(value))));
    char text[40];
    std::snprintf(text,
                  sizeof text,
                  "%.2f * 10^%d",
                  value / std::pow(10., exponent),
                  exponent);
    return text;
  }

  /** Not for what is nothing but rounding when compared with `scale`. */
  void
  print(const std::string &name, const Extreme &extreme, const double scale)
  {
    if (std::abs(extreme.value) > 1e-9 * scale)
      std::printf("%s: %s at %.3g us\n",
                  name.c_str(),
                  digits(extreme.value).c_str(),
                  1e6 * extreme.time);
  }

  /** Largest and smallest value of each probe with their times. */
  void
  print_probes(const std::string &path)
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
    for (std::size_t i = 1; i < names.size(); ++i)
      {
        const double scale = largest[i].value - smallest[i].value;
        print("largest " + names[i], largest[i], scale);
        print("smallest " + names[i], smallest[i], scale);
      }
  }

  std::int64_t
  n_owned_cells(const Simulation &simulation)
  {
    return static_cast<std::int64_t>(simulation.topology().n_owned_cells());
  }

  void
  print_results(const Simulation &simulation)
  {
    const Energies &e = simulation.energy_ledger().energies();
    std::printf("steps: %zu, time: %.4g us\n",
                static_cast<std::size_t>(simulation.state().step),
                1e6 * simulation.state().time);
    std::printf("work of the loads: %s J\n", digits(e["loads"]).c_str());
    std::printf("energy balance closes to 1e-4: %s\n",
                simulation.energy_ledger().largest_relative_residual() <= 1e-4 ?
                  "yes" :
                  "no");
    print_probes("results/probes.csv");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try
    {
      Parameters parameters       = read_parameters(argv[1]);
      parameters.output.directory = "results";
      parameters.output.overwrite = true;
      const Communicator communicator(MPI_COMM_WORLD);
      Log                log(nullptr);
      Simulation         simulation(parameters, log, communicator);
      const auto         n_cells = communicator.sum(n_owned_cells(simulation));
      const auto         n_nodes =
        communicator.sum(simulation.topology().n_owned_nodes());
      simulation.run();
      if (communicator.is_root())
        {
          std::printf("cells: %ld, nodes: %ld\n", n_cells, n_nodes);
          print_results(simulation);
        }
    }
  catch (const std::exception &error)
    {
      std::cerr << error.what() << std::endl;
      return 1;
    }
  return 0;
}
