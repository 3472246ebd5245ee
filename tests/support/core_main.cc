// main of tests that link deal.II, on any number of ranks.

#include <deal.II/base/mpi.h>

#include "run_tests.h"

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return rift::test::run_tests(argc, argv);
}
