#include <rift/base/number_text.h>
#include <rift/base/vector_text.h>
#include <rift/contact/contact.h>
#include <rift/solid/cell_frequency.h>

#include <algorithm>
#include <limits>

namespace rift
{
  namespace
  {
    /** What contact takes of the room that the time step leaves. The rest is for
     * damping, which the bound of eq. 27a leaves out, and since a contact that
     * is as stiff as can be is resolved badly where it begins: its energy is
     * then uncertain by the stiffness times the square of the way of a step. */
    constexpr double share_of_room = .5;
  } // namespace

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

  bool
  Contact::is_driven(const CellIndex cell) const
  {
    return !rigid.body.empty() && rigid.body[cell] != invalid_index &&
           rigid.is_driven[body.topology.material(cell)];
  }

  std::vector<ContactCellConstants>
  Contact::cell_constants() const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<ContactCellConstants> constants;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      if (body.topology.is_padding(cell))
        constants.push_back({0, invalid_index});
      else if (is_driven(cell))
        // All of them together are as one body: nothing moves them.
        constants.push_back({infinity, rigid.n_bodies});
      else
        constants.push_back(
          {body.densities[body.topology.material(cell)] *
             body.reference[cell / batch_size].volume[cell % batch_size],
           rigid.body.empty() ? invalid_index : rigid.body[cell]});
    return constants;
  }

  std::vector<double>
  Contact::spare_stiffness(const StepBound &bound) const
  {
    std::vector<double> spare;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      {
        const ReferenceBatch &batch    = body.reference[cell / batch_size];
        const unsigned int    lane     = cell % batch_size;
        const std::uint16_t   material = body.topology.material(cell);
        const double          density  = body.densities[material];
        if (body.topology.is_padding(cell))
          spare.push_back(0);
        else if (is_driven(cell))
          spare.push_back(std::numeric_limits<double>::infinity());
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
            spare.push_back(share_of_room * density * batch.volume[lane] /
                            n_corners * (bound.frequency_squared - of_cell));
          }
      }
    return spare;
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
    const double share_of_element =
      fracture != nullptr ? fracture->share_of_stiffness() : 0;
    if (fracture != nullptr)
      fracture->leave_failed_faces_to_contact(ContactForce::look_interval,
                                              ContactForce::opening);
    force.emplace(
      body.topology,
      body.communicator,
      ContactForce::Interface{cell_constants(),
                              ContactStiffnesses(body.topology,
                                                 body.reference,
                                                 spare_stiffness(bound),
                                                 share_of_element),
                              friction_table(),
                              parameters.damping});
  }

  std::string
  Contact::description() const
  {
    // Two equal bodies face to face: 1/k each, under pressure.
    double       softest = 0, stiffest = 0;
    ExactSum     sum;
    std::int64_t n = 0;
    force->for_each_stiffness(
      [&](const CellIndex cell, const ContactStiffness &stiffness) {
        if (is_driven(cell))
          return;
        const StiffnessMatrix &c = stiffnesses[body.topology.material(cell)];
        const double           modulus = (c[0][0] + c[1][1] + c[2][2]) / 3;
        softest  = std::max(softest, 2 / stiffness.per_area);
        stiffest = std::max(stiffest, stiffness.per_area / 2);
        sum.add(2 * modulus / stiffness.per_area);
        ++n;
      });
    ExactSum::sum_over_ranks({&sum}, body.communicator);
    n        = body.communicator.sum(n);
    softest  = body.communicator.max(softest);
    stiffest = body.communicator.max(stiffest);
    if (n == 0)
      return "Contact: of driven bodies alone";
    return "Contact: surfaces that meet face to face approach by 1 m under " +
           short_text(1 / softest) + " to " + short_text(stiffest) +
           " Pa, as much as " +
           short_text(sum.value() / static_cast<double>(n)) +
           " m of their material, on average; as stiff as the time step allows";
  }

  void
  Contact::add_forces(StepContext &step)
  {
    force->add_to(step.body.state,
                  step.body.activity,
                  step.body.state.step > 0 ? step.time_step : 0);
  }

  std::vector<Warning>
  Contact::warnings_so_far() const
  {
    const auto deep = force->deep_overlaps();
    if (!deep)
      return {};
    const DeepOverlap &first = deep->first;
    return {
      {"contact is too soft for this impact or load",
       ": " + std::to_string(deep->n_pairs) +
         (deep->n_pairs == 1 ? " pair of cells has" : " pairs of cells have") +
         " lain in each other by more than " + to_text(largest_mean_potential) +
         " of the height so far, first cells " + std::to_string(first.a) +
         " and " + std::to_string(first.b) + " at t = " +
         short_text(first.time) + " s at " + place_text(first.place) +
         ". What presses more goes on into the other body. Set a larger "
         "\"Stiffness factor\" in subsection Contact, or choose a weaker "
         "load."}};
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
