#include <rift/io/checkpoint_file.h>

#include "../file_size_limit.h"
#include "../temporary_directory.h"
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{
  using namespace rift;

  struct Corner
  {
    std::uint64_t cell;
    std::uint32_t corner, node;

    bool
    operator==(const Corner &other) const
    {
      return cell == other.cell && corner == other.corner && node == other.node;
    }
  };

  struct Padded
  {
    std::uint64_t a;
    std::uint8_t  b;
  };

  // A small file that has been written, and what it is known by.
  struct SmallFile
  {
    explicit SmallFile(const std::string &path)
      : path(path)
      , id(write(path))
      , bytes(read_file(path))
    {
    }

    static CheckpointFileId
    write(const std::string &path)
    {
      CheckpointFileWriter file(path);
      file.write("numbers", std::vector<double>{1, -2.5, 1e300});
      file.write_text("text", "a text");
      file.write_value("count", std::uint64_t(17));
      return file.finish();
    }

    // What the reader says of other bytes in its place, after the path.
    std::string
    failure(const std::string &other_bytes) const
    {
      write_file(path, other_bytes);
      const std::string message =
        message_of<CheckpointDamaged>([&] { CheckpointFileReader{path}; });
      EXPECT_EQ(message.substr(0, path.size() + 1), path + " ");
      return message.substr(std::min(message.size(), path.size() + 1));
    }

    const std::string      path;
    const CheckpointFileId id;
    const std::string      bytes;
  };

  // Where the blocks of the small file begin, and its end.
  constexpr std::size_t starts[] = {24, 87, 129, 174, 225};
} // namespace

TEST(CheckpointFile, RoundTrip)
{
  const TemporaryDirectory  directory;
  const std::vector<double> doubles = {0., -0., 5e-324, INFINITY, NAN};
  const std::vector<Corner> corners = {{1ull << 60, 3, 7}, {0, 1, 2}};
  const std::vector<std::array<double, 3>> points = {{{1, 2, 3}}};
  const std::string text = std::string("line\n\0line", 10);
  CheckpointFileId  id;
  {
    CheckpointFileWriter file(directory / "f");
    file.write("doubles", doubles);
    file.write("corners", corners);
    file.write("points", points);
    file.write("nothing", std::vector<float>());
    file.write("", std::vector<std::uint8_t>{255, 0});
    file.write_text("text", text);
    file.write_text("no text", "");
    file.write_value("a b/c", -1.5f);
    id = file.finish();
  }
  EXPECT_EQ(std::filesystem::file_size(directory / "f"), id.size);

  const CheckpointFileReader file(directory / "f", id);
  EXPECT_TRUE(file.id() == id);
  const auto read = file.read<double>("doubles");
  ASSERT_EQ(read.size(), doubles.size());
  EXPECT_EQ(std::memcmp(read.data(), doubles.data(), 8 * doubles.size()), 0);
  EXPECT_EQ(file.read<Corner>("corners"), corners);
  EXPECT_EQ((file.read<std::array<double, 3>>("points")), points);
  EXPECT_TRUE(file.read<float>("nothing").empty());
  EXPECT_EQ(file.read<std::uint8_t>(""), (std::vector<std::uint8_t>{255, 0}));
  EXPECT_EQ(file.read_text("text"), text);
  EXPECT_EQ(file.read_text("no text"), "");
  EXPECT_EQ(file.read_value<float>("a b/c"), -1.5f);
}

TEST(CheckpointFile, NoPaddingIsStored)
{
  EXPECT_TRUE(HasPlainBytes<double>::value);
  EXPECT_TRUE(HasPlainBytes<std::uint8_t>::value);
  EXPECT_TRUE(HasPlainBytes<Corner>::value);
  EXPECT_TRUE((HasPlainBytes<std::array<std::array<double, 3>, 4>>::value));
  EXPECT_FALSE(HasPlainBytes<Padded>::value);
  EXPECT_FALSE((HasPlainBytes<std::array<Padded, 2>>::value));
  EXPECT_FALSE(HasPlainBytes<long double>::value);
  EXPECT_FALSE(HasPlainBytes<std::string>::value);
  EXPECT_FALSE(HasPlainBytes<const char *>::value);
}

