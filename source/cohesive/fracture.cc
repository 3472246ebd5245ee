#include <rift/cohesive/fracture.h>

#include <algorithm>

namespace rift
{
  Fracture::Fracture(Discretization                        &body,
                     InternalForce                         &internal_force,
                     const std::vector<MaterialParameters> &materials,
                     const std::vector<StiffnessMatrix>    &stiffnesses,
                     const CohesiveParameters              &parameters)
    : body(body)
    , internal_force(internal_force)
    , materials(materials)
    , stiffnesses(stiffnesses)
    , parameters(parameters)
  {
  }

  void
  Fracture::limit_step(StepLimits &limits) const
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
        [slopes = PenaltySlopes(body.topology,
                                body.reference,
                                body.state,
                                parameters.penalty,
                                materials,
                                stiffnesses)](const CellIndex cell) {
          return slopes.frequency_squared(cell);
        };
  }

  void
  Fracture::prepare(Discretization &body, const StepBound &bound)
  {
    const FaceSlope slope =
      is_extrinsic() ? slopes_that_the_step_allows(body.topology,
                                                   body.reference,
                                                   stiffnesses,
                                                   body.densities,
                                                   bound.frequency_squared) :
                       FaceSlope(PenaltySlopes(body.topology,
                                               body.reference,
                                               body.state,
                                               parameters.penalty,
                                               materials,
                                               stiffnesses));
    strengths.emplace(body.topology,
                      body.reference,
                      materials,
                      parameters,
                      body.communicator);
    force.emplace(body.topology,
                  body.reference,
                  *strengths,
                  parameters.model,
                  slope,
                  parameters.least_share);
    if (is_extrinsic())
      {
        insertion.emplace(body.topology,
                          body.reference,
                          internal_force,
                          *strengths,
                          parameters.least_share);
        internal_force.watch(strengths->stress_bounds());
      }
    else
      force->start_all(body.state);
  }

  void
  Fracture::choose_cuts(const StepContext &step, std::vector<FaceIndex> &faces)
  {
    if (insertion && !internal_force.hot_cells().empty())
      faces =
        insertion->find_faces(step.body.state, internal_force.hot_cells());
  }

  void
  Fracture::account(const Discretization &body, EnergyTable &energies) const
  {
    const CohesiveEnergy energy = force->energy(body.state);
    energies["cohesive"].add(energy.recoverable);
    energies["fracture"].add(energy.fracture);
    energies["friction"].add(energy.friction);
  }

  void
  Fracture::save(const Discretization &, Archive &archive) const
  {
    archive.write_list("cohesive faces", force->records());
  }

  void
  Fracture::load(const Discretization &body, const Archive &archive)
  {
    force->restore(body.state,
                   archive.read_list<CohesiveFaceRecord>("cohesive faces"));
  }

  void
  Fracture::count_items(const Topology &topology, WorkItems &items) const
  {
    for (const CohesiveFaceInfo &info : force->faces().infos)
      ++items[topology.faces[info.face].cells[0]];
  }
} // namespace rift
