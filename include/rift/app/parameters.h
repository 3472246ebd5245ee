#ifndef rift_app_parameters_h
#define rift_app_parameters_h

#include <rift/cohesive/cohesive_parameters.h>
#include <rift/io/output_parameters.h>
#include <rift/loading/loading_parameters.h>
#include <rift/material/material_parameters.h>
#include <rift/mesh/mesh_parameters.h>
#include <rift/time_integration/time_parameters.h>

#include <string>
#include <vector>

namespace rift
{
  /** All that a .prm says, in the order of its file. */
  struct Parameters
  {
    std::string title;

    MeshParameters                  mesh;
    std::vector<MaterialParameters> materials;
    std::vector<BoundaryParameters> boundaries;
    BodyForceParameters             body_force;
    CohesiveParameters              cohesive;
    TimeParameters                  time;
    OutputParameters                output;
    std::vector<ProbeParameters>    probes;
  };

} // namespace rift

#endif
