#include <rift/io/checkpoint_file.h>

#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>

namespace rift
{
  namespace
  {
    static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
                  "the numbers in the files are little-endian");

    /** How a file begins. */
    struct Start
    {
      std::array<char, 16> magic  = {{"rift checkpoint"}};
      std::uint64_t        format = checkpoint_format;
    };

    /** How a block begins; its name and its items follow. */
    struct BlockHeader
    {
      std::uint64_t name_size, item_size, n_items;
    };

    constexpr std::size_t checksum_size = sizeof(std::uint64_t);

    /** Name of the last block: the number of those before, their checksum. */
    const char *const end_name = "end";
    using End                  = std::array<std::uint64_t, 2>;

    template <typename T>
    std::string_view
    bytes_of(const T &value)
    {
      return {reinterpret_cast<const char *>(&value), sizeof(T)};
    }

    std::uint64_t
    checksum_of(const std::initializer_list<std::string_view> &parts)
    {
      XXH3_state_t *state = XXH3_createState();
      if (state == nullptr)
        throw std::bad_alloc();
      XXH3_64bits_reset(state);
      for (const std::string_view part : parts)
        XXH3_64bits_update(state, part.data(), part.size());
      const std::uint64_t checksum = XXH3_64bits_digest(state);
      XXH3_freeState(state);
      return checksum;
    }

    End
    end_of(const std::vector<std::uint64_t> &checksums)
    {
      return {{checksums.size(),
               XXH3_64bits(checksums.data(),
                           checksums.size() * sizeof(std::uint64_t))}};
    }

    std::string
    read_whole(const std::string &path)
    {
      namespace fs = std::filesystem;
      std::error_code error;
      const auto      status = fs::status(path, error);
      if (!fs::exists(status))
        throw CheckpointDamaged(path, "is missing");
      if (!fs::is_regular_file(status))
        throw CheckpointDamaged(path, "is not a file");

      std::string result;
      const auto  size = fs::file_size(path, error);
      try
        {
          result.resize(error ? 0 : size);
        }
      catch (const std::exception &) // too long or too large
        {
          throw CheckpointDamaged(path,
                                  "has " + std::to_string(size) +
                                    " bytes, more than fit into the memory");
        }
      errno = 0;
      std::ifstream file(path, std::ios::binary);
      if (error || !file.read(result.data(), result.size()))
        throw CheckpointDamaged(
          path,
          std::string("cannot be read: ") +
            (errno != 0 ? std::strerror(errno) : "it ends too early"));
      return result;
    }

