#include <rift/app/module_list.h>
#include <rift/bonds/bond_fracture.h>
#include <rift/cohesive/element_fracture.h>
#include <rift/damping/local_damping_parameters.h>
#include <rift/loading/absorbing_boundaries.h>
#include <rift/loading/body_force_parameters.h>
#include <rift/loading/prescribed_motion.h>
#include <rift/loading/surface_load.h>
#include <rift/material/wave_speeds.h>
#include <rift/solid/damping.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    std::unique_ptr<Solid>
    make_solid(const Body &body)
    {
      std::vector<std::string> names;
      for (const MaterialParameters &material : body.materials)
        names.push_back(material.name);
      return std::make_unique<Solid>(body.discretization, body.laws, names);
    }

    std::unique_ptr<Fracture>
    make_fracture(const Parameters &parameters, Body &body, Solid &solid)
    {
      if (parameters.cohesive.model == CohesiveParameters::Model::none)
        return nullptr;
      if (parameters.cohesive.chosen_law() == CohesiveParameters::bonds)
        return std::make_unique<BondFracture>(body.discretization,
                                              solid.internal_force(),
                                              body.materials,
                                              parameters.cohesive.seed);
      return std::make_unique<ElementFracture>(body.discretization,
                                               solid.internal_force(),
                                               body.materials,
                                               body.stiffnesses,
                                               parameters.cohesive);
    }

    std::unique_ptr<RigidBodies>
    make_rigid_bodies(const Body &body, const MeshData &mesh)
    {
      if (std::none_of(body.materials.begin(),
                       body.materials.end(),
                       [](const auto &m) { return m.is_rigid(); }))
        return nullptr;
      RigidPieces pieces;
      body.communicator.on_root(
        [&] { pieces = find_rigid_pieces(mesh, body.materials); });
      return std::make_unique<RigidBodies>(
        body.discretization.topology,
        body.discretization.state,
        broadcast_pieces(pieces, body.communicator),
        body.materials,
        body.communicator);
    }

    RigidCells
    rigid_cells(const Body &body, const RigidBodies *rigid_bodies)
    {
      RigidCells result;
      if (rigid_bodies == nullptr)
        return result;
      const Topology &topology = body.discretization.topology;
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        result.body.push_back(rigid_bodies->body(cell));
      for (std::uint16_t m = 0; m < body.materials.size(); ++m)
        result.is_driven.push_back(rigid_bodies->is_driven(m));
      result.n_bodies = rigid_bodies->n_bodies();
      return result;
    }

    std::unique_ptr<Contact>
    make_contact(const Parameters  &parameters,
                 Body              &body,
                 Fracture          *fracture,
                 const RigidBodies *rigid_bodies)
    {
      if (!parameters.contact.is_active(fracture != nullptr,
                                        count_bodies(body.discretization)))
        return nullptr;
      return std::make_unique<Contact>(body.discretization,
                                       body.materials,
                                       body.stiffnesses,
                                       parameters.contact,
                                       fracture,
                                       rigid_cells(body, rigid_bodies));
    }

    std::unique_ptr<Damping>
    make_damping(const Body &body)
    {
      std::vector<double> viscosities;
      for (const MaterialParameters &material : body.materials)
        viscosities.push_back(material.viscosity);
      if (*std::max_element(viscosities.begin(), viscosities.end()) == 0)
        return nullptr;
      return std::make_unique<Damping>(body.discretization.topology,
                                       body.discretization.reference,
                                       viscosities);
    }

    std::unique_ptr<PrescribedMotion>
    make_prescribed_motion(const Parameters &parameters, const Body &body)
    {
      std::vector<PrescribedMotion::Boundary> moved;
      for (const BoundaryParameters &boundary : parameters.boundaries)
        if (PrescribedMotion::is_needed(boundary))
          moved.push_back({body.surfaces.at(boundary.name), boundary});
      return moved.empty() ?
               nullptr :
               std::make_unique<PrescribedMotion>(body.discretization.topology,
                                                  std::move(moved));
    }

    std::unique_ptr<AbsorbingBoundaries>
    make_absorbing_boundaries(const Parameters &parameters,
                              const Body       &body,
                              const Fracture   *fracture)
    {
      std::vector<AbsorbingBoundaries::Boundary> absorbing;
      for (const BoundaryParameters &boundary : parameters.boundaries)
        if (boundary.absorbs)
          absorbing.push_back({boundary.name, body.surfaces.at(boundary.name)});
      if (absorbing.empty())
        return nullptr;
      return std::make_unique<AbsorbingBoundaries>(
        body.discretization.topology,
        body.discretization.reference,
        std::move(absorbing),
        [&body](const std::uint16_t material, const Vector3<double> &normal) {
          return impedance(body.stiffnesses[material],
                           body.discretization.densities[material],
                           normal);
        },
        fracture == nullptr ? AbsorbingBoundaries::MovingAsOne() :
                              [fracture](const NodeIndex node) {
                                return fracture->nodes_moving_with(node);
                              });
    }
  } // namespace

  std::vector<std::unique_ptr<ModuleParameters>>
  module_parameters()
  {
    std::vector<std::unique_ptr<ModuleParameters>> list;
    list.push_back(std::make_unique<BodyForceParameters>());
    list.push_back(std::make_unique<LocalDampingParameters>());
    return list;
  }

  Modules
  make_modules(const Parameters &parameters, Body &body, const MeshData &mesh)
  {
    Modules    modules;
    const auto add = [&modules](auto module) {
      auto *const pointer = module.get();
      if (pointer != nullptr)
        modules.list.push_back(std::move(module));
      return pointer;
    };

    auto rigid_bodies = make_rigid_bodies(body, mesh);
    modules.solid     = add(make_solid(body));
    modules.fracture  = add(make_fracture(parameters, body, *modules.solid));
    modules.contact =
      add(make_contact(parameters, body, modules.fracture, rigid_bodies.get()));
    for (const BoundaryParameters &boundary : parameters.boundaries)
      if (SurfaceLoad::is_needed(boundary))
        add(std::make_unique<SurfaceLoad>(body.discretization.topology,
                                          body.surfaces.at(boundary.name),
                                          boundary));
    for (const auto &module : parameters.modules)
      add(module->make(body.discretization, body.materials));
    add(make_damping(body));
    // Behind all others that add forces, which its own depend on.
    add(make_absorbing_boundaries(parameters, body, modules.fracture));
    add(make_prescribed_motion(parameters, body));
    modules.rigid_bodies = add(std::move(rigid_bodies));
    std::stable_sort(
      modules.list.begin(),
      modules.list.end(),
      [](const auto &a, const auto &b) { return a->stage() < b->stage(); });
    return modules;
  }
} // namespace rift
