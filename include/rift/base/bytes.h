#ifndef rift_base_bytes_h
#define rift_base_bytes_h

#include <rift/base/check.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

/**
 * @file
 *
 * Plain data as bytes, to be sent to other ranks.
 */
namespace rift
{
  /** Puts the bytes of `n` objects at the end of a string or vector of char. */
  template <typename Buffer, typename T>
  void
  append(Buffer &buffer, const T *data, const std::size_t n)
  {
    static_assert(std::is_trivially_copyable_v<T>, "no plain data");
    const char *bytes = reinterpret_cast<const char *>(data);
    buffer.insert(buffer.end(), bytes, bytes + n * sizeof(T));
  }

  /**
   * The `n` objects that stand at `bytes`, which moves on behind them. There
   * must be so many.
   */
  template <typename T>
  std::vector<T>
  take(const char *&bytes, const std::size_t n)
  {
    static_assert(std::is_trivially_copyable_v<T>, "no plain data");
    std::vector<T> result(n);
    if (n > 0)
      std::memcpy(result.data(), bytes, n * sizeof(T));
    bytes += n * sizeof(T);
    return result;
  }

  /** The items as bytes, without their number. */
  template <typename T>
  std::string
  to_bytes(const std::vector<T> &data)
  {
    std::string bytes;
    append(bytes, data.data(), data.size());
    return bytes;
  }

  /** The inverse of to_bytes(). */
  template <typename T>
  std::vector<T>
  from_bytes(const std::string &bytes)
  {
    rift_check(bytes.size() % sizeof(T) == 0);
    const char *position = bytes.data();
    return take<T>(position, bytes.size() / sizeof(T));
  }

  /** The bytes of one object. */
  template <typename T>
  std::string
  object_to_bytes(const T &object)
  {
    std::string bytes;
    append(bytes, &object, 1);
    return bytes;
  }

  /** The inverse of object_to_bytes(). */
  template <typename T>
  T
  object_from_bytes(const std::string &bytes)
  {
    static_assert(std::is_trivially_copyable_v<T>, "no plain data");
    rift_check(bytes.size() == sizeof(T));
    T object;
    std::memcpy(&object, bytes.data(), sizeof(T));
    return object;
  }
} // namespace rift

#endif
