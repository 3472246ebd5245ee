#ifndef rift_tests_support_run_tests_h
#define rift_tests_support_run_tests_h

#include <gtest/gtest.h>
#include <mpi.h>

#include <iostream>

namespace rift::test
{
  class FailurePrinter : public testing::EmptyTestEventListener
  {
  public:
    explicit FailurePrinter(const int rank)
      : rank(rank)
    {
    }

    void
    OnTestPartResult(const testing::TestPartResult &result) override
    {
      if (!result.failed())
        return;
      const char *file = result.file_name();
      std::cout << "Rank " << rank << ", " << (file ? file : "unknown file")
                << ":" << result.line_number() << ": " << result.message()
                << std::endl;
    }

  private:
    const int rank;
  };

  /**
   * Runs googletest on all ranks: the tests fail where they fail on any of
   * them. Rank 0 tells how they go on, the others only what has failed.
   */
  inline int
  run_tests(int &argc, char **argv)
  {
    testing::InitGoogleTest(&argc, argv);
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank > 0)
      {
        auto &listeners = testing::UnitTest::GetInstance()->listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new FailurePrinter(rank));
      }
    int failed = RUN_ALL_TESTS();
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return failed;
  }
} // namespace rift::test

#endif
