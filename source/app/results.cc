#include <rift/app/results.h>
#include <rift/base/exceptions.h>
#include <rift/io/fragments_file.h>
#include <rift/io/output_directory.h>
#include <rift/io/solution_fields.h>

#include <sys/resource.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    std::uint64_t
    peak_memory_bytes()
    {
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      return 1024ull * static_cast<std::uint64_t>(usage.ru_maxrss);
    }

    /** The fields of all modules. */
    FieldList
    fields_of(const Snapshot &snapshot)
    {
      FieldList list(snapshot.body.discretization.state, snapshot.time_step);
      declare_nodal_fields(list);
      for (const auto &module : snapshot.modules)
        module->declare_fields(list);
      return list;
    }

    Fragments
    find_fragments(const Snapshot &snapshot)
    {
      const Discretization &d = snapshot.body.discretization;
      return rift::find_fragments(d.topology,
                                  d.reference,
                                  d.densities,
                                  d.bodies,
                                  d.state,
                                  velocity_at_step(d.state, snapshot.time_step),
                                  d.communicator);
    }

    /** The terms of the ledger with their names. */
    NamedNumbers
    named_energies(const EnergyLedger &ledger)
    {
      NamedNumbers result = ledger.energies().terms();
      result.emplace_back("residual", ledger.residual());
      return result;
    }

    std::vector<std::string>
    energy_columns(const Energies &energies)
    {
      std::vector<std::string> columns = {"time [s]"};
      for (const auto &[name, energy] : energies.terms())
        columns.push_back(name + " [J]");
      columns.push_back("residual [J]");
      return columns;
    }

    using WrittenStates = std::vector<SolutionSeries::WrittenState>;

    void
    write_states(CheckpointFileWriter &file,
                 const std::string    &name,
                 const WrittenStates  &states)
    {
      std::vector<double>       times;
      std::vector<std::int64_t> n_files;
      for (const auto &state : states)
        {
          times.push_back(state.time);
          n_files.push_back(state.n_files);
        }
      file.write("times of " + name, times);
      file.write("files of " + name, n_files);
    }

    WrittenStates
    read_states(const CheckpointFileReader &file, const std::string &name)
    {
      const auto    times   = file.read<double>("times of " + name);
      const auto    n_files = file.read<std::int64_t>("files of " + name);
      WrittenStates states;
      for (std::size_t i = 0; i < times.size(); ++i)
        states.push_back({times[i], static_cast<int>(n_files.at(i))});
      return states;
    }
  } // namespace

  void
  SavedResults::write(CheckpointFileWriter &file) const
  {
    file.write<std::uint64_t>(
      "results",
      {n_solutions, n_rows, probes_length, energy_length});
    write_states(file, "solid", solid);
    write_states(file, "fracture", fracture);
  }

  SavedResults
  SavedResults::read(const CheckpointFileReader &file)
  {
    const auto   numbers = file.read<std::uint64_t>("results");
    SavedResults saved;
    saved.n_solutions   = numbers.at(0);
    saved.n_rows        = numbers.at(1);
    saved.probes_length = numbers.at(2);
    saved.energy_length = numbers.at(3);
    saved.solid         = read_states(file, "solid");
    saved.fracture      = read_states(file, "fracture");
    return saved;
  }

  Results::Results(const Parameters &parameters, const Body &body)
    : communicator(body.communicator)
    , directory(parameters.output.directory)
    , solution_interval(parameters.output.solution_interval)
    , history_interval(parameters.output.history_interval)
    , ranks_per_file(parameters.output.ranks_per_file)
    , output_fields(parameters.output.fields)
    , initial_nodes(
        communicator.sum(body.discretization.topology.n_owned_nodes()))
  {
    const Discretization &d = body.discretization;
    for (const ProbeParameters &p : parameters.probes)
      {
        const auto surface = body.surfaces.find(p.boundary);
        probes.emplace_back(d.topology,
                            d.reference,
                            d.state,
                            p,
                            surface == body.surfaces.end() ? Surface() :
                                                             surface->second,
                            communicator);
      }
  }

  void
  Results::open(const Parameters &parameters,
                const Energies   &energies,
                Log              &log)
  {
    communicator.on_root([&] { open_files(parameters, energies, log); });
    make_series(parameters);
    was_opened = true;
  }

  void
  Results::reopen(const Parameters   &parameters,
                  const Energies     &energies,
                  const SavedResults &saved,
                  Log                &log)
  {
    communicator.on_root([&] {
      remove_results_of_end(directory);
      log.reopen(path("log.txt"));
      if (!probes.empty())
        probes_file.emplace(path("probes.csv"),
                            probe_columns(),
                            saved.probes_length);
      energy_file.emplace(path("energy.csv"),
                          energy_columns(energies),
                          saved.energy_length);
    });
    make_series(parameters);
    if (solid)
      solid->go_on_after(saved.solid);
    if (fracture)
      fracture->go_on_after(saved.fracture);
    n_solutions = saved.n_solutions;
    n_rows      = saved.n_rows;
    was_opened  = true;
  }

  void
  Results::make_series(const Parameters &parameters)
  {
    if (solution_interval > 0)
      {
        solid.emplace(directory, "solid", communicator, ranks_per_file);
        if (parameters.cohesive.model != CohesiveParameters::Model::none)
          fracture.emplace(directory, "fracture", communicator, ranks_per_file);
      }
  }

  std::vector<std::string>
  Results::probe_columns() const
  {
    std::vector<std::string> columns = {"time [s]"};
    for (const Probe &probe : probes)
      columns.push_back(probe.header());
    return columns;
  }

  SavedResults
  Results::synchronize()
  {
    SavedResults saved;
    saved.n_solutions = n_solutions;
    saved.n_rows      = n_rows;
    communicator.on_root([&] {
      if (probes_file)
        saved.probes_length = probes_file->synchronize();
      saved.energy_length = energy_file->synchronize();
    });
    if (solid)
      saved.solid = solid->states();
    if (fracture)
      saved.fracture = fracture->states();
    return saved;
  }

  void
  Results::open_files(const Parameters &parameters,
                      const Energies   &energies,
                      Log              &log)
  {
    prepare_output_directory(directory, parameters.output.overwrite);
    log.open(path("log.txt"));
    for (const std::string &warning : warnings(parameters))
      log.warn(warning);
    // The first line tells a later run that the file may be replaced.
    write_file_atomically(path("parameters.prm"),
                          std::string(parameters_marker) + "\n" +
                            used_parameters(parameters));

    if (!probes.empty())
      probes_file.emplace(path("probes.csv"), probe_columns());
    energy_file.emplace(path("energy.csv"), energy_columns(energies));
  }

  bool
  Results::is_history_due(const double time, const double time_step) const
  {
    return is_open() && time >= n_rows * history_interval - .5 * time_step;
  }

  bool
  Results::is_solution_due(const double time, const double time_step) const
  {
    return solid && time >= n_solutions * solution_interval - .5 * time_step;
  }

  void
  Results::write_history(const Snapshot &snapshot)
  {
    ++n_rows;
    const Discretization &d      = snapshot.body.discretization;
    std::vector<double>   energy = {d.state.time};
    for (const auto &term : named_energies(snapshot.ledger))
      energy.push_back(term.second);

    std::vector<double> values = {d.state.time};
    if (!probes.empty())
      for (const double value :
           probe_values(probes, d.topology, fields_of(snapshot), communicator))
        values.push_back(value);

    communicator.on_root([&] {
      energy_file->append(energy);
      if (probes_file)
        probes_file->append(values);
    });
  }

  void
  Results::write_solution(const Snapshot &snapshot)
  {
    if (!has_solutions())
      return;
    ++n_solutions;
    const Discretization      &d      = snapshot.body.discretization;
    FieldList                  fields = fields_of(snapshot);
    std::vector<std::uint32_t> fragments;
    declare_labels(fields, &d.topology, &fragments);
    if (output_fields.includes(*fields.find("fragment", FieldLocation::cell)))
      fragments = find_fragments(snapshot).of_cell;
    solid->write(d.state.time,
                 solid_solution(d.topology, fields, output_fields));
    if (fracture)
      fracture->write(d.state.time,
                      fracture_solution(d.topology,
                                        *snapshot.modules.fracture,
                                        fields,
                                        output_fields));
    flush();
  }

  void
  Results::flush()
  {
    communicator.on_root([this] {
      energy_file->flush();
      if (probes_file)
        probes_file->flush();
    });
  }

  void
  Results::finish(const Snapshot &snapshot, Summary summary)
  {
    const Discretization       &d         = snapshot.body.discretization;
    const std::vector<Fragment> fragments = find_fragments(snapshot).list;

    summary.version           = RIFT_VERSION;
    summary.cells             = communicator.sum(d.topology.n_owned_cells());
    summary.nodes_initial     = initial_nodes;
    summary.nodes_final       = communicator.sum(d.topology.n_owned_nodes());
    summary.steps             = d.state.step;
    summary.time              = d.state.time;
    summary.time_step         = snapshot.time_step;
    summary.ranks             = communicator.size();
    summary.peak_memory_bytes = communicator.sum(peak_memory_bytes());
    summary.fragments         = fragments.size();
    summary.energy            = named_energies(snapshot.ledger);
    summary.energy_residual_relative =
      snapshot.ledger.largest_relative_residual();
    summary.state_hash = state_hash(d.topology, d.state, communicator);
    communicator.on_root([&] {
      call_all({[&] { energy_file->flush(); },
                [&] {
                  if (probes_file)
                    probes_file->flush();
                },
                [&] { write_fragments(path("fragments.csv"), fragments); },
                [&] { write_summary(path("summary.json"), summary); }});
    });
  }
} // namespace rift