// A change of the format needs another number: checkpoint_format.
TEST(CheckpointFile, FormatHasNotChanged)
{
  const TemporaryDirectory directory;
  const SmallFile          small(directory / "f");
  EXPECT_EQ(checkpoint_format, 11u);
  EXPECT_EQ(small.id.size, 225u);
  EXPECT_EQ(small.id.checksum, 8935834153481957747u);
  EXPECT_EQ(small.bytes.substr(0, 24),
            std::string("rift checkpoint\0\13\0\0\0\0\0\0\0", 24));
  EXPECT_EQ(small.bytes.substr(24, 31),
            std::string("\7\0\0\0\0\0\0\0\10\0\0\0\0\0\0\0\3\0\0\0\0\0\0\0"
                        "numbers",
                        31));
}

TEST(CheckpointFile, SameContentGivesTheSameFile)
{
  const TemporaryDirectory directory;
  const SmallFile          a(directory / "a"), b(directory / "b");
  EXPECT_EQ(a.bytes, b.bytes);
  EXPECT_TRUE(a.id == b.id);
}

TEST(CheckpointFile, EachFlippedBitIsFound)
{
  const TemporaryDirectory directory;
  const SmallFile          small(directory / "f");
  for (std::size_t bit = 0; bit < 8 * small.bytes.size(); ++bit)
    {
      std::string bytes = small.bytes;
      bytes[bit / 8] ^= static_cast<char>(1 << bit % 8);
      const std::string failure = small.failure(bytes);
      if (bit < 8 * 16)
        EXPECT_EQ(failure, "does not begin as a checkpoint of rift does.");
      else if (bit < 8 * 24)
        EXPECT_EQ(failure.substr(0, 11), "has format ") << failure;
      else
        {
          std::size_t block = 0;
          while (starts[block + 1] <= bit / 8)
            ++block;
          const std::string place =
            "damaged in the block at byte " + std::to_string(starts[block]);
          EXPECT_TRUE(failure == "is " + place + "." ||
                      failure == "is cut off or " + place + ".")
            << bit << ": " << failure;
        }
    }
}

TEST(CheckpointFile, EachTruncationIsFound)
{
  const TemporaryDirectory directory;
  const SmallFile          small(directory / "f");
  for (std::size_t size = 0; size < small.bytes.size(); ++size)
    {
      const std::string failure = small.failure(small.bytes.substr(0, size));
      if (size < 24)
        EXPECT_EQ(failure, "has only " + std::to_string(size) + " bytes.");
      else
        EXPECT_EQ(failure.substr(0, 42),
                  "is cut off or damaged in the block at byte")
          << size;
    }
}

TEST(CheckpointFile, OtherDamagesAreFound)
{
  const TemporaryDirectory directory;
  const SmallFile          small(directory / "f");
  const auto               block = [&](const unsigned int i) {
    return small.bytes.substr(starts[i], starts[i + 1] - starts[i]);
  };
  const std::string start = small.bytes.substr(0, starts[0]);
  EXPECT_EQ(start + block(0) + block(1) + block(2) + block(3), small.bytes);

  EXPECT_EQ(small.failure(small.bytes + "x"), "has 1 bytes behind its end.");
  EXPECT_EQ(small.failure(small.bytes + small.bytes),
            "has 225 bytes behind its end.");
  const std::string lost = "has not the 3 blocks with which it was written.";
  EXPECT_EQ(small.failure(start + block(0) + block(2) + block(3)), lost);
  EXPECT_EQ(small.failure(start + block(1) + block(0) + block(2) + block(3)),
            lost);
  EXPECT_EQ(small.failure(start + block(0) + block(0) + block(2) + block(3)),
            lost);
  EXPECT_EQ(small.failure(start + block(3)), lost);
  EXPECT_EQ(small.failure(start + block(0) + block(1) + block(2)),
            "is cut off or damaged in the block at byte 174.");

  // As a disk may lose a sector, or give one of another file.
  for (std::size_t begin = 0; begin + 20 <= small.bytes.size(); ++begin)
    for (const char c : {'\0', '\377'})
      {
        std::string bytes = small.bytes;
        bytes.replace(begin, 20, 20, c);
        EXPECT_NE(small.failure(bytes), "(nothing was thrown)");
      }
}

TEST(CheckpointFile, RandomDamagesOfALargeFileAreFound)
{
  const TemporaryDirectory directory;
  std::mt19937             random(1);
  std::vector<double>      values(20000);
  for (double &value : values)
    value = static_cast<double>(random()) - 1e9;
  {
    CheckpointFileWriter file(directory / "f");
    file.write("first", values);
    file.write("second", values);
    file.finish();
  }
  const std::string bytes = read_file(directory / "f");
  for (unsigned int i = 0; i < 1000; ++i)
    {
      std::string       damaged = bytes;
      const std::size_t place   = random() % bytes.size();
      switch (i % 4)
        {
        case 0:
          damaged[place] ^= static_cast<char>(1 << random() % 8);
          break;
        case 1:
          damaged.resize(place);
          break;
        case 2:
          damaged.erase(place, 1 + random() % 100);
          break;
        default:
          damaged.insert(place, 1 + random() % 100, '\0');
        }
      write_file(directory / "f", damaged);
      EXPECT_THROW(CheckpointFileReader(directory / "f"), CheckpointDamaged)
        << i;
    }
}

