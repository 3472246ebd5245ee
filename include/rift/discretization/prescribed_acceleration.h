#ifndef rift_discretization_prescribed_acceleration_h
#define rift_discretization_prescribed_acceleration_h

#include <rift/base/types.h>

#include <functional>
#include <optional>

namespace rift
{
  /** Acceleration of a component of a node, m/s^2, if it is prescribed; empty
   * where none is. */
  using PrescribedAcceleration =
    std::function<std::optional<double>(NodeIndex, unsigned int)>;
} // namespace rift

#endif
