#ifndef rift_base_memory_use_h
#define rift_base_memory_use_h

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace rift
{
  /** Bytes that a list has reserved, without what its items reserve. */
  template <typename T>
  std::uint64_t
  bytes_of(const std::vector<T> &list)
  {
    return list.capacity() * sizeof(T);
  }

  /** Bytes of a table: its buckets, and of each entry a link and where the
   * library keeps its hash. */
  template <typename Key, typename T>
  std::uint64_t
  bytes_of(const std::unordered_map<Key, T> &table)
  {
    return table.bucket_count() * sizeof(void *) +
           table.size() * (sizeof(std::pair<const Key, T>) + sizeof(void *));
  }
} // namespace rift

#endif
