#include <rift/app/results.h>
#include <rift/io/fragments.h>
#include <rift/io/output_directory.h>
#include <rift/io/solution_fields.h>

#include <sys/resource.h>

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

    Fragments
    fragments_of(const Snapshot                     &snapshot,
                 const std::vector<Vector3<double>> &velocity)
    {
      std::vector<double> densities;
      for (const MaterialParameters &material : snapshot.body.materials)
        densities.push_back(material.density);
      const Discretization &d = snapshot.body.discretization;
      return find_fragments(d.topology,
                            d.reference,
                            densities,
                            d.state,
                            velocity);
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
    : directory(parameters.output.directory)
    , solution_interval(parameters.output.solution_interval)
    , history_interval(parameters.output.history_interval)
    , initial_nodes(body.discretization.topology.n_nodes())
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
                                                             surface->second);
      }
  }

  void
  Results::open(const Parameters &parameters, Log &log)
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

    if (solution_interval > 0)
      {
        solid.emplace(directory, "solid");
        if (parameters.cohesive.model != CohesiveParameters::Model::none)
          fracture.emplace(directory, "fracture");
      }
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
    const State        &state = snapshot.body.discretization.state;
    std::vector<double> row   = {state.time};
    for (const auto &term : named_energies(snapshot.ledger))
      row.push_back(term.second);
    energy_file->append(row);

    if (probes.empty())
      return;
    const auto velocity = velocity_at_step(state, snapshot.time_step);
    row                 = {state.time};
    for (const Probe &probe : probes)
      row.push_back(probe.value(snapshot.body.discretization.topology,
                                snapshot.internal_force,
                                state,
                                velocity));
    probes_file->append(row);
  }

  void
  Results::write_solution(const Snapshot &snapshot)
  {
    ++n_solutions;
    const Discretization &d = snapshot.body.discretization;
    const auto velocity     = velocity_at_step(d.state, snapshot.time_step);
    solid->write(d.state.time,
                 solid_solution(d.topology,
                                d.state,
                                snapshot.internal_force,
                                velocity,
                                fragments_of(snapshot, velocity)));
    if (fracture)
      fracture->write(d.state.time,
                      fracture_solution(d.state, *snapshot.cohesive_force));
    flush();
  }

  void
  Results::flush()
  {
    energy_file->flush();
    if (probes_file)
      probes_file->flush();
  }

  void
  Results::finish(const Snapshot &snapshot, Summary summary)
  {
    flush();
    const Discretization &d = snapshot.body.discretization;
    const auto            fragments =
      fragments_of(snapshot, velocity_at_step(d.state, snapshot.time_step));
    write_fragments(path("fragments.csv"), fragments);

    summary.version           = RIFT_VERSION;
    summary.cells             = d.topology.n_cells();
    summary.nodes_initial     = initial_nodes;
    summary.nodes_final       = d.topology.n_nodes();
    summary.steps             = d.state.step;
    summary.time              = d.state.time;
    summary.time_step         = snapshot.time_step;
    summary.peak_memory_bytes = peak_memory_bytes();
    summary.fragments         = fragments.list.size();
    summary.energy            = named_energies(snapshot.ledger);
    summary.energy_residual_relative =
      snapshot.ledger.largest_relative_residual();
    summary.state_hash = state_hash(d.topology, d.state);
    write_summary(path("summary.json"), summary);
  }
} // namespace rift
