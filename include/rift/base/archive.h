#ifndef rift_base_archive_h
#define rift_base_archive_h

#include <rift/base/check.h>
#include <rift/base/exact_sum.h>
#include <rift/base/plain_bytes.h>

#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace rift
{
  /**
   * Everything that a run needs to continue, by name. Whoever has state to keep
   * writes it under names of its own and reads it back by the same names; there
   * is no other list of what is stored.
   *
   * What is written must not depend on how the body is divided among the ranks:
   * a run may continue on any number of them. There are three kinds of entries:
   * - a *list* holds the items that this rank owns. After a restart every rank
   *   reads the items of all ranks, in no particular order.
   * - a *value* is the same on all ranks.
   * - a *sum* is the part of this rank of a total over all ranks. After a
   *   restart rank 0 has the total and all others have nothing.
   */
  class Archive
  {
  public:
    /** What an entry holds; see Archive. */
    enum class Kind : std::uint8_t
    {
      list,
      value,
      sum
    };

    /** @throws std::logic_error, as all `write` functions, for a name that
     * occurs twice. */
    template <typename T>
    void
    write_list(const std::string &name, const std::vector<T> &items)
    {
      write(name, Kind::list, sizeof(T), items.data(), items.size());
      static_assert(HasPlainBytes<T>::value, "an archive stores no padding");
    }

    /** Adds a value, which must be the same on all ranks. */
    template <typename T>
    void
    write_value(const std::string &name, const T &value)
    {
      write(name, Kind::value, sizeof(T), &value, 1);
      static_assert(HasPlainBytes<T>::value, "an archive stores no padding");
    }

    /** Adds the part of this rank of a sum. */
    void
    write_sum(const std::string &name, const ExactSum &sum)
    {
      const ExactSum::Digits digits = sum.digits();
      write(name, Kind::sum, sizeof(digits), &digits, 1);
    }

    /** @throws InputError, as all `read` functions, if there is no such entry:
     * the checkpoint is that of a program with other modules. */
    template <typename T>
    std::vector<T>
    read_list(const std::string &name) const
    {
      const Entry &entry = find(name, Kind::list, sizeof(T));
      rift_check(entry.bytes.size() % sizeof(T) == 0);
      std::vector<T> items(entry.bytes.size() / sizeof(T));
      if (!items.empty())
        std::memcpy(items.data(), entry.bytes.data(), entry.bytes.size());
      return items;
    }

    /** The value of this name. Throws InputError if there is none of this
     * size. */
    template <typename T>
    T
    read_value(const std::string &name) const
    {
      T value;
      std::memcpy(&value,
                  find(name, Kind::value, sizeof(T)).bytes.data(),
                  sizeof(T));
      return value;
    }

    /** The part of this rank of the sum of this name. Throws InputError if
     * there is none. */
    ExactSum
    read_sum(const std::string &name) const;

    /** One entry as bytes, for the file that holds it. */
    struct Entry
    {
      /** What it is, the bytes of one item, and all items one after the
       * other. */
      Kind          kind;
      std::uint64_t item_size;
      std::string   bytes;
    };

    /** All entries by name. */
    const std::map<std::string, Entry> &
    entries() const
    {
      return all;
    }

    /** Takes in an entry of one more rank. */
    void
    merge(const std::string &name, const Entry &entry);

    /** Removes what rank 0 alone must have: the sums. */
    void
    clear_sums();

  private:
    void
    write(const std::string &name,
          Kind               kind,
          std::size_t        item_size,
          const void        *items,
          std::size_t        n_items);

    const Entry &
    find(const std::string &name, Kind kind, std::size_t item_size) const;

    std::map<std::string, Entry> all;
  };
} // namespace rift

#endif
