#include <rift/app/run.h>
#include <rift/app/simulation.h>
#include <rift/base/exceptions.h>
#include <rift/base/floating_point.h>
#include <rift/base/number_text.h>
#include <rift/base/parameter_text.h>
#include <rift/io/progress.h>
#include <rift/mesh/partition.h>
#include <rift/time_integration/central_difference.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace rift
{
  namespace
  {
    /** Number of steps between two looks at the balance of energy. */
    constexpr std::uint64_t balance_interval = 100;

    /** Ranks ask each other about so often whether all goes well... */
    constexpr double seconds_between_agreements = .5;

    /** ... and after so many steps in any case. */
    constexpr std::uint64_t largest_agreement_interval = 100;

    /** No body stands a step above the bound by this. */
    constexpr double largest_step_over_bound = 10;

    /** Years of computing; more is a mistake in the scene. */
    constexpr double largest_number_of_steps = 1e12;

    std::vector<double>
    densities_of(const std::vector<MaterialParameters> &materials)
    {
      std::vector<double> densities;
      for (const MaterialParameters &material : materials)
        densities.push_back(material.density);
      return densities;
    }

    std::vector<Elasticity>
    laws_of(const std::vector<MaterialParameters> &materials)
    {
      std::vector<Elasticity> laws;
      for (const MaterialParameters &material : materials)
        laws.push_back(make_elasticity(material));
      return laws;
    }

    std::string
    place_text(const Vector3<double> &x)
    {
      return "(" + short_text(x[0]) + ", " + short_text(x[1]) + ", " +
             short_text(x[2]) + ") m";
    }
  } // namespace

  Simulation::Simulation(const Parameters   &parameters,
                         Log                &log,
                         const Communicator &communicator)
    : parameters(parameters)
    , log(log)
    , mesh(make_mesh(parameters, communicator))
    , body(make_body(
        parameters,
        mesh,
        partition_cells(mesh, communicator.size(), parameters.mesh.partition),
        communicator,
        log))
    , densities(densities_of(body.materials))
    , laws(laws_of(body.materials))
    , internal_force(body.discretization.topology,
                     body.discretization.reference,
                     laws)
    , activity(body.discretization.topology)
    , results(parameters, body)
  {
    choose_time_step();
    make_modules();
    timer.stop("setup");
  }

  void
  Simulation::make_modules()
  {
    auto &[topology, reference, state, exchange] = body.discretization;

    bool   moves_from_start = BodyForce::is_needed(parameters.body_force);
    double viscosity        = 0;
    std::vector<double>          viscosities;
    std::vector<StiffnessMatrix> stiffnesses;
    for (std::size_t i = 0; i < body.materials.size(); ++i)
      {
        const MaterialParameters &material = body.materials[i];
        const Vector3<double>    &v        = material.initial_velocity;
        moves_from_start |= dot(v, v) > 0;
        viscosity = std::max(viscosity, material.viscosity);
        viscosities.push_back(material.viscosity);
        stiffnesses.push_back(stiffness_matrix(laws[i]));
      }

    if (parameters.cohesive.model != CohesiveParameters::Model::none)
      {
        fracture.emplace(topology,
                         reference,
                         internal_force,
                         body.materials,
                         parameters.cohesive,
                         stiffnesses,
                         densities,
                         critical.frequency_squared);
        internal_force.watch(fracture->strengths.stress_bounds());
      }
    if (viscosity > 0)
      {
        damping.emplace(topology, reference, viscosities);
        exchange.include_velocities();
      }

    std::vector<PrescribedMotion::Boundary> moved;
    for (const BoundaryParameters &boundary : parameters.boundaries)
      {
        const Surface &surface = body.surfaces.at(boundary.name);
        if (SurfaceLoad::is_needed(boundary))
          surface_loads.emplace_back(topology, surface, boundary);
        if (PrescribedMotion::is_needed(boundary))
          moved.push_back({surface, boundary});
      }
    if (!moved.empty())
      prescribed_motion.emplace(topology, moved);
    if (BodyForce::is_needed(parameters.body_force))
      body_force.emplace(parameters.body_force);
    if (moves_from_start)
      activity.wake_all(topology);
    exchange.send(topology, state, {}, {});
    exchange.receive(topology, state, activity);
  }

  void
  Simulation::choose_time_step()
  {
    std::vector<MaterialLimits> limits;
    for (std::size_t i = 0; i < body.materials.size(); ++i)
      limits.push_back(
        {body.materials[i].name,
         stiffness_matrix(laws[i]),
         densities[i],
         body.materials[i].viscosity,
         parameters.cohesive.model != CohesiveParameters::Model::none &&
             body.materials[i].breakable ?
           parameters.cohesive.stiffness_factor :
           0});
    critical = critical_time_step(body.discretization.topology,
                                  body.discretization.reference,
                                  limits,
                                  body.communicator);

    const TimeParameters &time = parameters.time;
    dt                         = time.time_step > 0 ? time.time_step :
                                                      time.safety_factor * critical.time_step;
    // A little tolerance, so that rounding does not add a step.
    const double n_steps = std::ceil(time.end_time / dt * (1 - 1e-12));
    if (!(dt > 0 && n_steps <= largest_number_of_steps))
      throw InputError("to come to the end time of " + to_text(time.end_time) +
                       " s in steps of " + to_text(dt) + " s takes " +
                       to_text(n_steps) + " steps; rift counts to " +
                       to_text(largest_number_of_steps) +
                       ". Look at the end time, the time step, the stiffness "
                       "factor and the viscosities.");
    last_step = static_cast<std::uint64_t>(n_steps);
    if (time.time_step == 0)
      dt = time.end_time / last_step;
    log.write("Time step " + short_text(dt) + " s, " +
              short_text(dt / critical.time_step) + " times the bound set by " +
              critical.limited_by + "; " + std::to_string(last_step) +
              " steps");
    if (dt > largest_step_over_bound * critical.time_step)
      throw InputError("the time step of " + to_text(dt) + " s is " +
                       short_text(dt / critical.time_step) +
                       " times the bound at which it is sure to be stable, " +
                       short_text(critical.time_step) +
                       " s. Set \"Time step = auto\" in subsection Time.");
    if (dt > critical.time_step)
      log.write("WARNING: the time step is above the bound at which it is "
                "sure to be stable");
  }

  void
  Simulation::run()
  {
    results.open(parameters, log);
    FlushDenormals flush_denormals;
    Progress   progress(log, topology().n_cells(), 0, parameters.time.end_time);
    const auto wall_start = timer.total();
    while (state().step < last_step)
      {
        step();
        progress.update(state().step, state().time);
      }
    step();
    progress.finish();

    Summary summary;
    summary.time_step_limited_by = critical.limited_by;
    summary.wall_seconds         = timer.total();
    summary.cell_steps_per_second =
      topology().n_cells() * state().step / (timer.total() - wall_start);
    summary.wall_seconds_by_stage = timer.seconds();
    FaceCounts faces;
    if (fracture)
      faces = fracture->force.count_faces(body.communicator);
    summary.faces_inserted = faces.inserted;
    summary.faces_broken   = faces.failed;
    results.finish(snapshot(), summary);
    log.write(
      "Done: " + std::to_string(state().step) + " steps in " +
      duration_text(timer.total()) + "; " + std::to_string(faces.inserted) +
      " faces cut, largest residual of the energy ledger " +
      short_text(ledger.largest_relative_residual()) + " of the energy put in");
    if (faces.too_short > 0)
      log.write("WARNING: " + std::to_string(faces.too_short) + " of " +
                std::to_string(faces.opened) +
                " opened faces need more than their fracture energy: the "
                "elements are too large for these strengths and fracture "
                "energies (doc/theory.md, section 4)");
  }

  void
  Simulation::step()
  {
    State &state = body.discretization.state;

    // 1. Insertion: faces of the cells that were near their strength
    TopologyChange change;
    if (fracture && !internal_force.hot_cells().empty())
      {
        change = split_at(
          fracture->insertion.find_faces(state, internal_force.hot_cells()));
        timer.stop("insertion");
      }

    // 2. Internal forces
    if (const auto failed = internal_force.add_to(state, activity))
      note_failure(*failed);
    timer.stop("internal forces");

    // 3. Cohesive tractions
    if (fracture)
      {
        fracture->force.add_to(state);
        timer.stop("cohesive forces");
      }

    // 4. Loads and damping
    for (SurfaceLoad &load : surface_loads)
      load.add_to(state, activity);
    if (body_force)
      body_force->add_to(state);
    if (damping)
      damping->add_to(state, activity);
    timer.stop("loads and damping");

    // 5. Nodes that have parted in this step stay together until its end
    std::vector<OpeningCorner> openings;
    if (fracture)
      {
        openings = fracture->force.hold_partings(
          state,
          [this](const NodeIndex node, const unsigned int component) {
            return prescribed_motion ?
                     prescribed_motion->acceleration(this->state(),
                                                     dt,
                                                     node,
                                                     component) :
                     std::optional<double>();
          });
        timer.stop("cohesive forces");
      }

    // 6. Prescribed motion
    if (state.step == 0)
      start_velocities(state, dt);
    if (prescribed_motion)
      prescribed_motion->impose(state, activity, dt);
    timer.stop("loads and damping");

    // 7. Ledger and output at t_n, when due
    count_work();
    write_due_results();
    timer.stop("ledger and output");

    // 8. Kick and drift to t_(n+1)
    if (state.step == last_step)
      return;
    advance(state, activity, dt);
    timer.stop("kick and drift");

    // 9. Nodes of ghost cells follow those of their owners
    follow_neighbours(change.splits, openings);
    timer.stop("exchange");

    // 10. Faces that begin to open take over the forces that held the nodes
    if (fracture)
      {
        fracture->force.start_openings(state, std::move(openings));
        timer.stop("cohesive forces");
      }
  }

  TopologyChange
  Simulation::split_at(const std::vector<FaceIndex> &faces)
  {
    if (faces.empty())
      return {};
    auto &[topology, reference, state, exchange] = body.discretization;
    TopologyChange change                        = split_nodes(topology, faces);
    if (change.splits.empty())
      return change;

    state.grow(change);
    for (const NodeSplit &split : change.splits)
      for (const NodeIndex part : split.parts)
        state.mass[part] = lumped_mass(topology, reference, densities, part);
    activity.grow(topology.n_nodes());
    fracture->force.apply(change);
    update_surfaces();
    return change;
  }

  void
  Simulation::follow_neighbours(const std::vector<NodeSplit> &splits,
                                std::vector<OpeningCorner>   &openings)
  {
    auto &[topology, reference, state, exchange] = body.discretization;
    exchange.send(topology, state, splits, openings);
    const auto change = exchange.receive(topology, state, activity);
    openings.insert(openings.end(),
                    change.openings.begin(),
                    change.openings.end());
    if (change.vertices.empty())
      return;
    fracture->force.update_nodes(change.vertices);
    update_surfaces();
  }

  void
  Simulation::update_surfaces()
  {
    for (SurfaceLoad &load : surface_loads)
      load.update_nodes();
    if (prescribed_motion)
      prescribed_motion->update_nodes();
  }

  void
  Simulation::count_work()
  {
    for (SurfaceLoad &load : surface_loads)
      load.count_work(state(), dt);
    if (damping)
      damping->count_work(state(), dt);
  }

  void
  Simulation::balance_energy()
  {
    EnergySums sums;
    sums.kinetic = kinetic_energy(topology(), state(), dt);
    sums.strain  = internal_force.strain_energy(state());
    if (fracture)
      {
        const CohesiveEnergy cohesive = fracture->force.energy();
        sums.cohesive                 = cohesive.recoverable;
        sums.fracture                 = cohesive.fracture;
        sums.friction                 = cohesive.friction;
      }
    if (damping)
      sums.damping = damping->work().sum();
    for (SurfaceLoad &load : surface_loads)
      sums.loads.add(load.work().sum());
    if (prescribed_motion)
      sums.loads.add(prescribed_motion->work().sum());
    if (body_force)
      sums.loads.add(body_force->work(topology(), state()));
    ledger.enter(sums.total(body.communicator));

    if (!(std::abs(ledger.relative_residual()) <=
          parameters.time.largest_residual))
      throw RunError(
        "energy runs away: the balance is wrong by " +
        short_text(ledger.residual()) + " J, " +
        short_text(ledger.relative_residual()) +
        " of the energy in play, more than the \"Largest energy residual\" "
        "of " +
        to_text(parameters.time.largest_residual) + ", at " + moment_text() +
        "; " + fastest_node_text() +
        ". Choose a smaller time step or safety factor (subsection Time).");
  }

  std::string
  Simulation::fastest_node_text() const
  {
    struct Corner
    {
      double          square;
      Vector3<double> position;
      GlobalCellIndex cell;
      unsigned int    corner;
    };
    const auto is_faster = [](const Corner &a, const Corner &b) {
      return a.square > b.square ||
             (a.square == b.square && std::make_pair(a.cell, a.corner) <
                                        std::make_pair(b.cell, b.corner));
    };
    Corner fastest{-1, {{0, 0, 0}}, invalid_index, 0};
    for (CellIndex cell = 0; cell < topology().n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < n_corners && topology().owns_cell(cell); ++c)
        {
          const NodeIndex       node = topology().node(cell, c);
          const Vector3<double> v    = state().velocity[node].vector();
          // What is not a number is faster than all numbers.
          const Corner corner{std::isnan(dot(v, v)) ?
                                std::numeric_limits<double>::infinity() :
                                dot(v, v),
                              state().position(node),
                              topology().cell_global_indices[cell],
                              c};
          if (is_faster(corner, fastest))
            fastest = corner;
        }
    fastest = body.communicator.first_of_ranks(fastest, is_faster);
    return "the fastest node moves with " +
           short_text(std::sqrt(fastest.square)) + " m/s at " +
           place_text(fastest.position);
  }

  void
  Simulation::write_due_results()
  {
    const bool is_last = state().step == last_step;
    const bool history = results.is_history_due(state().time, dt) ||
                         (is_last && results.is_open());
    const bool solution = results.is_solution_due(state().time, dt);
    if (history || solution || is_last || state().step >= next_agreement)
      agree();
    if (history || is_last || state().step % balance_interval == 0)
      balance_energy();
    if (history)
      results.write_history(snapshot());
    if (solution)
      results.write_solution(snapshot());
  }

  Snapshot
  Simulation::snapshot() const
  {
    return {body,
            internal_force,
            fracture ? &fracture->force : nullptr,
            ledger,
            dt};
  }

  std::string
  Simulation::moment_text() const
  {
    return "step " + std::to_string(state().step) +
           ", t = " + short_text(state().time) + " s, time step " +
           short_text(dt / critical.time_step) + " times its safe bound";
  }

  void
  Simulation::note_failure(const FailedCell &failed)
  {
    if (failure)
      return;
    Vector3<double> centre = {{0, 0, 0}};
    for (unsigned int c = 0; c < n_corners; ++c)
      centre +=
        .25 * state().reference[topology().node(failed.cell, c)].vector();
    const GlobalCellIndex cell = topology().cell_global_indices[failed.cell];
    failure                    = Failure{
      state().step,
      cell,
      "cell " + std::to_string(cell) + " of " +
        body.materials[topology().material(failed.cell)].name + " at " +
        place_text(centre) + " has " + short_text(failed.volume_ratio) +
        " of its volume; below " +
        to_text(InternalForce::smallest_volume_ratio) +
        " the elastic law has no meaning. At " + moment_text() +
        ". Choose a smaller time step or safety factor, or a weaker load."};
  }

  void
  Simulation::agree()
  {
    enum
    {
      failed,
      steps_to_next,
      n_numbers
    };
    const auto                now = std::chrono::steady_clock::now();
    std::vector<std::int64_t> numbers(n_numbers, 0);
    numbers[failed] = failure ? 1 : 0;
    if (body.communicator.is_root())
      {
        const double seconds =
          std::chrono::duration<double>(now - last_agreement).count();
        const double steps     = state().step - step_of_last_agreement;
        numbers[steps_to_next] = static_cast<std::int64_t>(
          std::clamp(steps * seconds_between_agreements / seconds,
                     1.,
                     1. * largest_agreement_interval));
      }
    body.communicator.sum(numbers);
    last_agreement         = now;
    step_of_last_agreement = state().step;
    next_agreement         = state().step + numbers[steps_to_next];
    if (numbers[failed] > 0)
      stop_failed();
  }

  void
  Simulation::stop_failed() const
  {
    // The first failure counts; several ranks may have seen it.
    std::string own;
    if (failure)
      own = fmt::format("{:020}{:010}{}",
                        failure->step,
                        failure->cell,
                        failure->message);
    std::string first;
    for (const std::string &one : body.communicator.all_gather(own))
      if (!one.empty() && (first.empty() || one < first))
        first = one;
    throw RunError(first.substr(30));
  }

  void
  validate_scene(std::ostream &out, const Parameters &parameters)
  {
    print_summary(out, parameters);
    const Communicator communicator(MPI_COMM_WORLD);
    Log                log(communicator.is_root() ? &out : nullptr);
    Simulation(parameters, log, communicator);
  }

  void
  run_simulation(const Parameters &parameters)
  {
    const Communicator communicator(MPI_COMM_WORLD);
    Log log(communicator.is_root() ? &std::cout : nullptr, is_terminal());
    if (!parameters.title.empty())
      log.write(parameters.title);
    Simulation(parameters, log, communicator).run();
  }
} // namespace rift
