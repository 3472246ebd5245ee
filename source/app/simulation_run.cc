#include <rift/app/run.h>
#include <rift/app/simulation.h>
#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/base/parameter_text.h>
#include <rift/base/vector_text.h>
#include <rift/io/output_directory.h>
#include <rift/io/progress.h>
#include <rift/time_integration/central_difference.h>

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

    /** Number of steps between two looks at the pieces: where loads depend on
     * them, and for warnings alone. */
    constexpr std::uint64_t fragment_interval_of_loads = 20;
    constexpr std::uint64_t warning_interval           = 500;

    /** Ranks ask each other about so often whether all goes well... */
    constexpr double seconds_between_synchronizations = .5;

    /** ... and after so many steps in any case. */
    constexpr std::uint64_t largest_synchronization_interval = 100;
  } // namespace

  Simulation::Outcome
  Simulation::run(const StopSignals *signals)
  {
    const Energies terms = energies().total(body.communicator);
    if (saved_results)
      results.reopen(parameters, terms, *saved_results, log);
    else
      results.open(parameters, terms, log);
    stop_signals    = signals;
    last_checkpoint = std::chrono::steady_clock::now();

    const auto n_cells = body.communicator.sum(
      static_cast<std::int64_t>(topology().n_owned_cells()));
    Progress progress(log,
                      n_cells,
                      state().step,
                      state().time,
                      parameters.time.end_time);
    timer.stop(Stage::setup);
    if (record->seconds_before_steps == 0)
      record->seconds_before_steps = timer.total();
    while (state().step < steps.last_step)
      {
        step();
        progress.update(state().step, state().time);
        if (failures.any() || (!must_stop && !is_checkpoint_due))
          continue;
        write_checkpoint();
        if (must_stop)
          stop();
        is_checkpoint_due = false;
        if (state().step < steps.last_step &&
            record->division.repartitions(is_unbalanced()))
          return Outcome::repartition;
      }
    step();
    progress.finish();
    finish();
    return Outcome::done;
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
    return modules.fracture != nullptr ?
             modules.fracture->count_faces(body.communicator) :
             FaceCounts();
  }

  Summary
  Simulation::summarize() const
  {
    const double cell_steps = 1. * (state().step - *record->first_step) *
                              body.communicator.sum(topology().n_owned_cells());
    const FaceCounts faces = count_faces();
    Summary          summary;
    summary.time_step_limited_by = critical.limited_by;
    summary.wall_seconds         = timer.total();
    summary.cell_steps_per_second =
      cell_steps / (timer.total() - record->seconds_before_steps);
    summary.wall_seconds_by_stage = timer.named_seconds();
    summary.warnings              = log.warnings();
    summary.faces_inserted        = faces.inserted;
    summary.faces_broken          = faces.failed;
    if (modules.contact != nullptr)
      {
        summary.contact_pairs = modules.contact->count_touching();
        summary.contact_bytes = modules.contact->bytes();
      }
    return summary;
  }

  void
  Simulation::finish()
  {
    follow_fragments(true);
    warn_of_modules(true);
    warn_of_results(count_faces());
    results.finish(snapshot(), summarize());
    log_end(count_faces());
    body.communicator.on_root([this] { log.check(); });
  }

  void
  Simulation::follow_fragments(const bool is_end)
  {
    const bool is_needed =
      std::any_of(modules.begin(), modules.end(), [](const auto &module) {
        return module->needs_fragments();
      });
    const std::uint64_t step      = state().step;
    const bool          is_warned = is_end || step % warning_interval == 0;
    if (!is_warned && !(is_needed && step % fragment_interval_of_loads == 0))
      return;
    const auto &states = topology().face_states;
    if (!body.communicator.any(
          std::any_of(states.begin(), states.end(), [](const FaceState face) {
            return face >= FaceState::failed;
          })))
      return;

    const Discretization        &d = body.discretization;
    std::vector<Vector3<double>> velocities;
    velocities.reserve(d.state.n_nodes());
    // Half a step old, which is good enough for warnings.
    for (const NodalVector &velocity : d.state.velocity)
      velocities.push_back(velocity.vector());
    const Fragments fragments = find_fragments(d.topology,
                                               d.reference,
                                               d.densities,
                                               d.bodies,
                                               d.state,
                                               velocities,
                                               d.communicator);
    for (const auto &module : modules)
      for (const Warning &warning :
           module->follow_fragments(fragments, d.communicator))
        log.warn_once(warning);
    if (is_warned)
      for (const Warning &warning : fragment_watch.look(fragments))
        log.warn_once(warning);
  }

  void
  Simulation::warn_of_modules(const bool is_end)
  {
    if (!is_end && state().step % warning_interval != 0)
      return;
    for (const auto &module : modules)
      for (const Warning &warning : module->warnings_so_far())
        log.warn_once(warning);
  }

  void
  Simulation::log_end(const FaceCounts &faces)
  {
    const std::uint64_t first_step = *record->first_step;
    log.write(
      "Done: " + std::to_string(state().step) + " steps" +
      (first_step > 0 ? ", " + std::to_string(state().step - first_step) +
                          " of them since the restart, in " :
                        " in ") +
      duration_text(timer.total()) + "; " + std::to_string(faces.opened) +
      " faces opened, largest residual of the energy ledger " +
      short_text(ledger.largest_relative_residual()) +
      " of the energy in play");
  }

  void
  Simulation::warn_of_results(const FaceCounts &faces)
  {
    const double     cohesive           = ledger.energies()["cohesive"];
    constexpr double largest_given_part = .05;
    if (cohesive < 0 &&
        -cohesive > largest_given_part * (ledger.energies().total() - cohesive))
      log.warn("faces that broke while they were compressed have given " +
               short_text(-cohesive) +
               " J to the body, and nothing has given it to them; in the "
               "balance this is a negative cohesive energy. Set a larger "
               "\"Stiffness factor\" in subsection Fracture" +
               (modules.contact != nullptr ? " and in Contact." : "."));
    if (faces.too_short > 0)
      log.warn(std::to_string(faces.too_short) + " of " +
               std::to_string(faces.opened) +
               " opened faces need more than their fracture energy: the "
               "elements are too large for these strengths and fracture "
               "energies, or the cohesive penalty is too small "
               "(doc/theory.md, section 4)");
  }

  EnergyTable
  Simulation::energies() const
  {
    EnergyTable table;
    table["kinetic"] = kinetic_energy(topology(), state(), steps.time_step);
    for (const auto &module : modules)
      module->account(body.discretization, table);
    return table;
  }

  void
  Simulation::finish_failed(const std::string &message)
  {
    if (!results.is_open())
      return;
    enter_energies();
    const auto attempt = [&](const std::function<void()> &f) {
      try
        {
          f();
        }
      catch (const Error &error)
        {
          log.warn(std::string("not all of the state at which the "
                               "run has failed could be written. ") +
                   error.what());
        }
    };
    attempt([&] { follow_fragments(true); });
    attempt([&] { warn_of_modules(true); });
    attempt([&] { results.write_history(snapshot()); });
    attempt([&] { results.write_solution(snapshot()); });
    Summary summary    = summarize();
    summary.stopped_by = message;
    attempt([&] { results.finish(snapshot(), summary); });
  }

  void
  Simulation::enter_energies()
  {
    ledger.enter(energies().total(body.communicator));
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
        to_text(parameters.time.largest_residual) + ", at " +
        moment_text(state().step) + "; " + fastest_node_text() +
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
    const bool is_last = state().step == steps.last_step;
    const bool history =
      results.is_history_due(state().time, steps.time_step) ||
      (is_last && results.is_open());
    const bool solution =
      results.is_solution_due(state().time, steps.time_step) ||
      (is_last && results.has_solutions());
    const auto interval = parameters.checkpoint.interval_in_steps;
    // After this step.
    is_checkpoint_due |= interval > 0 && (state().step + 1) % interval == 0;
    const bool balance =
      history || is_last || state().step % balance_interval == 0;
    try
      {
        if (balance || solution || is_checkpoint_due ||
            state().step >= next_synchronization ||
            (failures.any() && body.communicator.size() == 1))
          synchronize_status();
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
    return {body, modules, ledger, steps.time_step};
  }

  std::string
  Simulation::moment_text(const std::uint64_t step) const
  {
    return "step " + std::to_string(step) +
           ", t = " + short_text(step * steps.time_step) + " s, time step " +
           short_text(steps.time_step / critical.time_step) +
           " times its safe bound";
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
        failures.note({state().step, invalid_index, error.what(), ""});
        next_synchronization = 0;
      }
  }

  void
  Simulation::synchronize_status()
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
    numbers[failed] = failures.any() || log.has_failed() ? 1 : 0;
    numbers[signalled] =
      stop_signals != nullptr && stop_signals->requested() ? 1 : 0;
    if (body.communicator.is_root())
      {
        const double minutes =
          std::chrono::duration<double>(now - last_checkpoint).count() / 60;
        const double interval   = parameters.checkpoint.interval_in_minutes;
        numbers[checkpoint_due] = interval > 0 && minutes >= interval ? 1 : 0;
        const double seconds =
          std::chrono::duration<double>(now - last_synchronization).count();
        const double steps     = state().step - step_of_last_synchronization;
        numbers[steps_to_next] = static_cast<std::int64_t>(
          std::clamp(steps * seconds_between_synchronizations / seconds,
                     1.,
                     1. * largest_synchronization_interval));
      }
    body.communicator.sum(numbers);
    last_synchronization         = now;
    step_of_last_synchronization = state().step;
    next_synchronization         = state().step + numbers[steps_to_next];
    if (numbers[failed] > 0)
      {
        body.communicator.on_root([this] { log.check(); });
        throw_first_failure();
      }
    must_stop = numbers[signalled] > 0;
    is_checkpoint_due |= numbers[checkpoint_due] > 0;
  }

  void
  Simulation::throw_first_failure() const
  {
    const auto first = failures.first_of_ranks(body.communicator);
    if (!first)
      return;
    // An error of a module is a sentence already.
    throw RunError(first->advice.empty() ?
                     first->what :
                     first->what + ". At " + moment_text(first->step) + ". " +
                       first->advice);
  }
} // namespace rift
