#include "../file_size_limit.h"
#include "../support/shared_directory.h"
#include "checkpoint_run.h"

#include <random>

namespace
{
  using namespace rift;
  using namespace rift::test;
  namespace fs = std::filesystem;

  using Names = std::vector<std::string>;

  // The first `n` ranks; the others get a communicator of their own, and are
  // not to do anything with it.
  class FirstRanks
  {
  public:
    FirstRanks(const Communicator &all, const int n)
      : is_in(all.rank() < n)
    {
      MPI_Comm_split(MPI_COMM_WORLD, is_in ? 0 : 1, all.rank(), &split);
    }

    ~FirstRanks()
    {
      MPI_Comm_free(&split);
    }

    Communicator
    communicator() const
    {
      return Communicator(split);
    }

    const bool is_in;

  private:
    MPI_Comm split;
  };

  // Calls a function on rank 0 while the others wait.
  void
  alone(const Communicator &all, const std::function<void()> &f)
  {
    all.sum(0);
    if (all.is_root())
      f();
    all.sum(0);
  }

  // One way in which a set can be harmed, told by its name.
  std::string
  damage(const std::string &set, const std::string &older, std::mt19937 &random)
  {
    Names files;
    for (const auto &entry : fs::directory_iterator(set))
      files.push_back(entry.path().filename().string());
    std::sort(files.begin(), files.end());
    const std::string name  = files[random() % files.size()];
    const std::string path  = set + "/" + name;
    std::string       bytes = read_file(path);
    const std::size_t place = random() % bytes.size();
    const auto        kind  = random() % 8;
    switch (kind)
      {
      case 0:
        bytes[place] ^= static_cast<char>(1 << random() % 8);
        break;
      case 1:
        bytes.resize(place);
        break;
      case 2:
        bytes.append(1 + random() % 100, static_cast<char>(random()));
        break;
      case 3:
        bytes.clear();
        break;
      case 4:
        bytes.replace(place, bytes.size() - place, bytes.size() - place, 0);
        bytes[place] = 1;
        break;
      case 5: // of another set, good in itself
        bytes = read_file(older + "/" + name);
        break;
      case 6: // of the same set, good in itself
        bytes = read_file(set + "/" +
                          files[(std::find(files.begin(), files.end(), name) -
                                 files.begin() + 1) %
                                files.size()]);
        break;
      default:
        fs::remove(path);
        if (random() % 2 == 0)
          fs::create_directory(path);
        return name + " removed";
      }
    write_file(path, bytes);
    return name + " damaged in the way " + std::to_string(kind);
  }

  void
  restore(const std::string &set, const std::string &copy)
  {
    fs::remove_all(set);
    fs::copy(copy, set, fs::copy_options::recursive);
  }
} // namespace

TEST(CheckpointSet, WrittenAndReadByAnyNumberOfRanks)
{
  const Communicator all(MPI_COMM_WORLD);
  for (int n_writers = 1; n_writers <= all.size(); ++n_writers)
    {
      const SharedDirectory directory(all);
      {
        const FirstRanks writers(all, n_writers);
        if (writers.is_in)
          {
            const CheckpointRun run(directory.path, writers.communicator(), 2);
            for (const std::uint64_t step : {100, 200, 300})
              EXPECT_EQ(run.write(step), "");
          }
      }
      all.sum(0);
      for (int n_readers = 1; n_readers <= all.size(); ++n_readers)
        {
          const FirstRanks readers(all, n_readers);
          if (!readers.is_in)
            continue;
          const CheckpointSet set =
            find_checkpoint(directory.path, readers.communicator());
          EXPECT_TRUE(set.damaged.empty());
          expect_set(set, 300, n_writers);
        }
    }
}

TEST(CheckpointSet, FallsBackToTheOneBefore)
{
  const Communicator    all(MPI_COMM_WORLD);
  const SharedDirectory directory(all);
  const std::string     folder = directory / "checkpoint";
  const CheckpointRun   run(directory.path, all, 3);
  for (const std::uint64_t step : {10, 20, 30})
    run.write(step);
  const std::string last = checkpoint_rank_file(all.size() - 1);
  alone(all, [&] {
    fs::remove(folder + "/30/manifest");
    write_file(folder + "/20/" + last, "x");
  });

  const CheckpointSet set = find_checkpoint(directory.path, all);
  expect_set(set, 10, all.size());
  EXPECT_EQ(set.damaged,
            (Names{folder + "/30/manifest is missing.",
                   folder + "/20/" + last + " has only 1 bytes."}));

  // The next set takes the place of what was damaged.
  EXPECT_EQ(run.write(15), "");
  const CheckpointSet next = find_checkpoint(directory.path, all);
  EXPECT_TRUE(next.damaged.empty());
  expect_set(next, 15, all.size());
  alone(all, [&] { EXPECT_FALSE(fs::exists(folder + "/20")); });
}

