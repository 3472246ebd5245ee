#include <rift/base/launcher.h>

#include <gtest/gtest.h>

#include <cstdlib>

using rift::warning_about_ranks;

namespace
{
  const char *const names[] = {"OMPI_COMM_WORLD_SIZE",
                               "PMI_SIZE",
                               "SLURM_NTASKS"};
}

TEST(Launcher, DoubtsWhenMpiKnowsOfFewerRanks)
{
  for (const char *name : names)
    unsetenv(name);
  EXPECT_EQ(warning_about_ranks(1), "");
  for (const std::string name : names)
    {
      setenv(name.c_str(), "4", 1);
      EXPECT_EQ(warning_about_ranks(1),
                name +
                  " is 4, but MPI knows of 1 rank. If rift was to run on more, "
                  "start it by the mpirun of the MPI that it was built with "
                  "(Open MPI on Debian); else each process computes the whole "
                  "scene.");
      EXPECT_EQ(warning_about_ranks(3).substr(0, name.size() + 32),
                name + " is 4, but MPI knows of 3 ranks.");
      EXPECT_EQ(warning_about_ranks(4), "");
      EXPECT_EQ(warning_about_ranks(5), "");
      for (const char *value : {"1", "", "many"})
        {
          setenv(name.c_str(), value, 1);
          EXPECT_EQ(warning_about_ranks(1), "");
        }
      unsetenv(name.c_str());
    }
}
