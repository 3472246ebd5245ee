#ifndef rift_app_body_h
#define rift_app_body_h

#include <rift/app/parameters.h>
#include <rift/base/communicator.h>
#include <rift/discretization/discretization.h>
#include <rift/io/log.h>
#include <rift/material/elasticity.h>
#include <rift/mesh/surface.h>

#include <map>

namespace rift
{
  /** The body of a scene, meshed and discretised, with its names. */
  struct Body
  {
    /** The ranks over which the body is spread. */
    Communicator communicator;

    /** What the steps work on: cells, nodes and their state. */
    Discretization discretization;

    /** By material index of the mesh. */
    std::vector<MaterialParameters> materials;
    std::vector<Elasticity>         laws;
    std::vector<StiffnessMatrix>    stiffnesses;

    /** The named parts of its outer surface. */
    std::map<std::string, Surface> surfaces;

    /** Named faces inside of it, such as joints; one side of each. */
    std::map<std::string, Surface> internal_surfaces;
  };

  /**
   * Reads or makes the mesh, checks it and what the .prm says of its materials
   * and boundaries, and puts its cells in order. The result is on rank 0, the
   * others get an empty one. Collective.
   *
   * @throws InputError for a bad mesh and for names that do not match.
   */
  MeshData
  make_mesh(const Parameters &parameters, const Communicator &communicator);

  /**
   * Divides a mesh among the ranks and makes the body of it. Collective.
   *
   * @param mesh, owners of rank 0 count; see make_triangulation().
   */
  Body
  make_body(const Parameters       &parameters,
            const MeshData         &mesh,
            const std::vector<int> &owners,
            const Communicator     &communicator,
            Log                    &log);
} // namespace rift

#endif
