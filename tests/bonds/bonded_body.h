#ifndef rift_tests_bonds_bonded_body_h
#define rift_tests_bonds_bonded_body_h

#include <rift/bonds/bonds.h>
#include <rift/solid/internal_force.h>
#include <rift/time_integration/central_difference.h>
#include <rift/time_integration/energy_ledger.h>

#include "../cohesive/breaking_body.h"

namespace rift::test
{
  /** A body with bonds between the parts of nodes that a test cuts. */
  struct BondedBody
  {
    explicit BondedBody(
      const Body                            &body,
      const std::vector<MaterialParameters> &the_materials = {granite()})
      : BondedBody(discretize(body, densities_of(the_materials)), the_materials)
    {
    }

    /** Of a body whose cells have an order of their own. */
    BondedBody(DiscreteBody                           the_body,
               const std::vector<MaterialParameters> &the_materials)
      : materials(the_materials)
      , discrete(std::move(the_body))
      , topology(discrete.topology)
      , state(discrete.state)
      , internal_force(topology, discrete.reference, laws_of(materials))
      , activity(topology)
      , strengths(topology, state.reference, materials, 1)
      , bonds(topology, discrete.reference, strengths, planes)
    {
      activity.wake_all(topology);
    }

    /** Cuts faces for a crack plane, and has everything follow. */
    void
    split(std::vector<FaceIndex> faces,
          const Vector3<double> &plane,
          const double           time_step)
    {
      std::sort(faces.begin(), faces.end());
      for (const FaceIndex face : faces)
        planes.of_faces[face] = plane;
      const TopologyChange change = split_nodes(topology, faces);
      state.grow(change);
      for (const NodeSplit &split : change.splits)
        for (const NodeIndex part : split.parts)
          state.mass[part] = lumped_mass(topology,
                                         discrete.reference,
                                         densities_of(materials),
                                         part);
      activity.grow(topology.n_nodes());
      bonds.rebuild(state, change.splits, time_step);
    }

    /** The interior faces in the plane X_component = value. */
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

    /** Forces of the cells alone; false if a cell has failed. */
    bool
    sum_forces()
    {
      state.force.assign(state.n_nodes(), NodalVector());
      return !internal_force.add_to(state, activity).has_value();
    }

    BondEnergy
    used() const
    {
      BondEnergy sum;
      for (const VertexBonds &group : bonds.vertices())
        {
          sum.fracture += group.energy.fracture;
          sum.friction += group.energy.friction;
          sum.closing += group.energy.closing;
        }
      return sum;
    }

    /** Has the bonds hold, and sums the work of their forces: half of it with
     * the velocities before the kick and half with those after it. */
    void
    hold(const double time_step, const PrescribedAcceleration &prescribed = {})
    {
      const auto before = state.force;
      bonds.hold(state, time_step, prescribed);
      bond_forces.resize(state.n_nodes());
      for (NodeIndex node = 0; node < state.n_nodes(); ++node)
        bond_forces[node] = state.force[node].vector() - before[node].vector();
      add_bond_work(time_step);
    }

    /** After hold(). */
    void
    kick_and_drift(const double time_step)
    {
      advance(state, activity, time_step);
      work_until_now = bond_work;
      add_bond_work(time_step);
    }

    void
    add_bond_work(const double time_step)
    {
      for (NodeIndex node = 0; node < bond_forces.size(); ++node)
        bond_work += .5 * time_step *
                     dot(bond_forces[node], state.velocity[node].vector());
    }

    /** What the bonds say to have used until t_n, less what their forces have
     * taken from the body, J; after kick_and_drift(). */
    double
    unexplained_energy() const
    {
      const BondEnergy sum = used();
      return sum.fracture + sum.friction + sum.closing + work_until_now;
    }

    /** At t_n, after hold(). */
    Energies
    energies(const double time_step, const double loads = 0) const
    {
      const BondEnergy of_bonds = used();
      EnergyTable      sums;
      sums["kinetic"]       = kinetic_energy(topology, state, time_step);
      sums["strain"]        = internal_force.strain_energy(state);
      sums["fracture"]      = ExactSum();
      sums["friction"]      = ExactSum();
      sums["closing"]       = ExactSum();
      Energies result       = sums.total(Communicator());
      result.at("fracture") = of_bonds.fracture;
      result.at("friction") = of_bonds.friction;
      result.at("closing")  = of_bonds.closing;
      result.at("loads")    = loads;
      return result;
    }

    std::vector<MaterialParameters> materials;
    DiscreteBody                    discrete;
    Topology                       &topology;
    State                          &state;
    InternalForce                   internal_force;
    Activity                        activity;
    NodeStrengths                   strengths;
    CrackPlanes                     planes;
    Bonds                           bonds;
    std::vector<Vector3<double>>    bond_forces;
    double                          bond_work = 0, work_until_now = 0;
  };
} // namespace rift::test

#endif
