#include <rift/cohesive/element_fracture.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** Of the names under which a checkpoint has the fields of Gauss points. */
    const std::string points_prefix = "cohesive points: ";
  } // namespace

  ElementFracture::ElementFracture(
    Discretization                        &body,
    InternalForce                         &internal_force,
    const std::vector<MaterialParameters> &materials,
    const std::vector<StiffnessMatrix>    &stiffnesses,
    const CohesiveParameters              &parameters)
    : Fracture(body.topology)
    , body(body)
    , internal_force(internal_force)
    , materials(materials)
    , stiffnesses(stiffnesses)
    , parameters(parameters)
  {
  }

  void
  ElementFracture::limit_step(StepLimits &limits) const
  {
    if (is_extrinsic())
      for (std::size_t i = 0; i < materials.size(); ++i)
        {
          double &factor = limits.materials[i].stiffness_factor;
          if (materials[i].breakable)
            factor = std::max(factor, parameters.stiffness_factor);
        }
    else
      limits.added_frequency_squared =
        [slopes = IntrinsicPenalty(body.topology,
                                   body.reference,
                                   body.state,
                                   parameters.penalty,
                                   materials,
                                   stiffnesses)](const CellIndex cell) {
          return slopes.frequency_squared(cell);
        };
  }

  void
  ElementFracture::prepare(Discretization &body, const StepBound &bound)
  {
    const PenaltyStiffness stiffness_of =
      is_extrinsic() ? stable_penalty_stiffness(body.topology,
                                                body.reference,
                                                stiffnesses,
                                                body.densities,
                                                bound.frequency_squared) :
                       PenaltyStiffness(IntrinsicPenalty(body.topology,
                                                         body.reference,
                                                         body.state,
                                                         parameters.penalty,
                                                         materials,
                                                         stiffnesses));
    strengths.emplace(body.topology, body.reference, materials, parameters);
    force.emplace(body.topology,
                  body.reference,
                  *strengths,
                  parameters,
                  stiffness_of);
    if (is_extrinsic())
      {
        bounds = strengths->stress_bounds(body.communicator);
        internal_force.watch(bounds);
        insertion.emplace(body.topology,
                          body.reference,
                          internal_force,
                          *strengths,
                          bounds);
      }
    else
      force->start_all(body.state);
  }

  void
  ElementFracture::choose_cuts(const StepContext      &step,
                               std::vector<FaceIndex> &faces)
  {
    if (insertion && !internal_force.hot_cells().empty())
      faces =
        insertion->find_faces(step.body.state, internal_force.hot_cells());
  }

  void
  ElementFracture::account(const Discretization &body,
                           EnergyTable          &energies) const
  {
    const CohesiveEnergy energy = force->energy(body.state);
    energies["cohesive"].add(energy.recoverable);
    energies["fracture"].add(energy.fracture);
    energies["friction"].add(energy.friction);
  }

  void
  ElementFracture::save(const Discretization &, Archive &archive) const
  {
    const CohesiveRecords records = force->records();
    archive.write_list("cohesive faces", records.faces);
    for (const auto &[name, numbers] : records.points)
      archive.write_list(points_prefix + name, numbers);
  }

  void
  ElementFracture::load(const Discretization &body, const Archive &archive)
  {
    CohesiveRecords records;
    records.faces = archive.read_list<CohesiveFaceRecord>("cohesive faces");
    for (const auto &[name, entry] : archive.entries())
      if (name.compare(0, points_prefix.size(), points_prefix) == 0)
        records.points[name.substr(points_prefix.size())] =
          archive.read_list<double>(name);
    force->restore(body.state, records);
  }

  void
  ElementFracture::count_items(const Topology &topology, WorkItems &items) const
  {
    for (const CohesiveFaceInfo &info : force->faces().infos)
      ++items[topology.faces[info.face].cells[0]];
  }
} // namespace rift
