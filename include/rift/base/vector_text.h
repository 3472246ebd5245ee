#ifndef rift_base_vector_text_h
#define rift_base_vector_text_h

#include <rift/base/parameter_text.h>
#include <rift/base/vector3.h>

namespace rift
{
  /** "(0, 0.1, 0) m", for messages. */
  inline std::string
  place_text(const Vector3<double> &x)
  {
    return "(" + short_text(x[0]) + ", " + short_text(x[1]) + ", " +
           short_text(x[2]) + ") m";
  }
} // namespace rift

#endif
