#include <rift/base/output_file.h>
#include <rift/io/fragments_file.h>

namespace rift
{
  void
  write_fragments(const std::string           &path,
                  const std::vector<Fragment> &fragments)
  {
    HistoryFile file(path,
                     {"fragment",
                      "cells",
                      "volume [m^3]",
                      "mass [kg]",
                      "x [m]",
                      "y [m]",
                      "z [m]",
                      "velocity x [m/s]",
                      "velocity y [m/s]",
                      "velocity z [m/s]"});
    double      number = 0;
    for (const Fragment &f : fragments)
      file.append({number++,
                   static_cast<double>(f.n_cells),
                   f.volume,
                   f.mass,
                   f.centre[0],
                   f.centre[1],
                   f.centre[2],
                   f.velocity[0],
                   f.velocity[1],
                   f.velocity[2]});
    file.flush();
  }
} // namespace rift
