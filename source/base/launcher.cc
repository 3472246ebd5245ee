#include <rift/base/launcher.h>

#include <cstdlib>

namespace rift
{
  std::string
  warning_about_ranks(const int n_ranks)
  {
    for (const char *name :
         {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_NTASKS"})
      {
        const char *value = std::getenv(name);
        const long  n = value == nullptr ? 0 : std::strtol(value, nullptr, 10);
        if (n > n_ranks)
          return std::string(name) + " is " + std::to_string(n) +
                 ", but MPI knows of " + std::to_string(n_ranks) +
                 (n_ranks == 1 ? " rank" : " ranks") +
                 ". If rift was to run on more, start it by the mpirun of the "
                 "MPI that it was built with (Open MPI on Debian); else each "
                 "process computes the whole scene.";
      }
    return "";
  }
} // namespace rift
