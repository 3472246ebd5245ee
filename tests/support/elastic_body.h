#ifndef rift_tests_support_elastic_body_h
#define rift_tests_support_elastic_body_h

#include <rift/mesh/surface.h>
#include <rift/solid/internal_force.h>
#include <rift/time_integration/critical_time_step.h>

#include "tensors.h"
#include "test_body.h"

namespace rift::test
{
  /** The faces of a body that no other cell is at. */
  inline Surface
  whole_surface(const Topology &topology)
  {
    Surface surface;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      for (std::uint8_t f = 0; f < n_corners && !topology.is_padding(cell); ++f)
        if (topology.cell_faces[cell][f] == invalid_index)
          surface.push_back({cell, f});
    return surface;
  }

  /** Those of its faces whose nodes all lie at x[component] = value. */
  inline Surface
  plane_surface(const DiscreteBody &body,
                const unsigned int  component,
                const double        value)
  {
    Surface surface;
    for (const CellFace &face : whole_surface(body.topology))
      {
        bool lies_in_plane = true;
        for (const NodeIndex node : face_nodes(body.topology, face))
          lies_in_plane &=
            std::abs(body.state.reference[node][component] - value) < 1e-9;
        if (lies_in_plane)
          surface.push_back(face);
      }
    return surface;
  }

  /** A body of one material with its elastic forces, all awake. */
  struct ElasticBody
  {
    ElasticBody(const Body &body, const MaterialParameters &material)
      : ElasticBody(discretize(body, {material.density}), material)
    {
    }

    ElasticBody(DiscreteBody body, const MaterialParameters &material)
      : discrete(std::move(body))
      , topology(discrete.topology)
      , state(discrete.state)
      , material(material)
      , force(topology, discrete.reference, {make_elasticity(material)})
      , activity(topology)
    {
      activity.wake_all(topology);
    }

    double
    critical_step(const double viscosity = 0) const
    {
      return critical_time_step(topology,
                                discrete.reference,
                                {{"",
                                  stiffness_matrix(make_elasticity(material)),
                                  material.density,
                                  viscosity,
                                  0}},
                                Communicator())
        .time_step;
    }

    DiscreteBody             discrete;
    Topology                &topology;
    State                   &state;
    const MaterialParameters material;
    InternalForce            force;
    Activity                 activity;
  };
} // namespace rift::test

#endif
