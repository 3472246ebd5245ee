#ifndef rift_base_checked_cast_h
#define rift_base_checked_cast_h

#include <rift/base/exceptions.h>

#include <cstddef>
#include <limits>
#include <string>

namespace rift
{
  /**
   * A number of things as an integer of few bits, as indices are.
   *
   * @tparam To an integer type, whose largest value is the index of nothing and
   *   must not be reached.
   * @param things what is counted, such as "cells of the mesh".
   * @throws InputError if there are too many.
   */
  template <typename To>
  To
  checked_cast(const std::size_t number, const std::string &things)
  {
    constexpr std::size_t limit = std::numeric_limits<To>::max();
    if (number >= limit)
      throw InputError("there are " + std::to_string(number) + " " + things +
                       ", but rift counts fewer than " + std::to_string(limit) +
                       ". Use larger elements, or more ranks.");
    return static_cast<To>(number);
  }
} // namespace rift

#endif
