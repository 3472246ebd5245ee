#ifndef rift_base_plain_bytes_h
#define rift_base_plain_bytes_h

#include <array>
#include <type_traits>

namespace rift
{
  /**
   * Whether every byte of a T belongs to its value. Bytes that pad a structure
   * have no value: two files of the same state would differ. The compiler can
   * tell it of structures of integers. One with a `double` may say it of itself
   * by a specialization, beside a static_assert on its size.
   */
  template <typename T>
  struct HasPlainBytes
    : std::bool_constant<!std::is_pointer_v<T> &&
                         (std::has_unique_object_representations_v<T> ||
                          std::is_same_v<T, float> ||
                          std::is_same_v<T, double>)>
  {
  };

  template <typename T, std::size_t n>
  struct HasPlainBytes<std::array<T, n>> : HasPlainBytes<T>
  {
  };
} // namespace rift

#endif
