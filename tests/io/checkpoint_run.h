#ifndef rift_tests_checkpoint_run_h
#define rift_tests_checkpoint_run_h

#include <rift/io/checkpoint_set.h>
#include <rift/io/checkpoint_writer.h>

#include <gtest/gtest.h>

namespace rift::test
{
  /** What a rank stores at a step: every number tells where it comes from. */
  inline std::vector<double>
  state_of(const std::uint64_t step, const std::size_t rank)
  {
    std::vector<double> values(20 + 5 * rank, static_cast<double>(rank));
    values[3] = static_cast<double>(step);
    return values;
  }

  /** A run that only writes checkpoints. */
  struct CheckpointRun
  {
    CheckpointRun(const std::string  &directory,
                  const Communicator &communicator,
                  const unsigned int  n_sets,
                  const double        density = 2641)
      : communicator(communicator)
      , writer(directory,
               communicator,
               write_checkpoint_mesh(directory,
                                     communicator,
                                     [&](CheckpointFileWriter &file) {
                                       file.write_value("density", density);
                                     }),
               n_sets)
    {
    }

    std::string
    write(const std::uint64_t step) const
    {
      return writer.write(step,
                          1e-9 * static_cast<double>(step),
                          "set Title = a run\n",
                          [&](CheckpointFileWriter &file) {
                            file.write("state",
                                       state_of(step, communicator.rank()));
                            file.write_value("rank", communicator.rank());
                          });
    }

    const Communicator     communicator;
    const CheckpointWriter writer;
  };

  /** That a set is whole and that of a step, written by so many ranks. */
  inline void
  expect_set(const CheckpointSet &set,
             const std::uint64_t  step,
             const std::size_t    n_writers)
  {
    EXPECT_EQ(set.manifest.step, step);
    EXPECT_EQ(set.manifest.time, 1e-9 * static_cast<double>(step));
    EXPECT_EQ(set.manifest.parameters, "set Title = a run\n");
    EXPECT_EQ(set.read_mesh().read_value<double>("density"), 2641);
    ASSERT_EQ(set.manifest.ranks.size(), n_writers);
    for (std::size_t rank = 0; rank < n_writers; ++rank)
      {
        const CheckpointFileReader file = set.read_rank(rank);
        EXPECT_EQ(file.read<double>("state"), state_of(step, rank));
        EXPECT_EQ(file.read_value<int>("rank"), static_cast<int>(rank));
      }
  }
} // namespace rift::test

#endif
