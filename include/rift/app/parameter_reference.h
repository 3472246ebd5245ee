#ifndef rift_app_parameter_reference_h
#define rift_app_parameter_reference_h

#include <iosfwd>

namespace rift
{
  /**
   * Prints a small scene in which every entry stands with its meaning; those
   * that the scene does not need are commented out and show their default. It
   * can be run as it is.
   */
  void
  print_defaults(std::ostream &out);

  /** Prints doc/parameters.md: a table of the entries of each subsection. */
  void
  generate_reference(std::ostream &out);
} // namespace rift

#endif
