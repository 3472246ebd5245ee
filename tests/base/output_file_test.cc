#include <rift/base/exceptions.h>
#include <rift/base/output_file.h>

#include "../file_size_limit.h"
#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <cerrno>

using namespace rift;

TEST(AtomicFile, WritesAndReplaces)
{
  const TemporaryDirectory directory;
  write_file_atomically(directory / "a", "first");
  EXPECT_EQ(read_file(directory / "a"), "first");

  const std::string large(3000000, 'x');
  write_file_atomically(directory / "a", large);
  EXPECT_EQ(read_file(directory / "a"), large);
  EXPECT_FALSE(std::filesystem::exists(directory / "a.tmp"));
}

TEST(AtomicFile, OldContentStaysUntilCommit)
{
  const TemporaryDirectory directory;
  write_file_atomically(directory / "a", "old");
  {
    AtomicFile file(directory / "a");
    file.write("ne");
    file.write("w");
    EXPECT_EQ(read_file(directory / "a"), "old");
    EXPECT_EQ(read_file(directory / "a.tmp"), "new");
  }
  EXPECT_EQ(read_file(directory / "a"), "old");
  EXPECT_FALSE(std::filesystem::exists(directory / "a.tmp"));
}

TEST(AtomicFile, FullDiskKeepsTheOldFile)
{
  const TemporaryDirectory directory;
  write_file_atomically(directory / "a", "old");
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = message_of<DiskError>(
      [&] { write_file_atomically(directory / "a", std::string(5000, 'x')); });
  }
  EXPECT_EQ(message,
            "Cannot write " + (directory / "a.tmp") +
              ": File too large. Raise the limit on the size of a file "
              "(ulimit -f), or write to another disk.");
  EXPECT_EQ(read_file(directory / "a"), "old");
  EXPECT_FALSE(std::filesystem::exists(directory / "a.tmp"));
}

TEST(AtomicFile, MissingFolder)
{
  const TemporaryDirectory directory;
  EXPECT_EQ(message_of<DiskError>(
              [&] { write_file_atomically(directory / "no/a", "x"); }),
            "Cannot create " + (directory / "no/a.tmp") +
              ": No such file or directory. Check that its folder exists.");
}

TEST(AtomicFile, NameIsTakenByADirectory)
{
  const TemporaryDirectory directory;
  std::filesystem::create_directory(directory / "a");
  EXPECT_EQ(
    message_of<DiskError>([&] { write_file_atomically(directory / "a", "x"); }),
    "Cannot write " + (directory / "a") +
      ": Is a directory. Check the disk, or choose another output "
      "directory.");
  EXPECT_FALSE(std::filesystem::exists(directory / "a.tmp"));
}

TEST(DiskErrors, AdviceFitsTheReason)
{
  const auto message = [](const int error) {
    return message_of<DiskError>(
      [&] { throw_disk_error("write", "f", error); });
  };
  EXPECT_EQ(message(EACCES),
            "Cannot write f: Permission denied. Choose an output directory in "
            "which you may write.");
  EXPECT_EQ(message(EROFS),
            "Cannot write f: Read-only file system. Choose an output directory "
            "in which you may write.");
  EXPECT_EQ(message(EDQUOT),
            "Cannot write f: Disk quota exceeded. Make room on this disk, or "
            "write to another one.");
}

TEST(HistoryFile, HeaderAndRows)
{
  const TemporaryDirectory directory;
  HistoryFile file(directory / "p.csv", {"time [s]", "fspv [m/s]", "a,\"b\""});
  const std::string header = "time [s],fspv [m/s],\"a,\"\"b\"\"\"\n";
  EXPECT_EQ(read_file(directory / "p.csv"), header);
  file.append({0, 0.1, -3});
  file.append({1e-6, 1. / 3, 1e300});
  file.flush();
  EXPECT_EQ(read_file(directory / "p.csv"),
            header + "0,0.1,-3\n1e-06,0.3333333333333333,1e+300\n");
}

TEST(HistoryFile, KeepsRowsWhenTheRunEndsEarly)
{
  const TemporaryDirectory directory;
  {
    HistoryFile file(directory / "p.csv", {"t"});
    file.append({5});
  }
  EXPECT_EQ(read_file(directory / "p.csv"), "t\n5\n");
}

TEST(HistoryFile, ManyRowsComeWithoutFlush)
{
  const TemporaryDirectory directory;
  HistoryFile              file(directory / "p.csv", {"t"});
  for (unsigned int i = 0; i < 70000; ++i)
    file.append({1});
  EXPECT_GE(std::filesystem::file_size(directory / "p.csv"), 131072u);
}

TEST(HistoryFile, FullDiskAtTheHeader)
{
  EXPECT_EQ(message_of<DiskError>([] { HistoryFile("/dev/full", {"t"}); }),
            "Cannot write /dev/full: No space left on device. Make room on "
            "this disk, or write to another one.");
}

