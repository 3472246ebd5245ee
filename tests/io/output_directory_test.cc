#include <rift/base/exceptions.h>
#include <rift/io/directory_lock.h>
#include <rift/io/output_directory.h>

#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <csignal>
#include <unistd.h>

using namespace rift;
using std::filesystem::exists;

TEST(OutputDirectory, IsCreatedWithItsParents)
{
  const TemporaryDirectory directory;
  prepare_output_directory(directory / "a/b/c", false);
  EXPECT_TRUE(std::filesystem::is_directory(directory / "a/b/c"));
  EXPECT_TRUE(std::filesystem::is_empty(directory / "a/b/c"));
  prepare_output_directory(directory / "a/b/c", false);
}

TEST(OutputDirectory, OlderResultsAreRefused)
{
  const TemporaryDirectory directory;
  write_file(directory / "summary.json", "{}");
  write_file(directory / "energy.csv", "t");
  EXPECT_EQ(message_of<InputError>(
              [&] { prepare_output_directory(directory.path, false); }),
            "The output directory " + directory.path +
              " holds results of an older run: 2 files, the first is "
              "energy.csv. Choose another directory with --output, or set "
              "Output / Overwrite to true to replace them.");
  EXPECT_EQ(read_file(directory / "summary.json"), "{}");
}

TEST(OutputDirectory, CheckRemovesNothing)
{
  const TemporaryDirectory directory;
  check_output_directory(directory / "new", false);
  EXPECT_TRUE(std::filesystem::is_empty(directory / "new"));

  write_file(directory / "summary.json", "{}");
  check_output_directory(directory.path, true);
  EXPECT_EQ(read_file(directory / "summary.json"), "{}");
  EXPECT_THROW(check_output_directory(directory.path, false), InputError);
}

TEST(OutputDirectory, OverwriteRemovesOnlyResults)
{
  const TemporaryDirectory directory;
  const auto               own    = {"solid.pvd",
                                     "fracture.pvd",
                                     "solid-00000.vtu",
                                     "solid-00000.0.vtu",
                                     "solid-00001.12.vtu",
                                     "fracture-00012.vtu",
                                     "probes.csv",
                                     "energy.csv",
                                     "fragments.csv",
                                     "summary.json",
                                     "log.txt",
                                     "solid-100000.vtu",
                                     "solid.pvd.tmp"};
  const auto               others = {"pulse.csv",
                                     "spalling.prm",
                                     "solid-1.vtu",
                                     "solid-0000x.vtu",
                                     "solid-00000..vtu",
                                     "solid-00000.1.2.vtu",
                                     "my-solid-00000.vtu",
                                     "solid-00000.vtu.bak",
                                     "notes.txt",
                                     "view.pvsm"};
  for (const std::string name : own)
    write_file(directory / name, "x");
  for (const std::string name : others)
    write_file(directory / name, "x");
  write_file(directory / "parameters.prm",
             std::string(parameters_marker) + "\nset End time = 1\n");
  std::filesystem::create_directory(directory / "solid-00001.vtu");

  prepare_output_directory(directory.path, true);
  for (const std::string name : own)
    EXPECT_FALSE(exists(directory / name)) << name;
  EXPECT_FALSE(exists(directory / "parameters.prm"));
  for (const std::string name : others)
    EXPECT_EQ(read_file(directory / name), "x") << name;
  EXPECT_TRUE(exists(directory / "solid-00001.vtu"));
  EXPECT_FALSE(exists(directory / "rift.tmp"));
}

namespace
{
  // What a run with checkpoints leaves, one of them unfinished.
  void
  make_checkpoints(const TemporaryDirectory &directory)
  {
    for (const std::string set : {"100", "200", "200.old", "300.tmp"})
      {
        std::filesystem::create_directories(directory / ("checkpoint/" + set));
        for (const std::string file :
             {"manifest", "rank-00000", "rank-00001", "rank-100000"})
          write_file(directory / ("checkpoint/" + set + "/" + file), "x");
      }
    write_file(directory / "checkpoint/mesh", "x");
    write_file(directory / "checkpoint/mesh.tmp", "x");
  }
} // namespace

