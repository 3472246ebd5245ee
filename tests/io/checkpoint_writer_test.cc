#include "../file_size_limit.h"
#include "../temporary_directory.h"
#include "checkpoint_run.h"
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <random>

namespace
{
  using namespace rift;
  using namespace rift::test;
  namespace fs = std::filesystem;

  using Names = std::vector<std::string>;

  // Paths below a folder, in order, with the content of those that are files.
  std::map<std::string, std::string>
  content_of(const std::string &folder)
  {
    std::map<std::string, std::string> result;
    for (const auto &entry : fs::recursive_directory_iterator(folder))
      result[entry.path().string().substr(folder.size() + 1)] =
        entry.is_directory() ? "" : read_file(entry.path().string());
    return result;
  }

  Names
  names_in(const std::string &folder)
  {
    Names names;
    for (const auto &entry : fs::directory_iterator(folder))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  CheckpointSet
  find(const TemporaryDirectory &directory)
  {
    return find_checkpoint(directory.path, Communicator());
  }
} // namespace

TEST(CheckpointWriter, FilesOfASet)
{
  const TemporaryDirectory directory;
  const CheckpointRun      run(directory.path, Communicator(), 2);
  EXPECT_EQ(names_in(directory / "checkpoint"), Names{"mesh"});
  EXPECT_EQ(run.write(1200), "");
  EXPECT_EQ(names_in(directory / "checkpoint"), (Names{"1200", "mesh"}));
  EXPECT_EQ(names_in(directory / "checkpoint/1200"),
            (Names{"manifest", "rank-00000"}));
  const CheckpointSet set = find(directory);
  EXPECT_TRUE(set.damaged.empty());
  EXPECT_EQ(set.path, directory / "checkpoint/1200");
  expect_set(set, 1200, 1);
}

TEST(CheckpointWriter, SameStateGivesTheSameFiles)
{
  const TemporaryDirectory a, b;
  for (const auto &path : {a.path, b.path})
    CheckpointRun(path, Communicator(), 2).write(7);
  EXPECT_EQ(content_of(a.path), content_of(b.path));
  EXPECT_EQ(content_of(a.path).size(), 5u);
}

TEST(CheckpointWriter, KeepsTheNewest)
{
  for (const unsigned int n_sets : {1u, 2u, 3u})
    {
      const TemporaryDirectory directory;
      const CheckpointRun      run(directory.path, Communicator(), n_sets);
      Names                    expected = {"mesh"};
      // In this order, 1000 before 999 if names were compared as texts.
      for (const std::uint64_t step : {0, 9, 99, 999, 1000})
        {
          EXPECT_EQ(run.write(step), "");
          expected.insert(expected.end() - 1, std::to_string(step));
          if (expected.size() > n_sets + 1)
            expected.erase(expected.begin());
          Names names = names_in(directory / "checkpoint");
          EXPECT_TRUE(std::is_permutation(names.begin(),
                                          names.end(),
                                          expected.begin(),
                                          expected.end()))
            << step;
          expect_set(find(directory), step, 1);
        }
    }
}

TEST(CheckpointWriter, RemovesWhatAKilledRunHasLeft)
{
  const TemporaryDirectory directory;
  const CheckpointRun      run(directory.path, Communicator(), 2);
  run.write(10);
  run.write(20);
  for (const char *name : {"30.tmp", "20.old", "40"})
    fs::copy(directory / "checkpoint/20",
             directory / (std::string("checkpoint/") + name));
  fs::create_directory(directory / "checkpoint/25.tmp");
  write_file(directory / "checkpoint/25.tmp/rank-00007", "half a fi");
  fs::create_directory(directory / "checkpoint/2025");
  write_file(directory / "checkpoint/notes", "mine");

  // An unfinished set counts for nothing, a later one is not that of its step.
  const CheckpointSet set = find(directory);
  expect_set(set, 20, 1);
  EXPECT_EQ(set.damaged,
            (Names{directory / "checkpoint/2025/manifest is missing.",
                   directory / "checkpoint/40/manifest is that of step 20."}));

  EXPECT_EQ(run.write(25), "");
  EXPECT_EQ(names_in(directory / "checkpoint"),
            (Names{"20", "25", "mesh", "notes"}));
  EXPECT_EQ(names_in(directory / "checkpoint/25"),
            (Names{"manifest", "rank-00000"}));
}

TEST(CheckpointWriter, ReplacesASetOfTheSameStep)
{
  const TemporaryDirectory directory;
  const std::string        path = directory / "checkpoint/10";
  CheckpointRun(directory.path, Communicator(), 2).write(10);
  write_file(path + "/rank-00000", "damaged");
  write_file(path + "/rank-00001", "of a run on more ranks");
  EXPECT_THROW(find(directory), InputError);
  CheckpointRun(directory.path, Communicator(), 2).write(10);
  EXPECT_EQ(names_in(directory / "checkpoint"), (Names{"10", "mesh"}));
  EXPECT_EQ(names_in(path), (Names{"manifest", "rank-00000"}));
  expect_set(find(directory), 10, 1);

  // Killed when the old set had been moved away.
  fs::rename(path, path + ".old");
  expect_set(find(directory), 10, 1);
  fs::copy(path + ".old", path);
  expect_set(find(directory), 10, 1);
  EXPECT_EQ(find(directory).path, path);
}

TEST(CheckpointWriter, TellsWhatCannotBeRemoved)
{
  const TemporaryDirectory directory;
  const CheckpointRun      run(directory.path, Communicator(), 1);
  run.write(10);
  write_file(directory / "checkpoint/10/notes", "mine");
  const std::string failure =
    "Cannot remove " + (directory / "checkpoint/10") + ": Directory not empty.";
  EXPECT_EQ(run.write(20), failure);
  EXPECT_EQ(run.write(30), failure);
  EXPECT_EQ(names_in(directory / "checkpoint"), (Names{"10", "30", "mesh"}));
  EXPECT_EQ(names_in(directory / "checkpoint/10"), Names{"notes"});
  fs::remove(directory / "checkpoint/10/notes");
  EXPECT_EQ(run.write(40), "");
  EXPECT_EQ(names_in(directory / "checkpoint"), (Names{"40", "mesh"}));
}

TEST(CheckpointWriter, DiskIsFullAtAnyByte)
{
  const TemporaryDirectory directory;
  const CheckpointRun      run(directory.path, Communicator(), 1);
  run.write(10);
  const auto        before   = content_of(directory.path);
  const std::string part     = directory / "checkpoint/20.tmp/rank-00000";
  const std::string manifest = directory / "checkpoint/20.tmp/manifest";
  const std::size_t part_size =
    fs::file_size(directory / "checkpoint/10/rank-00000");
  const std::size_t manifest_size =
    fs::file_size(directory / "checkpoint/10/manifest");
  const std::size_t largest = std::max(part_size, manifest_size);
  EXPECT_NE(part_size, manifest_size); // each is the one that fails
  for (std::size_t size = 0; size < largest; ++size)
    {
      {
        const FileSizeLimit limit(size);
        EXPECT_EQ(message_of<DiskError>([&] { run.write(20); }),
                  "Cannot write " + (size < part_size ? part : manifest) +
                    ": File too large. Raise the limit on the size of a file "
                    "(ulimit -f), or write to another disk.");
      }
      ASSERT_EQ(content_of(directory.path), before) << size;
    }
  const FileSizeLimit limit(largest);
  EXPECT_EQ(run.write(20), "");
  expect_set(find(directory), 20, 1);
}

TEST(CheckpointWriter, DiskIsFullAtTheMesh)
{
  const TemporaryDirectory directory;
  {
    const FileSizeLimit limit(30);
    EXPECT_EQ(message_of<DiskError>(
                [&] { CheckpointRun(directory.path, Communicator(), 1); }),
              "Cannot write " + (directory / "checkpoint/mesh.tmp") +
                ": File too large. Raise the limit on the size of a file "
                "(ulimit -f), or write to another disk.");
  }
  EXPECT_TRUE(fs::is_empty(directory / "checkpoint"));
}

TEST(CheckpointWriter, FolderCannotBeCreated)
{
  const TemporaryDirectory directory;
  write_file(directory / "checkpoint", "");
  EXPECT_EQ(message_of<DiskError>(
              [&] { CheckpointRun(directory.path, Communicator(), 1); }),
            "Cannot create the folder " + (directory / "checkpoint") +
              ": Not a directory. Check that its folder exists.");
  fs::remove(directory / "checkpoint");

  const CheckpointRun run(directory.path, Communicator(), 1);
  run.write(10);
  write_file(directory / "checkpoint/20.tmp", "");
  EXPECT_EQ(message_of<DiskError>([&] { run.write(20); }),
            "Cannot create the folder " + (directory / "checkpoint/20.tmp") +
              ": Not a directory. Check that its folder exists.");
  fs::remove(directory / "checkpoint/20.tmp");
  write_file(directory / "checkpoint/20.old", "");
  write_file(directory / "checkpoint/20", "");
  EXPECT_EQ(run.write(20), "");
  expect_set(find(directory), 20, 1);
}

// A run that is killed at any moment leaves a set to go on from, from its
// first one on. On a busy machine it takes many until one has written any.
TEST(CheckpointWriter, KilledAtAnyMoment)
{
  const TemporaryDirectory directory;
  const CheckpointRun      run(directory.path, Communicator(), 1);
  run.write(0);
  std::mt19937  random(1);
  std::uint64_t last = 0;
  for (unsigned int i = 0; i < 60 || (last == 0 && i < 1000); ++i)
    {
      const pid_t child = ::fork();
      ASSERT_GE(child, 0);
      if (child == 0)
        // Every other run goes on by writing the same step again and again.
        for (std::uint64_t step = last;; step += i % 2)
          run.write(step);
      // Longer on a machine that is too busy to write a set in that time.
      ::usleep(2000 + random() % (20000 * (1 + i / 60)));
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);

      const CheckpointSet set = find(directory);
      EXPECT_EQ(set.damaged, Names());
      EXPECT_GE(set.manifest.step, last);
      last = set.manifest.step;
      expect_set(set, last, 1);
    }
  EXPECT_GT(last, 0u);
}
