#ifndef rift_loading_loading_parameters_h
#define rift_loading_loading_parameters_h

#include <rift/base/vector3.h>

#include <string>

namespace rift
{
  /**
   * What acts on a named surface: subsection `Boundary NAME` of the .prm. Each
   * entry is the text of a function of time (an expression in t, or a .csv
   * table, whose path is already made relative to the .prm's folder); empty
   * where nothing is prescribed.
   */
  struct BoundaryParameters
  {
    std::string name;

    /** Pressure on the current surface, positive in compression, Pa. */
    std::string pressure;

    /** Components of a traction per reference area, Pa. */
    std::array<std::string, 3> traction;

    /** Prescribed components of the velocity, m/s. */
    std::array<std::string, 3> velocity;
  };

  /** Subsection `Body force`. */
  struct BodyForceParameters
  {
    /** Acceleration of gravity, m/s^2. */
    Vector3<double> gravity = {{0, 0, 0}};
  };
} // namespace rift

#endif
