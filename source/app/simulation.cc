#include <rift/app/simulation.h>
#include <rift/base/check.h>
#include <rift/base/exceptions.h>
#include <rift/base/floating_point.h>
#include <rift/base/number_text.h>
#include <rift/base/parameter_text.h>
#include <rift/loading/surface_load.h>
#include <rift/mesh/partition.h>
#include <rift/time_integration/central_difference.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** The rank of each cell; on rank 0, which has the mesh. Collective. */
    std::vector<int>
    divide(const Parameters   &parameters,
           const MeshData     &mesh,
           const Communicator &communicator,
           const Restart      *restart)
    {
      std::vector<int> ranks;
      communicator.on_root([&] {
        std::vector<double> costs(mesh.cells.size(), 1.);
        if (restart != nullptr)
          for (const CellCost &of :
               restart->archive.read_list<CellCost>("cell costs"))
            costs.at(of.cell) = of.cost;
        ranks = partition_cells(mesh,
                                communicator.size(),
                                parameters.mesh.partition,
                                costs);
      });
      return ranks;
    }
  } // namespace

  Simulation::Simulation(const Parameters          &parameters,
                         Log                       &log,
                         const Communicator        &communicator,
                         const Restart             *restart,
                         std::shared_ptr<RunRecord> run_record)
    : record(std::move(run_record))
    , timer(record->timer)
    , parameters(parameters)
    , log(log)
    , mesh(restart != nullptr ? restart->mesh :
                                make_mesh(parameters, communicator))
    , body(make_body(parameters,
                     mesh,
                     divide(parameters, mesh, communicator, restart),
                     communicator,
                     log))
    , modules(make_modules(parameters, body, mesh))
    , fragment_watch(body,
                     modules.contact != nullptr,
                     std::all_of(parameters.boundaries.begin(),
                                 parameters.boundaries.end(),
                                 [](const BoundaryParameters &boundary) {
                                   return boundary.acts_while_in_place ||
                                          !SurfaceLoad::is_needed(boundary);
                                 }))
    , results(parameters, body)
  {
    choose_time_step(restart);
    prepare(restart);
    step_of_last_synchronization = this->state().step;
    if (!record->first_step)
      record->first_step = this->state().step;
    timer.stop(Stage::setup);
  }

  void
  Simulation::choose_time_step(const Restart *restart)
  {
    StepLimits limits(body.materials.size());
    for (const auto &module : modules)
      module->limit_step(limits);
    std::vector<MaterialLimits> of_materials;
    for (std::size_t i = 0; i < body.materials.size(); ++i)
      of_materials.push_back({body.materials[i].name,
                              body.stiffnesses[i],
                              body.discretization.densities[i],
                              limits.materials[i].viscosity,
                              limits.materials[i].stiffness_factor});
    critical = critical_time_step(body.discretization.topology,
                                  body.discretization.reference,
                                  of_materials,
                                  body.communicator,
                                  limits.added_frequency_squared);
    std::optional<double> of_checkpoint;
    if (restart != nullptr)
      of_checkpoint = restart->archive.read_value<double>("time step");
    steps = choose_steps(parameters.time, critical, of_checkpoint);
    // At the last step the results of the end may still be missing.
    if (restart != nullptr && restart->manifest.step > steps.last_step)
      throw InputError(
        "the checkpoint is at t = " + to_text(restart->manifest.time) +
        " s, after the end time of " + to_text(parameters.time.end_time) +
        " s. Raise \"End time\" in subsection Time to go on.");
    log.write("Time step " + short_text(steps.time_step) + " s, " +
              short_text(steps.time_step / critical.time_step) +
              " times the bound set by " + critical.limited_by + "; " +
              std::to_string(steps.last_step) + " steps");
    for (const std::string &warning : warnings(steps, critical))
      log.warn(warning);

    for (const auto &module : modules)
      {
        module->prepare(
          body.discretization,
          {critical.frequency_squared, limits.added_frequency_squared});
        if (const std::string text = module->description(); !text.empty())
          log.write(text);
      }
    check_loads();
  }

  void
  Simulation::check_loads() const
  {
    const auto is_prescribed = [this](const NodeIndex    node,
                                      const unsigned int component) {
      return std::any_of(modules.begin(),
                         modules.end(),
                         [&](const auto &module) {
                           return module->prescribes(node, component);
                         });
    };
    for (const auto &module : modules)
      module->check_effect(body.discretization, is_prescribed);
    for (const auto &module : modules)
      for (const std::string &warning : module->warnings(body.discretization,
                                                         steps.time_step,
                                                         steps.last_step))
        log.warn(warning);
    for (const Warning &warning : fragment_watch.warnings_at_start())
      log.warn_once(warning);
  }

  void
  Simulation::prepare(const Restart *restart)
  {
    Discretization &discretization = body.discretization;
    auto &[communicator,
           topology,
           reference,
           state,
           exchange,
           activity,
           _,
           bodies]                 = discretization;
    if (std::any_of(body.materials.begin(),
                    body.materials.end(),
                    [](const MaterialParameters &material) {
                      const Vector3<double> &v = material.initial_velocity;
                      return dot(v, v) > 0;
                    }))
      activity.wake_all(topology);
    exchange.send(topology, state, {}, {});
    exchange.receive(topology, state, activity);
    if (restart == nullptr)
      {
        StepContext step = step_context();
        for (const auto &module : modules)
          module->begin(step);
        return;
      }
    state.step          = restart->manifest.step;
    state.time          = restart->manifest.time;
    const auto vertices = discretization.load(restart->archive);
    for (const auto &module : modules)
      {
        module->update_nodes(vertices);
        module->load(discretization, restart->archive);
      }
    ledger.load(restart->archive);
    saved_results = restart->results;
    checkpoint_writer.emplace(parameters.output.directory,
                              communicator,
                              restart->mesh_file,
                              parameters.checkpoint.n_sets);
  }

  StepContext
  Simulation::step_context()
  {
    const auto prescribed = [this](const NodeIndex    node,
                                   const unsigned int component) {
      std::optional<double> acceleration;
      for (const auto &module : modules)
        if (!acceleration)
          acceleration = module->prescribed_acceleration(state(),
                                                         steps.time_step,
                                                         node,
                                                         component);
      return acceleration;
    };
    return {body.discretization, steps.time_step, failures, prescribed, {}, {}};
  }

  void
  Simulation::step()
  {
    const FlushDenormals flush_denormals;
    State               &state = body.discretization.state;
    StepContext          step  = step_context();
    rift_check(state.n_nodes() == body.discretization.topology.n_nodes());

    // 1. Faces that have reached their strength are cut, and nodes split
    const TopologyChange change = cut_faces(step);
    timer.stop(Stage::insertion);

    // 2. Forces of cells, cohesive faces, contact, loads and damping
    for (const auto &module : modules)
      {
        module->add_forces(step);
        timer.stop(module->stage());
      }

    // 3. Nodes that have parted in this step stay together until its end
    for (const auto &module : modules)
      module->hold_partings(step);
    timer.stop(Stage::cohesive_forces);

    // 4. Velocities start half a step before the first forces
    if (state.step == 0)
      {
        start_velocities(state, steps.time_step);
        for (const auto &module : modules)
          module->start_velocities(step);
      }

    // 5. Absorbing boundaries, prescribed motion, rigid bodies
    guard([&] {
      for (const auto &module : modules)
        module->constrain(step);
    });
    for (const auto &module : modules)
      module->count_work(step);
    timer.stop(Stage::loads);

    // 6. Ledger and output at t_n, when due
    write_due_results();
    timer.stop(Stage::output);

    // 7. Kick and drift to t_(n+1)
    if (state.step == steps.last_step)
      return;
    advance(state, body.discretization.activity, steps.time_step);
    timer.stop(Stage::motion);

    // 8. Ghost cells follow their owners, and contact the new places
    follow_owners(step, change);
    timer.stop(Stage::exchange);
    guard([&] {
      for (const auto &module : modules)
        module->after_drift(step);
    });
    timer.stop(Stage::contact_search);

    // 9. Faces that open take over the forces that have held their nodes
    for (const auto &module : modules)
      module->start_openings(step);
    timer.stop(Stage::cohesive_forces);

    // 10. Loads and warnings follow the pieces of the body
    follow_fragments();
    warn_of_modules();
    timer.stop(Stage::output);
  }

  TopologyChange
  Simulation::cut_faces(StepContext &step)
  {
    std::vector<FaceIndex> faces;
    for (const auto &module : modules)
      module->choose_cuts(step, faces);
    TopologyChange change = body.discretization.cut(faces);
    if (!change.splits.empty())
      for (const auto &module : modules)
        module->follow_cut(step, change);
    return change;
  }

  void
  Simulation::follow_owners(StepContext &step, const TopologyChange &change)
  {
    const auto vertices = body.discretization.follow_owners(change.splits,
                                                            step.openings,
                                                            step.news);
    if (!vertices.empty())
      for (const auto &module : modules)
        module->update_nodes(vertices);
  }
} // namespace rift
