// Runs a scene step by step and looks at its state: rift as a library.

#include <deal.II/base/mpi.h>

#include <rift/app/simulation.h>

#include <iostream>

int
main(int argc, char **argv)
{
  if (argc != 2)
    {
      std::cerr << "usage: step_by_step SCENE.prm\n";
      return 1;
    }
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  rift::Log                                      log(&std::cout);
  rift::Simulation simulation(rift::read_parameters(argv[1]), log);
  while (simulation.state().step < simulation.n_steps())
    simulation.step();
  simulation.step(); // The forces at the end, and the balance of energy
  std::cout << "kinetic energy at the end: "
            << simulation.energy_ledger().energies()["kinetic"] << " J\n";
}
