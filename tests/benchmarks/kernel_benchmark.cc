// Cell-steps per second of the elastic forces with the update of the nodes.

#include <rift/cohesive/face_strengths.h>
#include <rift/time_integration/central_difference.h>

#include <benchmark/benchmark.h>

#include "granite.h"

namespace rift::test
{
  namespace
  {
    /** What the solver holds per cell, with the arrays of the fracture model
     * that exist before anything has broken. */
    double
    bytes_per_cell(const DiscreteBody &body)
    {
      const auto bytes = [](const auto &vector) {
        return static_cast<double>(vector.size() * sizeof(vector[0]));
      };
      const Topology &t   = body.topology;
      const State    &s   = body.state;
      double          sum = bytes(t.batches) + bytes(t.cell_global_indices) +
                   bytes(t.batch_materials) + bytes(t.cell_faces) +
                   bytes(t.faces) + bytes(t.face_states) +
                   bytes(t.node_vertices) + bytes(body.reference) +
                   bytes(s.reference) + bytes(s.displacement) +
                   bytes(s.velocity) + bytes(s.force) + bytes(s.mass);
      // Cells around each vertex, and index_of_face of the cohesive force.
      sum += sizeof(CellIndex) * n_corners * t.n_cells() +
             sizeof(std::uint32_t) * (t.n_vertices() + 1 + t.faces.size());
      // Insertion and Activity: one entry per batch or less.
      sum += (sizeof(std::uint32_t) + 1) * t.n_batches();
      return sum / t.n_cells();
    }

    void
    step_repeatedly(benchmark::State         &run,
                    const MaterialParameters &material,
                    const bool                is_armed)
    {
      DiscreteBody  body = moving_granite(run.range(0));
      InternalForce force(body.topology,
                          body.reference,
                          {make_elasticity(material)});
      Activity      activity(body.topology);
      activity.wake_all(body.topology);
      const StressBounds bounds =
        FaceStrengths(body.topology, body.reference, {material}, {})
          .stress_bounds(Communicator());
      if (is_armed)
        force.watch(bounds);

      constexpr double time_step = 5e-8;
      std::size_t      n_hot     = 0;
      for (auto _ : run)
        {
          if (force.add_to(body.state, activity))
            run.SkipWithError("A cell has failed.");
          n_hot += force.hot_cells().size();
          advance(body.state, activity, time_step);
        }
      if (n_hot > 0)
        run.SkipWithError("Cells are near their strength.");
      run.counters["cells"]          = body.topology.n_cells();
      run.counters["bytes_per_cell"] = bytes_per_cell(body);
      run.counters["cell_steps"]     = benchmark::Counter(
        static_cast<double>(body.topology.n_cells()) * run.iterations(),
        benchmark::Counter::kIsRate);
    }

    void
    isotropic(benchmark::State &run)
    {
      step_repeatedly(run, granite(), false);
    }

    void
    isotropic_armed(benchmark::State &run)
    {
      step_repeatedly(run, granite(), true);
    }

    void
    isotropic_scattered(benchmark::State &run)
    {
      MaterialParameters material = granite();
      material.weibull_modulus    = 5;
      step_repeatedly(run, material, true);
    }

    void
    anisotropic(benchmark::State &run)
    {
      step_repeatedly(run, granite_as_anisotropic(), false);
    }

    void
    anisotropic_armed(benchmark::State &run)
    {
      step_repeatedly(run, granite_as_anisotropic(), true);
    }

    /** The same loop over a body of which nothing has moved yet. */
    void
    at_rest(benchmark::State &run)
    {
      DiscreteBody  body = moving_granite(run.range(0));
      InternalForce force(body.topology,
                          body.reference,
                          {make_elasticity(granite())});
      Activity      activity(body.topology);
      for (auto _ : run)
        {
          benchmark::DoNotOptimize(force.add_to(body.state, activity));
          advance(body.state, activity, 5e-8);
        }
      run.counters["cell_steps"] = benchmark::Counter(
        static_cast<double>(body.topology.n_cells()) * run.iterations(),
        benchmark::Counter::kIsRate);
    }

    // Cubes of 20 and 55 edges: 48,000 and 998,250 cells.
    BENCHMARK(isotropic)->Arg(20)->Arg(55)->Unit(benchmark::kMillisecond);
    BENCHMARK(isotropic_armed)->Arg(20)->Arg(55)->Unit(benchmark::kMillisecond);
    // Among a million cells some are so weak that they are near their strength.
    BENCHMARK(isotropic_scattered)->Arg(20)->Unit(benchmark::kMillisecond);
    BENCHMARK(anisotropic)->Arg(20)->Arg(55)->Unit(benchmark::kMillisecond);
    BENCHMARK(anisotropic_armed)
      ->Arg(20)
      ->Arg(55)
      ->Unit(benchmark::kMillisecond);
    BENCHMARK(at_rest)->Arg(20)->Unit(benchmark::kMillisecond);
  } // namespace
} // namespace rift::test