TEST(HistoryFile, FullDiskLater)
{
  const TemporaryDirectory directory;
  HistoryFile              file(directory / "p.csv", {"t"});
  file.append({1});
  {
    const FileSizeLimit limit(2);
    EXPECT_EQ(message_of<DiskError>([&] { file.flush(); }),
              "Cannot write " + (directory / "p.csv") +
                ": File too large. Raise the limit on the size of a file "
                "(ulimit -f), or write to another disk.");
  }
  file.flush();
  EXPECT_EQ(read_file(directory / "p.csv"), "t\n");
}

TEST(HistoryFile, WrongNumberOfValues)
{
  const TemporaryDirectory directory;
  HistoryFile              file(directory / "p.csv", {"t", "x"});
  EXPECT_EQ(message_of<std::invalid_argument>([&] { file.append({1}); }),
            "HistoryFile: a row of 1 values in a table of 2 columns");
}

namespace
{
  // A table of three rows, and its length after the second.
  std::uint64_t
  write_three_rows(const std::string &path)
  {
    HistoryFile file(path, {"t", "x"});
    file.append({1, .5});
    file.append({2, .25});
    const std::uint64_t length = file.synchronize();
    file.append({3, .125});
    return length;
  }

  const char *const advice =
    ". Put the file back that the run has left there, or start anew, without "
    "--restart.";
} // namespace

TEST(HistoryFile, GoesOnAfterARestart)
{
  const TemporaryDirectory directory;
  const std::uint64_t      length = write_three_rows(directory / "p.csv");
  EXPECT_EQ(length, 17u);
  EXPECT_EQ(read_file(directory / "p.csv"), "t,x\n1,0.5\n2,0.25\n3,0.125\n");
  {
    HistoryFile file(directory / "p.csv", {"t", "x"}, length);
    EXPECT_EQ(read_file(directory / "p.csv"), "t,x\n1,0.5\n2,0.25\n");
    file.append({3, 8});
    EXPECT_EQ(file.synchronize(), 21u);
  }
  EXPECT_EQ(read_file(directory / "p.csv"), "t,x\n1,0.5\n2,0.25\n3,8\n");
}

TEST(HistoryFile, CannotGoOnWithAShorterFile)
{
  const TemporaryDirectory directory;
  const std::uint64_t      length = write_three_rows(directory / "p.csv");
  for (const std::string content : {"t,x\n1,0.5\n2,0.25", "t,x\n", "t", ""})
    {
      write_file(directory / "p.csv", content);
      EXPECT_EQ(message_of<InputError>([&] {
                  HistoryFile(directory / "p.csv", {"t", "x"}, length);
                }),
                "Cannot go on with " + (directory / "p.csv") + ": it has " +
                  std::to_string(content.size()) +
                  " bytes, but had 17 at the checkpoint" + advice);
      EXPECT_EQ(read_file(directory / "p.csv"), content);
    }
}

TEST(HistoryFile, CannotGoOnWithAMissingFile)
{
  EXPECT_EQ(
    message_of<InputError>([] { HistoryFile("/proc/rift.csv", {"t"}, 2); }),
    std::string("Cannot go on with /proc/rift.csv: it is missing") + advice);
}

TEST(HistoryFile, CannotGoOnWithOtherColumns)
{
  const TemporaryDirectory directory;
  const std::uint64_t      length = write_three_rows(directory / "p.csv");
  const std::string        before = read_file(directory / "p.csv");
  const std::vector<std::vector<std::string>> others = {
    {"t"},
    {"t", "y"},
    {"t", "x", "y"},
    {"t", "x that is longer than the file"}};
  for (const auto &columns : others)
    {
      EXPECT_EQ(message_of<InputError>(
                  [&] { HistoryFile(directory / "p.csv", columns, length); }),
                "Cannot go on with " + (directory / "p.csv") +
                  ": its columns are others than those of this run" + advice);
      EXPECT_EQ(read_file(directory / "p.csv"), before);
    }
  // A table without rows, shorter than the new header.
  write_file(directory / "e.csv", "t\n");
  EXPECT_THROW(HistoryFile(directory / "e.csv", {"t", "x"}, 2), InputError);
}

TEST(HistoryFile, CannotGoOnWithAFolder)
{
  const TemporaryDirectory directory;
  EXPECT_EQ(message_of<DiskError>(
              [&] { OutputFile(directory.path, std::uint64_t(0)); }),
            "Cannot open " + directory.path +
              ": Is a directory. Check the disk, or choose another output "
              "directory.");
}

TEST(Directories, Synchronize)
{
  const TemporaryDirectory directory;
  synchronize_directory(directory.path);
  EXPECT_EQ(
    message_of<DiskError>([&] { synchronize_directory(directory / "no"); }),
    "Cannot open the folder " + (directory / "no") +
      ": No such file or directory. Check that its folder exists.");
}