TEST(OutputDirectory, CheckpointsAreResults)
{
  const TemporaryDirectory directory;
  make_checkpoints(directory);
  EXPECT_EQ(message_of<InputError>(
              [&] { prepare_output_directory(directory.path, false); }),
            "The output directory " + directory.path +
              " holds results of an older run: 1 file, checkpoint. Choose "
              "another directory with --output, or set Output / Overwrite to "
              "true to replace them.");
  EXPECT_TRUE(exists(directory / "checkpoint/200/rank-00001"));

  prepare_output_directory(directory.path, true);
  EXPECT_TRUE(std::filesystem::is_empty(directory.path));
}

TEST(OutputDirectory, OverwriteKeepsOtherFilesBesideCheckpoints)
{
  const TemporaryDirectory directory;
  make_checkpoints(directory);
  const auto others = {"checkpoint/notes.txt",
                       "checkpoint/100.bak/manifest",
                       "checkpoint/0100/manifest",
                       "checkpoint/-1/manifest",
                       "checkpoint/1e3/manifest",
                       "checkpoint/99999999999999999999/manifest"};
  for (const std::string name : others)
    {
      std::filesystem::create_directories(
        std::filesystem::path(directory / name).parent_path());
      write_file(directory / name, "x");
    }
  prepare_output_directory(directory.path, true);
  for (const std::string name : others)
    EXPECT_EQ(read_file(directory / name), "x") << name;
  EXPECT_FALSE(exists(directory / "checkpoint/100"));
  EXPECT_FALSE(exists(directory / "checkpoint/mesh"));
  prepare_output_directory(directory.path, false);

  std::filesystem::create_directories(directory / "checkpoint/100");
  write_file(directory / "checkpoint/100/manifest", "x");
  write_file(directory / "checkpoint/100/rank-0001", "mine");
  EXPECT_EQ(message_of<DiskError>(
              [&] { prepare_output_directory(directory.path, true); }),
            "Cannot remove " + (directory / "checkpoint/100") +
              ": Directory not empty.");
  EXPECT_EQ(read_file(directory / "checkpoint/100/rank-0001"), "mine");
}

TEST(OutputDirectory, KeepsEverythingAfterARestart)
{
  const TemporaryDirectory directory;
  make_checkpoints(directory);
  write_file(directory / "energy.csv", "t");
  write_file(directory / "parameters.prm",
             std::string(parameters_marker) + "\nset End time = 1\n");
  reopen_output_directory(directory.path);
  EXPECT_EQ(read_file(directory / "energy.csv"), "t");
  EXPECT_EQ(read_file(directory / "checkpoint/300.tmp/manifest"), "x");
  EXPECT_FALSE(exists(directory / "rift.tmp"));
}

TEST(OutputDirectory, GoesOnWithoutResultsOfTheEnd)
{
  const TemporaryDirectory directory;
  remove_results_of_end(directory.path);
  for (const std::string name : {"summary.json", "fragments.csv", "energy.csv"})
    write_file(directory / name, "t");
  remove_results_of_end(directory.path);
  EXPECT_FALSE(exists(directory / "summary.json"));
  EXPECT_FALSE(exists(directory / "fragments.csv"));
  EXPECT_TRUE(exists(directory / "energy.csv"));
}

TEST(OutputDirectory, CannotRestartInIt)
{
  const TemporaryDirectory directory;
  write_file(directory / "f", "");
  for (const std::string name : {"f", "no"})
    {
      EXPECT_EQ(message_of<InputError>(
                  [&] { reopen_output_directory(directory / name); }),
                "There is no output directory " + (directory / name) +
                  " in which a run could go on. Start it without --restart.");
    }
  EXPECT_FALSE(exists(directory / "no"));
  EXPECT_THROW(reopen_output_directory(""), InputError);
  EXPECT_EQ(message_of<DiskError>([] {
              reopen_output_directory("/proc");
            }).substr(0, 28),
            "Cannot create /proc/rift.tmp");

  write_file(directory / "parameters.prm", "set Title = mine\n");
  EXPECT_EQ(
    message_of<InputError>([&] { reopen_output_directory(directory.path); }),
    "rift would write " + (directory / "parameters.prm") +
      ", but there is a file of that name that no earlier run has "
      "left. Rename it, or choose another output directory.");
}

TEST(OutputDirectory, ForeignFilesAreNoResults)
{
  const TemporaryDirectory directory;
  write_file(directory / "pulse.csv", "x");
  prepare_output_directory(directory.path, false);
  EXPECT_EQ(read_file(directory / "pulse.csv"), "x");
}