TEST(CheckpointFile, IsNoFile)
{
  const TemporaryDirectory directory;
  const auto               failure = [&](const std::string &name) {
    const std::string path = directory / name;
    return message_of<CheckpointDamaged>([&] { CheckpointFileReader{path}; })
      .substr(path.size());
  };
  std::filesystem::create_directory(directory / "folder");
  ASSERT_EQ(::mkfifo((directory / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("nowhere", directory / "link");
  write_file(directory / "empty", "");
  write_file(directory / "scene.prm",
             "subsection Mesh\n  set Shape = box\nend");
  EXPECT_EQ(failure("folder"), " is not a file.");
  EXPECT_EQ(failure("pipe"), " is not a file.");
  EXPECT_EQ(failure("link"), " is missing.");
  EXPECT_EQ(failure("no"), " is missing.");
  EXPECT_EQ(failure("empty"), " has only 0 bytes.");
  EXPECT_EQ(failure("empty/f"), " is missing.");
  EXPECT_EQ(failure("scene.prm"),
            " does not begin as a checkpoint of rift does.");
}

TEST(CheckpointFile, OfAnotherFormat)
{
  const TemporaryDirectory directory;
  const SmallFile          small(directory / "f");
  std::string              bytes = small.bytes;
  bytes[16]                      = checkpoint_format + 1;
  EXPECT_EQ(small.failure(bytes),
            "has format " + std::to_string(checkpoint_format + 1) +
              ", and this version of rift reads format " +
              std::to_string(checkpoint_format) + ".");
}

TEST(CheckpointFile, IsAnother)
{
  const TemporaryDirectory directory;
  const SmallFile          small(directory / "f");
  CheckpointFileWriter     other(directory / "g");
  other.write("numbers", std::vector<double>{1});
  const CheckpointFileId id = other.finish();
  EXPECT_EQ(message_of<CheckpointDamaged>(
              [&] { CheckpointFileReader(directory / "f", id); }),
            (directory / "f") +
              " is whole, but is not the file that belongs to this "
              "checkpoint.");
}

TEST(CheckpointFile, HoldsOtherValues)
{
  const TemporaryDirectory   directory;
  const SmallFile            small(directory / "f");
  const CheckpointFileReader file(small.path);
  const auto                 message = [&](const auto &f) {
    return message_of<CheckpointDamaged>(f).substr(small.path.size());
  };
  EXPECT_EQ(message([&] { file.read<double>("nodes"); }), " has no \"nodes\".");
  EXPECT_EQ(message([&] { file.read<double>("end"); }), " has no \"end\".");
  EXPECT_EQ(message([&] { file.read<float>("numbers"); }),
            " has items of 8 bytes in \"numbers\" instead of 4.");
  EXPECT_EQ(message([&] { file.read_text("numbers"); }),
            " has items of 8 bytes in \"numbers\" instead of 1.");
  EXPECT_EQ(message([&] { file.read_value<double>("numbers"); }),
            " has 3 values of \"numbers\" instead of one.");
}

TEST(CheckpointFile, BlocksHaveDifferentNames)
{
  const TemporaryDirectory directory;
  CheckpointFileWriter     file(directory / "f");
  file.write_value("a", 1.);
  EXPECT_EQ(message_of<std::logic_error>([&] { file.write_text("a", "b"); }),
            "CheckpointFileWriter: the name \"a\" is taken");
  EXPECT_THROW(file.write_text("end", "b"), std::logic_error);
}

TEST(CheckpointFile, DiskIsFullAtAnyByte)
{
  const TemporaryDirectory directory;
  const SmallFile          small(directory / "f");
  for (std::size_t size = 0; size < small.bytes.size(); ++size)
    {
      const FileSizeLimit limit(size);
      EXPECT_EQ(message_of<DiskError>([&] { SmallFile::write(small.path); }),
                "Cannot write " + small.path +
                  ": File too large. Raise the limit on the size of a file "
                  "(ulimit -f), or write to another disk.");
    }
  const FileSizeLimit limit(small.bytes.size());
  EXPECT_TRUE(SmallFile::write(small.path) == small.id);
  EXPECT_THROW(SmallFile::write("/dev/full"), DiskError);
}
