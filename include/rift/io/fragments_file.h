#ifndef rift_io_fragments_file_h
#define rift_io_fragments_file_h

#include <rift/discretization/fragments.h>

#include <string>

namespace rift
{
  /** Writes fragments.csv. @throws DiskError if it cannot be written. */
  void
  write_fragments(const std::string           &path,
                  const std::vector<Fragment> &fragments);
} // namespace rift

#endif
