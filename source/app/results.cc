#include <rift/app/results.h>
#include <rift/io/fragments.h>
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

    std::vector<double>
    densities_of(const Body &body)
    {
      std::vector<double> densities;
      for (const MaterialParameters &material : body.materials)
        densities.push_back(material.density);
      return densities;
    }

    /** Number of nodes that this rank owns. */
    std::size_t
    n_owned_nodes(const Topology &topology)
    {
      std::size_t n = 0;
      for (NodeIndex node = 0; node < topology.n_nodes(); ++node)
        n += topology.owns_node(node) ? 1 : 0;
      return n;
    }

    /** The terms of the ledger with their names. */
    NamedNumbers
    named_energies(const EnergyLedger &ledger)
    {
      const Energies &e = ledger.energies();
      return {{"kinetic", e.kinetic},
              {"strain", e.strain},
              {"cohesive", e.cohesive},
              {"fracture", e.fracture},
              {"contact", e.contact},
              {"friction", e.friction},
              {"damping", e.damping},
              {"loads", e.loads},
              {"residual", ledger.residual()}};
    }
  } // namespace

  Results::Results(const Parameters &parameters, const Body &body)
    : communicator(body.communicator)
    , directory(parameters.output.directory)
    , solution_interval(parameters.output.solution_interval)
    , history_interval(parameters.output.history_interval)
    , ranks_per_file(parameters.output.ranks_per_file)
    , initial_nodes(
        communicator.sum(n_owned_nodes(body.discretization.topology)))
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
  Results::open(const Parameters &parameters, Log &log)
  {
    communicator.on_root([&] { open_files(parameters, log); });
    if (solution_interval > 0)
      {
        solid.emplace(directory, "solid", communicator, ranks_per_file);
        if (parameters.cohesive.model != CohesiveParameters::Model::none)
          fracture.emplace(directory, "fracture", communicator, ranks_per_file);
      }
    was_opened = true;
  }

  void
  Results::open_files(const Parameters &parameters, Log &log)
  {
    prepare_output_directory(directory, parameters.output.overwrite);
    log.open(path("log.txt"));
    // The first line tells a later run that the file may be replaced.
    write_file_atomically(path("parameters.prm"),
                          std::string(parameters_marker) + "\n" +
                            used_parameters(parameters));

    std::vector<std::string> columns = {"time [s]"};
    for (const Probe &probe : probes)
      columns.push_back(probe.header());
    if (!probes.empty())
      probes_file.emplace(path("probes.csv"), columns);

    columns = {"time [s]"};
    for (const auto &term : named_energies(EnergyLedger()))
      columns.push_back(term.first + " [J]");
    energy_file.emplace(path("energy.csv"), columns);
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
           probe_values(probes,
                        d.topology,
                        snapshot.internal_force,
                        d.state,
                        velocity_at_step(d.state, snapshot.time_step),
                        communicator))
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
    ++n_solutions;
    const Discretization &d = snapshot.body.discretization;
    solid->write(d.state.time,
                 solid_solution(d.topology,
                                d.state,
                                snapshot.internal_force,
                                velocity_at_step(d.state, snapshot.time_step),
                                number_fragments(d.topology,
                                                 d.reference,
                                                 densities_of(snapshot.body),
                                                 communicator)));
    if (fracture)
      fracture->write(
        d.state.time,
        fracture_solution(d.topology, d.state, *snapshot.cohesive_force));
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
    flush();
    const Discretization &d = snapshot.body.discretization;
    const auto            fragments =
      list_fragments(d.topology,
                     d.reference,
                     densities_of(snapshot.body),
                     d.state,
                     velocity_at_step(d.state, snapshot.time_step),
                     communicator);

    summary.version           = RIFT_VERSION;
    summary.cells             = communicator.sum(d.topology.n_owned_cells());
    summary.nodes_initial     = initial_nodes;
    summary.nodes_final       = communicator.sum(n_owned_nodes(d.topology));
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
      write_fragments(path("fragments.csv"), fragments);
      write_summary(path("summary.json"), summary);
    });
  }
} // namespace rift
