#include <rift/app/simulation.h>
#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/base/parameter_comparison.h>
#include <rift/base/parameter_text.h>
#include <rift/mesh/mesh_buffer.h>

#include <algorithm>

// How a simulation is saved and goes on.
namespace rift
{
  template <>
  struct HasPlainBytes<EnergyLedger::Record> : std::true_type
  {
    static_assert(sizeof(EnergyLedger::Record) == 12 * 8);
  };

  namespace
  {
    /** What may change between a checkpoint and the scene that goes on. */
    const std::vector<std::string> may_differ = {
      "Title",
      "Checkpoint",
      "Mesh/Partition",
      "Output/Directory",
      "Output/Overwrite",
      "Output/Ranks per file",
      "Time/End time",
      "Time/Largest energy residual"};

    void
    check_same_scene(const Parameters &parameters, const CheckpointSet &set)
    {
      const auto differences =
        parameter_differences(used_parameters(parameters),
                              set.manifest.parameters,
                              may_differ);
      if (differences.empty())
        return;
      std::string text = "the scene is not that of the checkpoint " + set.path;
      for (const std::string &difference : differences)
        text += "\n  " + difference;
      throw InputError(text + "\nGo on with the same parameters, or start anew "
                              "without --restart.");
    }

    /** Adds sums of one more rank to those of the others. */
    void
    add_sums(const std::vector<ExactSum::Digits> &more,
             std::vector<ExactSum>               &sums)
    {
      sums.resize(more.size());
      for (std::size_t i = 0; i < more.size(); ++i)
        sums[i].add(ExactSum::from_digits(more[i]));
    }

    std::vector<ExactSum::Digits>
    digits_of(const std::vector<ExactSum *> &sums)
    {
      std::vector<ExactSum::Digits> digits;
      for (const ExactSum *sum : sums)
        digits.push_back(sum->digits());
      return digits;
    }
  } // namespace

  Restart
  read_restart(const Parameters   &parameters,
               const Communicator &communicator,
               Log                &log)
  {
    const CheckpointSet set =
      find_checkpoint(parameters.output.directory, communicator);
    for (const std::string &problem : set.damaged)
      log.write("WARNING: " + problem);
    log.write("Going on from " + set.path);
    check_same_scene(parameters, set);

    Restart restart;
    restart.manifest  = set.manifest;
    restart.mesh_file = set.manifest.mesh;
    communicator.together([&] {
      for (std::size_t rank = 0; rank < set.manifest.ranks.size(); ++rank)
        {
          const CheckpointFileReader file = set.read_rank(rank);
          restart.state.read(file);
          add_sums(file.read<ExactSum::Digits>("works"), restart.works);
          if (rank > 0)
            continue;
          restart.time_step = file.read_value<double>("time step");
          restart.face_cost = file.read_value<double>("cost of a face");
          restart.have_cracks_changed =
            file.read_value<std::uint64_t>("cracks have changed");
          restart.ledger  = file.read_value<EnergyLedger::Record>("ledger");
          restart.results = SavedResults::read(file);
        }
      if (communicator.is_root())
        restart.mesh = unpack_mesh(set.read_mesh().read_text("mesh"));
      else
        restart.works.clear();
    });
    return restart;
  }

  void
  Simulation::restore(const Restart &restart)
  {
    const Topology &topology = body.discretization.topology;
    State          &state    = body.discretization.state;
    state.step               = restart.manifest.step;
    state.time               = restart.manifest.time;
    restore_nodes(restart.state, densities, body.discretization, activity);
    update_surfaces();
    if (fracture)
      fracture->force.restore(state, restart.state.cohesive_faces);
    if (rigid_bodies)
      rigid_bodies->restore(restart.state.rigid_bodies);
    if (contact)
      contact->restore(state,
                       restart.state.contact_pairs,
                       restart.state.contact_cells,
                       restart.have_cracks_changed != 0);

    std::vector<CellIndex> hot;
    for (const GlobalCellIndex cell : restart.state.hot_cells)
      if (const CellIndex here = topology.find_cell(cell);
          here != invalid_index)
        hot.push_back(here);
    std::sort(hot.begin(), hot.end());
    internal_force.restore_hot_cells(std::move(hot));

    const auto sums = work_sums();
    for (std::size_t i = 0; i < restart.works.size(); ++i)
      *sums[i] = restart.works[i];
    ledger.restore(restart.ledger);
    checkpoint_writer.emplace(parameters.output.directory,
                              body.communicator,
                              restart.mesh_file,
                              parameters.checkpoint.n_sets);
  }

  std::vector<ExactSum *>
  Simulation::work_sums()
  {
    std::vector<ExactSum *> sums;
    const auto add = [&sums](ExactSum &sum) { sums.push_back(&sum); };
    for (SurfaceLoad &load : surface_loads)
      load.work().for_each_sum(add);
    for (AbsorbingBoundary &boundary : absorbing_boundaries)
      boundary.work().for_each_sum(add);
    if (prescribed_motion)
      prescribed_motion->work().for_each_sum(add);
    if (rigid_bodies)
      rigid_bodies->work().for_each_sum(add);
    if (damping)
      damping->work().for_each_sum(add);
    if (contact)
      contact->for_each_sum(add);
    return sums;
  }

  void
  Simulation::write_checkpoint()
  {
    const std::string directory = parameters.output.directory;
    SavedState        saved     = save_body(body.discretization,
                                 internal_force,
                                 activity,
                                 fracture ? &fracture->force : nullptr,
                                 contact ? &*contact : nullptr);
    if (rigid_bodies && body.communicator.is_root())
      saved.rigid_bodies = rigid_bodies->records();
    const std::uint64_t have_cracks_changed =
      contact && contact->has_changed() ? 1 : 0;
    const auto results_now = results.synchronize();
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
    const std::string problem = checkpoint_writer->write(
      state().step,
      state().time,
      used_parameters(parameters),
      [&](CheckpointFileWriter &file) {
        saved.write(file);
        file.write("works", digits_of(work_sums()));
        file.write_value("time step", dt);
        file.write_value("cost of a face", face_cost());
        file.write_value("cracks have changed", have_cracks_changed);
        file.write_value("ledger", ledger.record());
        results_now.write(file);
      });
    if (!problem.empty())
      log.write("WARNING: " + problem);
    log.write("Checkpoint at step " + std::to_string(state().step) +
              ", t = " + short_text(state().time) + " s");
    last_checkpoint = std::chrono::steady_clock::now();
    timer.stop("checkpoints");
  }

  bool
  Simulation::is_unbalanced()
  {
    // What a rank has computed since the last time; all else is waiting, too.
    double busy = 0;
    for (const char *stage : {"insertion",
                              "internal forces",
                              "cohesive forces",
                              "contact",
                              "loads and damping",
                              "kick and drift"})
      busy += timer.seconds_of(stage);
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
  Simulation::face_cost() const
  {
    // As measured; at the start, and where there is too little to measure, as
    // on the machine on which rift was written.
    constexpr double usual_cost = 15;
    const double     n_faces    = fracture ? fracture->force.faces().size() : 0;
    const double     cells      = timer.seconds_of("internal forces");
    const double     faces      = timer.seconds_of("cohesive forces");
    if (n_faces < 100 || cells <= 0 || faces <= 0)
      return usual_cost;
    const double per_cell = cells / (batch_size * activity.n_awake());
    return std::clamp(faces / n_faces / per_cell, 1., 100.);
  }
} // namespace rift
