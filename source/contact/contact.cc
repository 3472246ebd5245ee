#include <rift/base/number_text.h>
#include <rift/base/parameter_text.h>
#include <rift/contact/contact.h>
#include <rift/contact/contact_penalty.h>
#include <rift/solid/cell_frequency.h>

#include <algorithm>
#include <limits>

namespace rift
{
  Contact::Contact(Discretization                        &body,
                   const std::vector<MaterialParameters> &materials,
                   const std::vector<StiffnessMatrix>    &stiffnesses,
                   const ContactParameters               &parameters,
                   Fracture                              *fracture,
                   RigidCells                             rigid)
    : body(body)
    , materials(materials)
    , stiffnesses(stiffnesses)
    , parameters(parameters)
    , fracture(fracture)
    , rigid(std::move(rigid))
  {
  }

  void
  Contact::limit_step(StepLimits &limits) const
  {
    for (MaterialRoom &room : limits.materials)
      room.stiffness_factor =
        std::max(room.stiffness_factor, parameters.stiffness_factor);
  }

  std::vector<ContactCellConstants>
  Contact::cell_constants(const StepBound &bound) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<ContactCellConstants> constants;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      {
        const ReferenceBatch &batch    = body.reference[cell / batch_size];
        const unsigned int    lane     = cell % batch_size;
        const std::uint16_t   material = body.topology.material(cell);
        const double          density  = body.densities[material];
        const std::uint32_t   of_body =
          rigid.body.empty() ? invalid_index : rigid.body[cell];
        if (body.topology.is_padding(cell))
          constants.push_back({0, 0, invalid_index});
        else if (of_body != invalid_index && rigid.is_driven[material])
          // All of them together are as one body: nothing moves them.
          constants.push_back({infinity, infinity, rigid.n_bodies});
        else
          {
            const double of_cell =
              largest_frequency_squared(batch,
                                        lane,
                                        stiffnesses[material],
                                        density) +
              (bound.added_frequency_squared ?
                 bound.added_frequency_squared(cell) :
                 0);
            const double room = bound.frequency_squared - of_cell;
            constants.push_back({largest_penalty(batch, lane, density, room),
                                 density * batch.volume[lane],
                                 of_body});
          }
      }
    return constants;
  }

  std::vector<std::vector<double>>
  Contact::friction_table() const
  {
    std::vector<std::vector<double>> table;
    for (const MaterialParameters &a : materials)
      {
        table.emplace_back();
        for (const MaterialParameters &b : materials)
          table.back().push_back(parameters.friction_of(a.name, b.name));
      }
    return table;
  }

  void
  Contact::prepare(Discretization &, const StepBound &bound)
  {
    ContactForce::Interface interface;
    interface.cells    = cell_constants(bound);
    interface.damping  = parameters.damping;
    interface.friction = friction_table();
    if (fracture != nullptr)
      fracture->cohesive_force().leave_failed_faces_to_contact(
        ContactForce::look_interval,
        ContactForce::opening);
    force.emplace(body.topology, body.communicator, std::move(interface));
  }

  std::string
  Contact::description() const
  {
    const auto [least, largest] = force->penalty_range();
    return "Contact: penalties of the cells at surfaces from " +
           short_text(least) + " to " + short_text(largest) +
           " Pa, as large as the time step allows";
  }

  void
  Contact::add_forces(StepContext &step)
  {
    const State &state = step.body.state;
    const auto   deep  = force->add_to(step.body.state,
                                    step.body.activity,
                                    state.step > 0 ? step.time_step : 0);
    if (deep)
      step.failures.note(
        {state.step,
         deep->a,
         "cells " + std::to_string(deep->a) + " and " +
           std::to_string(deep->b) + " lie in each other by more than " +
           to_text(largest_mean_potential) +
           " of their height: contact is too soft for this impact or load",
         "Set a larger \"Stiffness factor\" in subsection Contact, or choose a "
         "weaker load."});
  }

  void
  Contact::account(const Discretization &, EnergyTable &energies) const
  {
    energies["contact"].add(force->energy().elastic);
    energies["friction"].add(force->energy().friction);
    energies["damping"].add(force->energy().damping);
  }

  void
  Contact::save(const Discretization &, Archive &archive) const
  {
    force->save(archive);
  }

  void
  Contact::load(const Discretization &body, const Archive &archive)
  {
    force->load(body.state, archive);
  }
} // namespace rift
