#include <rift/app/simulation.h>
#include <rift/base/parameter_text.h>
#include <rift/mesh/mesh_buffer.h>

#include <algorithm>
#include <cmath>

// How a simulation is saved, and what its cells cost.
namespace rift
{
  Archive
  Simulation::archive() const
  {
    Archive archive;
    archive.write_value("time step", steps.time_step);
    archive.write_list("cell costs", cell_costs());
    body.discretization.save(archive);
    for (const auto &module : modules)
      module->save(body.discretization, archive);
    ledger.save(archive);
    return archive;
  }

  void
  Simulation::write_checkpoint()
  {
    const std::string directory   = parameters.output.directory;
    const Archive     saved       = archive();
    const auto        results_now = results.synchronize();
    if (!checkpoint_writer)
      checkpoint_writer.emplace(
        directory,
        body.communicator,
        write_checkpoint_mesh(directory,
                              body.communicator,
                              [this](CheckpointFileWriter &file) {
                                file.write_text("mesh", pack_mesh(mesh));
                              }),
        parameters.checkpoint.n_sets);
    const std::string problem =
      checkpoint_writer->write(state().step,
                               state().time,
                               used_parameters(parameters),
                               [&](CheckpointFileWriter &file) {
                                 file.write(saved);
                                 results_now.write(file);
                               });
    if (!problem.empty())
      log.warn(problem);
    log.write("Checkpoint at step " + std::to_string(state().step) +
              ", t = " + short_text(state().time) + " s");
    last_checkpoint = std::chrono::steady_clock::now();
    timer.stop(Stage::checkpoints);
  }

  bool
  Simulation::is_unbalanced()
  {
    // What a rank has computed since the last time; all else is waiting, too.
    const double busy    = timer.local_seconds();
    const double seconds = busy - busy_before;
    busy_before          = busy;
    ExactSum sum;
    sum.add(seconds);
    ExactSum::sum_over_ranks({&sum}, body.communicator);
    const double mean    = sum.value() / body.communicator.size();
    const double largest = body.communicator.max(seconds);
    const double limit   = parameters.checkpoint.largest_imbalance;
    return limit > 0 && largest > (1 + limit) * mean;
  }

  double
  Simulation::cost_per_item(const Stage stage, const std::int64_t n_items) const
  {
    // Where there is too little to measure, as on the machine on which rift
    // was written.
    constexpr double usual_cost  = 15;
    const auto       nanoseconds = [this](const Stage of) {
      return std::llround(1e9 * timer.seconds(of));
    };
    std::vector<std::int64_t> sums = {
      n_items,
      nanoseconds(stage),
      static_cast<std::int64_t>(batch_size *
                                body.discretization.activity.n_awake()),
      nanoseconds(Stage::internal_forces)};
    body.communicator.sum(sums);
    if (sums[0] < 100 || sums[1] <= 0 || sums[2] <= 0 || sums[3] <= 0)
      return usual_cost;
    const double per_item = static_cast<double>(sums[1]) / sums[0];
    const double per_cell = static_cast<double>(sums[3]) / sums[2];
    return std::clamp(per_item / per_cell, 1., 100.);
  }

  std::vector<CellCost>
  Simulation::cell_costs() const
  {
    // Looking whether a batch is at rest takes a little, too.
    constexpr double    resting_cost = .02;
    const Topology     &topology     = body.discretization.topology;
    std::vector<double> costs(topology.n_cell_slots());
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      costs[cell] = body.discretization.activity.is_awake(cell / batch_size) ?
                      1 :
                      resting_cost;
    for (const auto &module : modules)
      {
        WorkItems items(topology.n_cell_slots(), 0);
        module->count_items(topology, items);
        std::int64_t n_items = 0;
        for (const std::uint32_t n : items)
          n_items += n;
        const double cost = cost_per_item(module->stage(), n_items);
        for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
          costs[cell] += cost * items[cell];
      }
    std::vector<CellCost> result;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (topology.owns_cell(cell) && costs[cell] != 1)
        result.push_back({topology.cell_global_indices[cell],
                          static_cast<float>(costs[cell])});
    return result;
  }
} // namespace rift