TEST(OutputDirectory, SceneOfTheUserIsKept)
{
  const TemporaryDirectory directory;
  write_file(directory / "parameters.prm", "set Title = mine\n");
  write_file(directory / "log.txt", "x");
  for (const bool overwrite : {false, true})
    EXPECT_EQ(message_of<InputError>(
                [&] { prepare_output_directory(directory.path, overwrite); }),
              "rift would write " + (directory / "parameters.prm") +
                ", but there is a file of that name that no earlier run has "
                "left. Rename it, or choose another output directory.");
  EXPECT_EQ(read_file(directory / "parameters.prm"), "set Title = mine\n");
  EXPECT_EQ(read_file(directory / "log.txt"), "x");
}

TEST(OutputDirectory, IsAFile)
{
  const TemporaryDirectory directory;
  write_file(directory / "f", "");
  EXPECT_EQ(message_of<InputError>(
              [&] { prepare_output_directory(directory / "f", true); }),
            "The output directory " + (directory / "f") +
              " is a file. Choose another name in Output / Directory or with "
              "--output.");
  EXPECT_EQ(message_of<DiskError>(
              [&] { prepare_output_directory(directory / "f/g", true); }),
            "Cannot create the output directory " + (directory / "f/g") +
              ": Not a directory. Check that its folder exists.");
}

TEST(OutputDirectory, EmptyName)
{
  EXPECT_EQ(message_of<InputError>([] { prepare_output_directory("", true); }),
            "The name of the output directory is empty. Set Output / Directory "
            "or give --output.");
}

TEST(OutputDirectory, IsNotWritable)
{
  // Not even root can create anything here.
  EXPECT_EQ(message_of<DiskError>([] {
              prepare_output_directory("/proc/rift", false);
            }).substr(0, 48),
            "Cannot create the output directory /proc/rift: N");
  EXPECT_EQ(message_of<DiskError>([] {
              prepare_output_directory("/proc", false);
            }).substr(0, 28),
            "Cannot create /proc/rift.tmp");
}

namespace
{
  std::string
  refusal(const TemporaryDirectory &directory, const pid_t holder)
  {
    std::string host(255, '\0');
    gethostname(host.data(), host.size());
    host.resize(host.find('\0'));
    return "The output directory " + directory.path +
           " is in use by another run of rift, process " +
           std::to_string(holder) + " on host " + host +
           ". Wait for its end, stop it, or choose another directory with "
           "--output.";
  }
} // namespace

TEST(DirectoryLock, OnlyOneHasIt)
{
  const TemporaryDirectory directory;
  const auto               lock = [&] { DirectoryLock{directory.path}; };
  {
    const DirectoryLock first(directory.path);
    for (int i = 0; i < 2; ++i)
      EXPECT_EQ(message_of<InputError>(lock), refusal(directory, getpid()));
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory.path));
  EXPECT_EQ(message_of<InputError>(lock), "(nothing was thrown)");
}

TEST(DirectoryLock, IsNoResult)
{
  const TemporaryDirectory directory;
  const DirectoryLock      lock(directory.path);
  prepare_output_directory(directory.path, false);
  reopen_output_directory(directory.path);
  EXPECT_TRUE(exists(directory / "rift.lock"));
}

TEST(DirectoryLock, VanishesWithAKilledProcess)
{
  const TemporaryDirectory directory;
  const pid_t              child = fork();
  if (child == 0)
    {
      const DirectoryLock lock(directory.path);
      write_file(directory / "ready", "");
      while (true)
        pause();
    }
  while (!exists(directory / "ready"))
    usleep(1000);
  EXPECT_EQ(message_of<InputError>([&] { DirectoryLock{directory.path}; }),
            refusal(directory, child));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(exists(directory / "rift.lock"));
  EXPECT_NO_THROW(DirectoryLock{directory.path});
  EXPECT_FALSE(exists(directory / "rift.lock"));
}

TEST(DirectoryLock, NeedsADirectory)
{
  EXPECT_EQ(message_of<DiskError>([] { DirectoryLock{"/nowhere"}; }),
            "Cannot create /nowhere/rift.lock: No such file or directory. "
            "Check that its folder exists.");
}
