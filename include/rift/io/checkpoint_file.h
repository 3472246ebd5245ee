#ifndef rift_io_checkpoint_file_h
#define rift_io_checkpoint_file_h

#include <rift/base/archive.h>
#include <rift/base/exceptions.h>
#include <rift/base/output_file.h>
#include <rift/base/plain_bytes.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

/**
 * @file
 *
 * One file of a checkpoint: named blocks of numbers, each with a checksum.
 * doc/architecture.md, "Checkpoints", has the format and says why it is none of
 * those that deal.II offers.
 */
namespace rift
{
  /**
   * Number of the format: of this file, of the sets, and of what the simulation
   * stores in them. A file of another number is refused.
   */
  constexpr std::uint64_t checkpoint_format = 11;

  /** A file of a checkpoint is not what has been written. */
  class CheckpointDamaged : public InputError
  {
  public:
    /** @param problem follows the path: "is missing". */
    CheckpointDamaged(const std::string &path, const std::string &problem)
      : InputError(path + " " + problem + ".")
    {
    }
  };

  /** By what the content of a file is known. */
  struct CheckpointFileId
  {
    /** Length in bytes. */
    std::uint64_t size = 0;

    /** Of all blocks, as it stands at the end of the file. */
    std::uint64_t checksum = 0;

    /** Whether both are the same file, as far as size and checksum tell. */
    bool
    operator==(const CheckpointFileId &other) const
    {
      return size == other.size && checksum == other.checksum;
    }
  };

  /** Writes a file block by block. */
  class CheckpointFileWriter
  {
  public:
    /** @throws DiskError, as all of its functions do. */
    explicit CheckpointFileWriter(const std::string &path);

    /**
     * Writes the block `name`.
     *
     * @throws std::logic_error if there is one of that name, or for "end".
     */
    template <typename T>
    void
    write(const std::string &name, const std::vector<T> &values)
    {
      static_assert(HasPlainBytes<T>::value, "a checkpoint stores no padding");
      write_block(name, sizeof(T), values.data(), values.size());
    }

    /** Writes a block of one number or structure. */
    template <typename T>
    void
    write_value(const std::string &name, const T &value)
    {
      static_assert(HasPlainBytes<T>::value, "a checkpoint stores no padding");
      write_block(name, sizeof(T), &value, 1);
    }

    /** Adds a block with a text. */
    void
    write_text(const std::string &name, const std::string &text)
    {
      write_block(name, 1, text.data(), text.size());
    }

    /** Writes a block for each entry. */
    void
    write(const Archive &archive);

    /** Ends the file and brings it to the disk. Nothing can follow. */
    CheckpointFileId
    finish();

  private:
    void
    write_block(const std::string &name,
                std::size_t        item_size,
                const void        *items,
                std::size_t        n_items);

    /** Writes a block, whatever its name, and returns its checksum. */
    std::uint64_t
    append_block(const std::string &name,
                 std::size_t        item_size,
                 const void        *items,
                 std::size_t        n_items);

    OutputFile                 file;
    std::vector<std::string>   names;
    std::vector<std::uint64_t> checksums;
  };

  /**
   * A file that has been read and found to be whole. What it holds is in
   * memory; nothing is read later.
   */
  class CheckpointFileReader
  {
  public:
    /** @throws CheckpointDamaged if a single bit is not as it was written. */
    explicit CheckpointFileReader(const std::string &path);

    /** Also throws CheckpointDamaged if it is not the file that is meant. */
    CheckpointFileReader(const std::string      &path,
                         const CheckpointFileId &expected);

    /** Length and checksum of the file. */
    const CheckpointFileId &
    id() const
    {
      return own_id;
    }

    /**
     * The values of the block `name`.
     *
     * @throws CheckpointDamaged if there is no such block, or if its items are
     *   of another size than a T.
     */
    template <typename T>
    std::vector<T>
    read(const std::string &name) const
    {
      static_assert(HasPlainBytes<T>::value, "a checkpoint stores no padding");
      const Block   &block = find(name, sizeof(T));
      std::vector<T> values(block.n_items);
      if (!values.empty())
        std::memcpy(values.data(), items_of(block), sizeof(T) * values.size());
      return values;
    }

    /** Also throws CheckpointDamaged unless the block has one item. */
    template <typename T>
    T
    read_value(const std::string &name) const
    {
      const std::vector<T> values = read<T>(name);
      if (values.size() != 1)
        fail("has " + std::to_string(values.size()) + " values of \"" + name +
             "\" instead of one");
      return values.front();
    }

    /** The text of the block of this name. Throws CheckpointDamaged if there is
     * none. */
    std::string
    read_text(const std::string &name) const
    {
      const Block &block = find(name, 1);
      return std::string(items_of(block), block.n_items);
    }

    /** Adds the entries that an archive has written, those of one rank. */
    void
    merge_into(Archive &archive) const;

  private:
    struct Block
    {
      std::string   name;
      std::uint64_t item_size, n_items, checksum;

      /** Where its items begin, and where the next block does. */
      std::size_t items, end;
    };

    void
    check_start() const;

    /** The block that begins at a byte, if it is there and undamaged. */
    Block
    read_block(std::size_t begin) const;

    [[noreturn]] void
    fail(const std::string &problem) const
    {
      throw CheckpointDamaged(path, problem);
    }

    const Block &
    find(const std::string &name, std::size_t item_size) const;

    const char *
    items_of(const Block &block) const
    {
      return bytes.data() + block.items;
    }

    std::string        path;
    std::string        bytes;
    std::vector<Block> blocks;
    CheckpointFileId   own_id;
  };
} // namespace rift

#endif
