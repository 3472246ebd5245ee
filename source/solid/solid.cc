#include <rift/base/number_text.h>
#include <rift/base/parameter_text.h>
#include <rift/base/vector_text.h>
#include <rift/solid/solid.h>

#include <algorithm>

namespace rift
{
  void
  Solid::add_forces(StepContext &step)
  {
    State     &state  = step.body.state;
    const auto failed = force.add_to(state, step.body.activity);
    if (!failed)
      return;
    const Topology &topology = step.body.topology;
    Vector3<double> centre   = {{0, 0, 0}};
    for (unsigned int c = 0; c < n_corners; ++c)
      centre += .25 * state.reference[topology.node(failed->cell, c)].vector();
    const GlobalCellIndex cell = topology.cell_global_indices[failed->cell];
    step.failures.note(
      {state.step,
       cell,
       "cell " + std::to_string(cell) + " of " +
         material_names[topology.material(failed->cell)] + " at " +
         place_text(centre) + " has " + short_text(failed->volume_ratio) +
         " of its volume; below " +
         to_text(InternalForce::smallest_volume_ratio) +
         " the elastic law has no meaning",
       "Choose a smaller time step or safety factor, or a weaker load."});
  }

  void
  Solid::save(const Discretization &body, Archive &archive) const
  {
    std::vector<GlobalCellIndex> hot;
    for (const CellIndex cell : force.hot_cells())
      if (body.topology.owns_cell(cell))
        hot.push_back(body.topology.cell_global_indices[cell]);
    archive.write_list("hot cells", hot);
  }

  void
  Solid::load(const Discretization &body, const Archive &archive)
  {
    std::vector<CellIndex> hot;
    for (const GlobalCellIndex cell :
         archive.read_list<GlobalCellIndex>("hot cells"))
      if (const CellIndex here = body.topology.find_cell(cell);
          here != invalid_index)
        hot.push_back(here);
    std::sort(hot.begin(), hot.end());
    force.restore_hot_cells(std::move(hot));
  }
} // namespace rift