TEST(CheckpointSet, NoneIsGood)
{
  const Communicator    all(MPI_COMM_WORLD);
  const SharedDirectory directory(all);
  const std::string     folder  = directory / "checkpoint";
  const auto            message = [&] {
    return message_of<Error>([&] { find_checkpoint(directory.path, all); });
  };
  const std::string advice =
    "Start anew, without --restart; Overwrite = true in subsection Output, or "
    "another --output, lets it, and Interval in steps in subsection Checkpoint "
    "makes it write checkpoints.";
  const std::string none =
    "There is no checkpoint in " + folder + ". " + advice;
  EXPECT_EQ(message(), none);
  const CheckpointRun run(directory.path, all, 2);
  EXPECT_EQ(message(), none);
  run.write(10);
  run.write(20);
  alone(all, [&] { write_file(folder + "/20/rank-00000", ""); });
  expect_set(find_checkpoint(directory.path, all), 10, all.size());

  // Without the mesh, none of them is of any use; that is said once.
  alone(all, [&] {
    std::string bytes = read_file(folder + "/mesh");
    bytes.back() ^= 1;
    write_file(folder + "/mesh", bytes);
  });
  const std::string mesh =
    folder + "/mesh is damaged in the block at byte 71. ";
  EXPECT_EQ(message(),
            "There is no undamaged checkpoint in " + folder + ". " + mesh +
              advice);
}

TEST(CheckpointSet, OfAnotherRun)
{
  const Communicator    all(MPI_COMM_WORLD);
  const SharedDirectory directory(all), other(all);
  CheckpointRun(directory.path, all, 2).write(10);
  CheckpointRun(other.path, all, 2, 2700).write(20);
  alone(all, [&] {
    fs::copy(other / "checkpoint/20", directory / "checkpoint/20");
  });
  const CheckpointSet set = find_checkpoint(directory.path, all);
  expect_set(set, 10, all.size());
  EXPECT_EQ(set.damaged,
            Names{directory / "checkpoint/mesh is whole, but is not the file "
                              "that belongs to this checkpoint."});

  // The manifest of another set alone.
  alone(all, [&] {
    restore(directory / "checkpoint/20", directory / "checkpoint/10");
  });
  EXPECT_EQ(find_checkpoint(directory.path, all).damaged,
            Names{directory / "checkpoint/20/manifest is that of step 10."});
}

TEST(CheckpointSet, NoDamageIsAccepted)
{
  const Communicator    all(MPI_COMM_WORLD);
  const SharedDirectory directory(all);
  const std::string     folder = directory / "checkpoint";
  const CheckpointRun   run(directory.path, all, 2);
  run.write(10);
  run.write(20);
  alone(all, [&] { fs::copy(folder + "/20", directory / "copy"); });

  std::mt19937 random(all.size());
  for (unsigned int i = 0; i < 400; ++i)
    {
      std::string harm;
      alone(all,
            [&] { harm = damage(folder + "/20", folder + "/10", random); });
      const CheckpointSet set = find_checkpoint(directory.path, all);
      ASSERT_EQ(set.manifest.step, 10u) << harm;
      ASSERT_EQ(set.damaged.size(), 1u) << harm;
      alone(all, [&] { restore(folder + "/20", directory / "copy"); });
    }
  const CheckpointSet set = find_checkpoint(directory.path, all);
  EXPECT_TRUE(set.damaged.empty());
  expect_set(set, 20, all.size());
}

TEST(CheckpointSet, DiskIsFullOnOneRank)
{
  const Communicator    all(MPI_COMM_WORLD);
  const SharedDirectory directory(all);
  const CheckpointRun   run(directory.path, all, 1);
  run.write(10);
  for (int failing = 0; failing < all.size(); ++failing)
    {
      std::optional<FileSizeLimit> limit;
      if (all.rank() == failing)
        limit.emplace(100);
      EXPECT_EQ(
        message_of<Error>([&] { run.write(20); }),
        "Cannot write " +
          (directory / "checkpoint/20.tmp/" + checkpoint_rank_file(failing)) +
          ": File too large. Raise the limit on the size of a file "
          "(ulimit -f), or write to another disk.");
    }
  alone(all, [&] {
    EXPECT_FALSE(fs::exists(directory / "checkpoint/20.tmp"));
    EXPECT_FALSE(fs::exists(directory / "checkpoint/20"));
  });
  expect_set(find_checkpoint(directory.path, all), 10, all.size());
}

TEST(CheckpointSet, AnErrorOfTheCallerOnOneRankIsThatOfAll)
{
  const Communicator    all(MPI_COMM_WORLD);
  const SharedDirectory directory(all);
  const CheckpointRun   run(directory.path, all, 1);
  const auto            fail = [&](CheckpointFileWriter &) {
    if (all.rank() == all.size() - 1)
      throw RunError("no state");
  };
  EXPECT_EQ(message_of<Error>([&] { run.writer.write(1, 0, "", fail); }),
            "no state");
  alone(all, [&] { EXPECT_FALSE(fs::exists(directory / "checkpoint/1.tmp")); });
}
