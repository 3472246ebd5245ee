#ifndef rift_base_bytes_h
#define rift_base_bytes_h

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace rift
{
  /** Plain data as bytes, to be sent to other ranks. */
  template <typename T>
  std::string
  to_bytes(const std::vector<T> &data)
  {
    static_assert(std::is_trivially_copyable_v<T>, "no plain data");
    return {reinterpret_cast<const char *>(data.data()),
            data.size() * sizeof(T)};
  }

  /** The inverse of to_bytes(). */
  template <typename T>
  std::vector<T>
  from_bytes(const std::string &bytes)
  {
    static_assert(std::is_trivially_copyable_v<T>, "no plain data");
    std::vector<T> data(bytes.size() / sizeof(T));
    if (!data.empty())
      std::memcpy(data.data(), bytes.data(), bytes.size());
    return data;
  }
} // namespace rift

#endif
