// main of tests that run on several ranks without deal.II.

#include "run_tests.h"

int
main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  const int failed = rift::test::run_tests(argc, argv);
  MPI_Finalize();
  return failed;
}