    /** Of the names of blocks that hold entries of an archive. */
    std::string
    prefix_of(const Archive::Kind kind)
    {
      switch (kind)
        {
        case Archive::Kind::list:
          return "list/";
        case Archive::Kind::value:
          return "value/";
        default:
          return "sum/";
        }
    }
  } // namespace

  CheckpointFileWriter::CheckpointFileWriter(const std::string &path)
    : file(path)
  {
    file.write(bytes_of(Start()));
  }

  void
  CheckpointFileWriter::write_block(const std::string &name,
                                    const std::size_t  item_size,
                                    const void        *items,
                                    const std::size_t  n_items)
  {
    if (name == end_name || std::count(names.begin(), names.end(), name) > 0)
      throw std::logic_error("CheckpointFileWriter: the name \"" + name +
                             "\" is taken");
    names.push_back(name);
    checksums.push_back(append_block(name, item_size, items, n_items));
  }

  std::uint64_t
  CheckpointFileWriter::append_block(const std::string &name,
                                     const std::size_t  item_size,
                                     const void        *items,
                                     const std::size_t  n_items)
  {
    const BlockHeader      header{name.size(), item_size, n_items};
    const std::string_view data(static_cast<const char *>(items),
                                item_size * n_items);
    const std::uint64_t checksum = checksum_of({bytes_of(header), name, data});
    file.write(bytes_of(header));
    file.write(name);
    file.write(data);
    file.write(bytes_of(checksum));
    return checksum;
  }

  void
  CheckpointFileWriter::write(const Archive &archive)
  {
    for (const auto &[name, entry] : archive.entries())
      write_block(prefix_of(entry.kind) + name,
                  entry.item_size,
                  entry.bytes.data(),
                  entry.bytes.size() / entry.item_size);
  }

  CheckpointFileId
  CheckpointFileWriter::finish()
  {
    const End end = end_of(checksums);
    append_block(end_name, sizeof(end[0]), end.data(), end.size());
    file.synchronize();
    file.close();
    return {file.size(), end[1]};
  }

  CheckpointFileReader::CheckpointFileReader(const std::string &path)
    : path(path)
    , bytes(read_whole(path))
  {
    check_start();
    std::vector<std::uint64_t> checksums;
    Block                      block = read_block(sizeof(Start));
    for (; block.name != end_name; block = read_block(block.end))
      {
        blocks.push_back(block);
        checksums.push_back(block.checksum);
      }

    const End expected = end_of(checksums);
    End       found    = {};
    if (block.item_size * block.n_items == sizeof(End))
      std::memcpy(&found, items_of(block), sizeof(End));
    if (found != expected)
      fail("has not the " + std::to_string(found[0]) +
           " blocks with which it was written");
    if (block.end != bytes.size())
      fail("has " + std::to_string(bytes.size() - block.end) +
           " bytes behind its end");
    own_id = {bytes.size(), expected[1]};
  }

  CheckpointFileReader::CheckpointFileReader(const std::string      &path,
                                             const CheckpointFileId &expected)
    : CheckpointFileReader(path)
  {
    if (!(own_id == expected))
      fail("is whole, but is not the file that belongs to this checkpoint");
  }

  void
  CheckpointFileReader::check_start() const
  {
    const Start expected;
    Start       found;
    if (bytes.size() < sizeof(Start))
      fail("has only " + std::to_string(bytes.size()) + " bytes");
    std::memcpy(&found, bytes.data(), sizeof(Start));
    if (found.magic != expected.magic)
      fail("does not begin as a checkpoint of rift does");
    if (found.format != expected.format)
      fail("has format " + std::to_string(found.format) +
           ", and this version of rift reads format " +
           std::to_string(expected.format));
  }

  CheckpointFileReader::Block
  CheckpointFileReader::read_block(const std::size_t begin) const
  {
    const std::string at = " in the block at byte " + std::to_string(begin);
    // Sizes are compared with what is left before they are added: a damaged
    // one may be anything.
    std::size_t left  = bytes.size() - begin;
    const auto  leave = [&](const std::size_t n_bytes) {
      if (n_bytes > left)
        fail("is cut off or damaged" + at);
      left -= n_bytes;
    };
    BlockHeader header;
    leave(sizeof(header));
    std::memcpy(&header, bytes.data() + begin, sizeof(header));
    leave(header.name_size);
    if (header.item_size == 0 || header.n_items > left / header.item_size)
      fail("is cut off or damaged" + at);
    leave(header.item_size * header.n_items);
    leave(checksum_size);

    Block             block;
    const std::size_t name = begin + sizeof(header);
    block.item_size        = header.item_size;
    block.n_items          = header.n_items;
    block.items            = name + header.name_size;
    block.end              = bytes.size() - left;
    const std::size_t size = block.end - checksum_size - begin;
    std::memcpy(&block.checksum, bytes.data() + begin + size, checksum_size);
    if (block.checksum != XXH3_64bits(bytes.data() + begin, size))
      fail("is damaged" + at);
    block.name = bytes.substr(name, header.name_size);
    return block;
  }

  void
  CheckpointFileReader::merge_into(Archive &archive) const
  {
    for (const Block &block : blocks)
      for (const Archive::Kind kind :
           {Archive::Kind::list, Archive::Kind::value, Archive::Kind::sum})
        if (const std::string prefix = prefix_of(kind);
            block.name.compare(0, prefix.size(), prefix) == 0)
          archive.merge(block.name.substr(prefix.size()),
                        {kind,
                         block.item_size,
                         {items_of(block), block.item_size * block.n_items}});
  }

  const CheckpointFileReader::Block &
  CheckpointFileReader::find(const std::string &name,
                             const std::size_t  item_size) const
  {
    for (const Block &block : blocks)
      if (block.name == name)
        {
          if (block.item_size != item_size)
            fail("has items of " + std::to_string(block.item_size) +
                 " bytes in \"" + name + "\" instead of " +
                 std::to_string(item_size));
          return block;
        }
    fail("has no \"" + name + "\"");
  }
} // namespace rift
