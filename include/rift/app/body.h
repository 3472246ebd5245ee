#ifndef rift_app_body_h
#define rift_app_body_h

#include <rift/app/parameters.h>
#include <rift/base/communicator.h>
#include <rift/discretization/discretization.h>
#include <rift/io/log.h>
#include <rift/mesh/surface.h>

#include <map>

namespace rift
{
  /** The body of a scene, meshed and discretised, with its names. */
  struct Body
  {
    /** The ranks over which the body is spread. */
    Communicator communicator;

    Discretization discretization;

    /** By material index of the mesh. */
    std::vector<MaterialParameters> materials;

    /** The named parts of its outer surface. */
    std::map<std::string, Surface> surfaces;

    /** Named faces inside of it, such as joints; one side of each. */
    std::map<std::string, Surface> internal_surfaces;
  };

  /**
   * Reads or makes the mesh, checks it, and fits it together with what the
   * .prm says of its materials and boundaries.
   *
   * @throws InputError for a bad mesh and for names that do not match.
   */
  Body
  make_body(const Parameters   &parameters,
            const Communicator &communicator,
            Log                &log);
} // namespace rift

#endif
