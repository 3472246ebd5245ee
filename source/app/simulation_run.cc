#include <rift/app/run.h>
#include <rift/app/simulation.h>
#include <rift/base/exceptions.h>
#include <rift/base/floating_point.h>
#include <rift/base/number_text.h>
#include <rift/base/parameter_text.h>
#include <rift/io/output_directory.h>
#include <rift/io/progress.h>
#include <rift/time_integration/central_difference.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

// The loop over the steps and what watches over it.
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

    std::string
    place_text(const Vector3<double> &x)
    {
      return "(" + short_text(x[0]) + ", " + short_text(x[1]) + ", " +
             short_text(x[2]) + ") m";
    }
  } // namespace

  Simulation::End
  Simulation::run(const StopSignals *signals)
  {
    if (saved_results)
      results.reopen(parameters, *saved_results, log);
    else
      results.open(parameters, log);
    FlushDenormals flush_denormals;
    stop_signals    = signals;
    last_checkpoint = std::chrono::steady_clock::now();

    const auto n_cells = body.communicator.sum(
      static_cast<std::int64_t>(topology().n_owned_cells()));
    Progress progress(log,
                      n_cells,
                      state().step,
                      state().time,
                      parameters.time.end_time);
    timer.stop("setup");
    seconds_at_start = timer.total();
    while (state().step < last_step)
      {
        step();
        progress.update(state().step, state().time);
        if (failure || (!must_stop && !is_checkpoint_due))
          continue;
        write_checkpoint();
        if (must_stop)
          stop();
        is_checkpoint_due = false;
        if (state().step < last_step && is_unbalanced())
          return End::divide_anew;
      }
    step();
    progress.finish();
    finish();
    return End::done;
  }

  void
  Simulation::stop() const
  {
    throw Error(ExitCode::stopped_by_signal,
                "stopped by a signal at step " + std::to_string(state().step) +
                  ", t = " + short_text(state().time) +
                  " s. Go on with --restart.");
  }

  FaceCounts
  Simulation::count_faces() const
  {
    return fracture ? fracture->force.count_faces(body.communicator) :
                      FaceCounts();
  }

  Summary
  Simulation::summarize() const
  {
    const double cell_steps = 1. * (state().step - first_step) *
                              body.communicator.sum(topology().n_owned_cells());
    const FaceCounts faces = count_faces();
    Summary          summary;
    summary.time_step_limited_by = critical.limited_by;
    summary.wall_seconds         = timer.total();
    summary.cell_steps_per_second =
      cell_steps / (timer.total() - seconds_at_start);
    summary.wall_seconds_by_stage = timer.seconds();
    summary.faces_inserted        = faces.inserted;
    summary.faces_broken          = faces.failed;
    if (contact)
      summary.contact_pairs = contact->count_touching();
    return summary;
  }

  void
  Simulation::finish()
  {
    results.finish(snapshot(), summarize());
    const FaceCounts faces = count_faces();
    log.write(
      "Done: " + std::to_string(state().step) + " steps" +
      (first_step > 0 ? ", " + std::to_string(state().step - first_step) +
                          " of them since the restart, in " :
                        " in ") +
      duration_text(timer.total()) + "; " + std::to_string(faces.opened) +
      " faces opened, largest residual of the energy ledger " +
      short_text(ledger.largest_relative_residual()) +
      " of the energy in play");
    const Energies  &energies            = ledger.energies();
    constexpr double largest_unpaid_part = .05;
    if (-energies.cohesive >
        largest_unpaid_part * (energies.total() - energies.cohesive))
      log.write("WARNING: the balance has a cohesive energy of " +
                short_text(energies.cohesive) +
                " J: so much has come from faces that broke under pressure and "
                "were unloaded before they had drawn it from the body. Take a "
                "larger stiffness factor, of Fracture and of Contact.");
    if (faces.too_short > 0)
      log.write("WARNING: " + std::to_string(faces.too_short) + " of " +
                std::to_string(faces.opened) +
                " opened faces need more than their fracture energy: the "
                "elements are too large for these strengths and fracture "
                "energies, or the cohesive penalty is too small "
                "(doc/theory.md, section 4)");
    body.communicator.on_root([this] { log.check(); });
  }

  void
  Simulation::count_work()
  {
    for (SurfaceLoad &load : surface_loads)
      load.count_work(state(), dt);
    for (AbsorbingBoundary &boundary : absorbing_boundaries)
      boundary.count_work(state(), dt);
    if (damping)
      damping->count_work(state(), dt);
  }

  void
  Simulation::finish_failed(const std::string &message)
  {
    if (!results.is_open())
      return;
    enter_energies();
    Summary summary    = summarize();
    summary.stopped_by = message;
    const auto attempt = [&](const std::function<void()> &f) {
      try
        {
          f();
        }
      catch (const Error &error)
        {
          log.write(std::string("WARNING: not all of the state at which the "
                                "run has failed could be written. ") +
                    error.what());
        }
    };
    attempt([&] { results.write_history(snapshot()); });
    attempt([&] { results.write_solution(snapshot()); });
    attempt([&] { results.finish(snapshot(), summary); });
  }

  void
  Simulation::enter_energies()
  {
    EnergySums sums;
    sums.kinetic = kinetic_energy(topology(), state(), dt);
    sums.strain  = internal_force.strain_energy(state());
    if (fracture)
      {
        const CohesiveEnergy cohesive = fracture->force.energy(state());
        sums.cohesive                 = cohesive.recoverable;
        sums.fracture                 = cohesive.fracture;
        sums.friction                 = cohesive.friction;
      }
    if (damping)
      sums.damping = damping->work().sum();
    for (AbsorbingBoundary &boundary : absorbing_boundaries)
      sums.damping.add(boundary.work().sum());
    if (contact)
      {
        sums.contact = contact->energy().elastic;
        sums.friction.add(contact->energy().friction);
        sums.damping.add(contact->energy().damping);
      }
    for (SurfaceLoad &load : surface_loads)
      sums.loads.add(load.work().sum());
    if (prescribed_motion)
      sums.loads.add(prescribed_motion->work().sum());
    if (rigid_bodies)
      sums.loads.add(rigid_bodies->work().sum());
    if (body_force)
      sums.loads.add(body_force->work(topology(), state()));
    ledger.enter(sums.total(body.communicator));
  }

  void
  Simulation::judge_residual() const
  {
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
    const bool solution = results.is_solution_due(state().time, dt) ||
                          (is_last && results.has_solutions());
    const auto interval = parameters.checkpoint.interval_in_steps;
    // After this step.
    is_checkpoint_due |= interval > 0 && (state().step + 1) % interval == 0;
    const bool balance =
      history || is_last || state().step % balance_interval == 0;
    try
      {
        if (balance || solution || is_checkpoint_due ||
            state().step >= next_agreement ||
            (failure && body.communicator.size() == 1))
          agree();
        if (balance)
          {
            enter_energies();
            judge_residual();
          }
      }
    catch (const RunError &error)
      {
        finish_failed(error.what());
        throw;
      }
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
            rigid_bodies ? &*rigid_bodies : nullptr,
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
  Simulation::note_failure(const DeepOverlap &deep)
  {
    if (!failure)
      failure = Failure{
        state().step,
        deep.a,
        "cells " + std::to_string(deep.a) + " and " + std::to_string(deep.b) +
          " lie in each other by more than " + to_text(largest_mean_potential) +
          " of their height: contact is too soft for this "
          "impact or load. At " +
          moment_text() +
          ". Set a larger \"Stiffness factor\" in subsection "
          "Contact, or choose a weaker load."};
  }

  void
  Simulation::guard(const std::function<void()> &f)
  {
    try
      {
        f();
      }
    catch (const Error &error)
      {
        const bool do_all_throw =
          body.communicator.size() == 1 ||
          dynamic_cast<const CollectiveError *>(&error) != nullptr;
        if (error.exit_code != ExitCode::run_error || !do_all_throw)
          throw;
        // Behind the cells that have failed in the same step.
        if (!failure)
          failure = Failure{state().step, invalid_index, error.what()};
        next_agreement = 0;
      }
  }

  void
  Simulation::agree()
  {
    enum
    {
      failed,
      signalled,
      checkpoint_due,
      steps_to_next,
      n_numbers
    };
    const auto                now = std::chrono::steady_clock::now();
    std::vector<std::int64_t> numbers(n_numbers, 0);
    numbers[failed] = failure || log.has_failed() ? 1 : 0;
    numbers[signalled] =
      stop_signals != nullptr && stop_signals->requested() ? 1 : 0;
    if (body.communicator.is_root())
      {
        const double minutes =
          std::chrono::duration<double>(now - last_checkpoint).count() / 60;
        const double interval   = parameters.checkpoint.interval_in_minutes;
        numbers[checkpoint_due] = interval > 0 && minutes >= interval ? 1 : 0;
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
    must_stop = numbers[signalled] > 0;
    is_checkpoint_due |= numbers[checkpoint_due] > 0;
  }

  void
  Simulation::stop_failed() const
  {
    body.communicator.on_root([this] { log.check(); });
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
    for (const std::string &doubt : doubts(parameters))
      log.write("WARNING: " + doubt);
    Simulation(parameters, log, communicator);
  }

  void
  run_simulation(const Parameters &parameters, const bool is_restart)
  {
    const Communicator communicator(MPI_COMM_WORLD);
    // To a program under mpirun a terminal and a pipe look the same.
    const bool interactive = communicator.size() == 1 && is_terminal();
    Log        log(communicator.is_root() ? &std::cout : nullptr, interactive);
    if (!parameters.title.empty())
      log.write(parameters.title);
    // Before the mesh is made, which may take long.
    communicator.on_root([&] {
      const OutputParameters &output = parameters.output;
      if (is_restart)
        reopen_output_directory(output.directory);
      else
        check_output_directory(output.directory, output.overwrite);
    });
    std::optional<Restart> restart;
    if (is_restart)
      restart = read_restart(parameters, communicator, log);
    std::optional<StopSignals> signals;
    while (true)
      {
        {
          Simulation simulation(parameters,
                                log,
                                communicator,
                                restart ? &*restart : nullptr);
          restart.reset();
          // Not before there is something to save. From then on no signal may
          // be lost, not even while the cells are divided anew.
          if (!signals)
            signals.emplace();
          if (simulation.run(&*signals) == Simulation::End::done)
            return;
        }
        log.write("The ranks have unequal work: the cells are divided anew");
        restart = read_restart(parameters, communicator, log);
      }
  }
} // namespace rift
