#ifndef rift_tests_cohesive_breaking_body_h
#define rift_tests_cohesive_breaking_body_h

#include <rift/cohesive/cohesive_elements_of.h>
#include <rift/cohesive/cohesive_force.h>
#include <rift/cohesive/insertion.h>
#include <rift/cohesive/laws/mohr_coulomb.h>
#include <rift/mesh/mesh_data.h>
#include <rift/time_integration/central_difference.h>
#include <rift/time_integration/critical_time_step.h>
#include <rift/time_integration/energy_ledger.h>

#include "../support/test_body.h"

#include <numeric>

namespace rift::test
{
  /** Granite that breaks. */
  inline MaterialParameters
  granite()
  {
    MaterialParameters material;
    material.name              = "granite";
    material.density           = 2641;
    material.youngs_modulus    = 40.6e9;
    material.poissons_ratio    = .2;
    material.tensile_strength  = 15e6;
    material.cohesion          = 36.7e6;
    material.friction_angle    = 50 * M_PI / 180;
    material.fracture_energy_1 = 400;
    material.fracture_energy_2 = 600;
    return material;
  }

  /** Of any plane in it. */
  inline FaceStrength
  granite_strength()
  {
    return strength_across(granite(), {{1, 0, 0}});
  }

  inline std::vector<Elasticity>
  laws_of(const std::vector<MaterialParameters> &materials)
  {
    std::vector<Elasticity> result;
    for (const auto &material : materials)
      result.push_back(make_elasticity(material));
    return result;
  }

  inline std::vector<StiffnessMatrix>
  stiffnesses_of(const std::vector<MaterialParameters> &materials)
  {
    std::vector<StiffnessMatrix> result;
    for (const Elasticity &law : laws_of(materials))
      result.push_back(stiffness_matrix(law));
    return result;
  }

  /** The elements of a force whose law is known. */
  template <typename Law>
  CohesiveElementsOf<Law> &
  elements_of(CohesiveForce &force)
  {
    return dynamic_cast<CohesiveElementsOf<Law> &>(force.elements_of_law());
  }

  using ExtrinsicLaw = MohrCoulomb<StraightBranch>;

  inline CohesiveParameters
  parameters_of(const CohesiveModel model)
  {
    CohesiveParameters parameters;
    parameters.model = model;
    parameters.law   = "faces";
    return parameters;
  }

  /** A body with the modules that break it, as a simulation has them. */
  struct BreakingBody
  {
    /** @param body a Body, or what this rank sees of one (BodyPart). */
    template <typename AnyBody>
    explicit BreakingBody(
      const AnyBody                  &body,
      std::vector<MaterialParameters> the_materials    = {granite()},
      const double                    stiffness_factor = .25,
      const CohesiveParameters       &parameters =
        parameters_of(CohesiveModel::extrinsic),
      const Communicator &communicator = Communicator())
      : communicator(communicator)
      , materials(std::move(the_materials))
      , discrete(discretize(body, densities_of(materials)))
      , topology(discrete.topology)
      , state(discrete.state)
      , internal_force(topology, discrete.reference, laws_of(materials))
      , activity(topology)
      , strengths(topology, discrete.reference, materials, parameters)
      , bounds(strengths.stress_bounds(communicator))
      , critical(find_critical_time_step(stiffness_factor))
      , insertion(topology,
                  discrete.reference,
                  internal_force,
                  strengths,
                  bounds)
      , force(topology,
              discrete.reference,
              strengths,
              parameters,
              stable_penalty_stiffness(topology,
                                       discrete.reference,
                                       stiffnesses_of(materials),
                                       densities_of(materials),
                                       critical.frequency_squared))
    {
      internal_force.watch(bounds);
      activity.wake_all(topology);
    }

    CriticalTimeStep
    find_critical_time_step(const double stiffness_factor) const
    {
      std::vector<MaterialLimits> limits;
      for (const auto &material : materials)
        limits.push_back({material.name,
                          stiffness_matrix(make_elasticity(material)),
                          material.density,
                          0,
                          material.breakable ? stiffness_factor : 0});
      return critical_time_step(topology,
                                discrete.reference,
                                limits,
                                communicator);
    }

    /** Cuts faces and has everything follow. */
    TopologyChange
    split(std::vector<FaceIndex> faces)
    {
      std::sort(faces.begin(), faces.end());
      const TopologyChange change = split_nodes(topology, faces);
      state.grow(change);
      for (const NodeSplit &split : change.splits)
        for (const NodeIndex part : split.parts)
          state.mass[part] = lumped_mass(topology,
                                         discrete.reference,
                                         densities_of(materials),
                                         part);
      activity.grow(topology.n_nodes());
      force.apply(change);
      return change;
    }

    /** Sums the forces at t_n; false if a cell has left its range. */
    bool
    sum_forces()
    {
      state.force.assign(state.n_nodes(), NodalVector());
      const bool failed = internal_force.add_to(state, activity).has_value();
      force.add_to(state, activity);
      openings = force.hold_partings(state, {});
      return !failed;
    }

    /** Has the faces take over what sum_forces() has held together. */
    void
    start_openings()
    {
      force.start_openings(state, std::move(openings));
      openings.clear();
    }

    /** Goes to t_(n+1) after sum_forces(). */
    void
    move(const double time_step)
    {
      advance(state, activity, time_step);
      start_openings();
    }

    Energies
    energies(const double time_step) const
    {
      const CohesiveEnergy cohesive = force.energy(state);
      EnergyTable          sums;
      sums["kinetic"]  = kinetic_energy(topology, state, time_step);
      sums["strain"]   = internal_force.strain_energy(state);
      sums["cohesive"] = cohesive.recoverable;
      sums["fracture"] = cohesive.fracture;
      sums["friction"] = cohesive.friction;
      return sums.total(communicator);
    }

    std::vector<FaceIndex>
    all_faces() const
    {
      std::vector<FaceIndex> faces(topology.faces.size());
      std::iota(faces.begin(), faces.end(), 0);
      return faces;
    }

    /** The interior faces that lie in the plane X_component = value. */
    std::vector<FaceIndex>
    faces_in_plane(const unsigned int component, const double value) const
    {
      std::vector<FaceIndex> faces;
      for (FaceIndex face = 0; face < topology.faces.size(); ++face)
        {
          const Face &f         = topology.faces[face];
          bool        is_inside = true;
          for (const unsigned int c : face_corners[f.local_faces[0]])
            is_inside &=
              std::abs(
                state.reference[topology.node(f.cells[0], c)][component] -
                value) < 1e-9;
          if (is_inside)
            faces.push_back(face);
        }
      return faces;
    }

    const Communicator              communicator;
    std::vector<MaterialParameters> materials;
    DiscreteBody                    discrete;
    Topology                       &topology;
    State                          &state;
    InternalForce                   internal_force;
    Activity                        activity;
    FaceStrengths                   strengths;
    StressBounds                    bounds;
    CriticalTimeStep                critical;
    Insertion                       insertion;
    CohesiveForce                   force;
    std::vector<OpeningCorner>      openings;
  };
} // namespace rift::test

#endif
