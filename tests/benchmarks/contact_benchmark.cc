// Contact of loose cells per second: a cube in pieces of one cell each, which
// are all a little larger than their place, so that each presses against its
// four neighbours and those at its edges, or a little smaller.

#include <rift/contact/contact_force.h>

#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

#include "granite.h"

namespace rift::test
{
  namespace
  {
    class LooseCells
    {
    public:
      explicit LooseCells(const unsigned int n)
        : body(discretize(make_box({{n, n, n}}, granite_edge, .15),
                          {granite().density},
                          {true}))
        , activity(body.topology)
        , contact(body.topology, body.state, communicator, interface())
      {
        activity.wake_all(body.topology);
      }

      /** Makes the cells larger about their centres, or smaller. */
      void
      grow(const double share)
      {
        const Topology &topology = body.topology;
        for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
          {
            if (topology.is_padding(cell))
              continue;
            Vector3<double> centre{};
            for (unsigned int c = 0; c < n_corners; ++c)
              centre +=
                .25 * body.state.reference[topology.node(cell, c)].vector();
            for (unsigned int c = 0; c < n_corners; ++c)
              {
                const NodeIndex node = topology.node(cell, c);
                for (unsigned int d = 0; d < dim; ++d)
                  body.state.displacement[node][d] =
                    share * (body.state.reference[node][d] - centre[d]);
              }
          }
      }

      DiscreteBody body;
      Communicator communicator;
      Activity     activity;
      ContactForce contact;

    private:
      /** All faces have opened. */
      ContactForce::Interface
      interface() const
      {
        ContactForce::Interface result;
        result.cells.assign(body.topology.n_cell_slots(),
                            {1e10, 1., invalid_index});
        result.friction           = {{.5}};
        result.damping            = 0;
        result.is_held            = [](FaceIndex) { return false; };
        result.n_crack_events     = [] { return std::uint64_t(1); };
        result.for_each_open_face = [this](const auto &f) {
          for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
            f(face);
        };
        return result;
      }
    };

    /** Memory that this process has now, or has had at most: "VmRSS:",
     * "VmHWM:". */
    double
    memory(const std::string &name)
    {
      std::ifstream status("/proc/self/status");
      std::string   word;
      while (status >> word && word != name)
        ;
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }

    void
    report(benchmark::State &bench, const LooseCells &cells)
    {
      const double n                      = cells.body.topology.n_cells();
      bench.counters["cells"]             = n;
      bench.counters["touching_per_cell"] = cells.contact.count_touching() / n;
      bench.counters["cell_steps"] =
        benchmark::Counter(n * bench.iterations(), benchmark::Counter::kIsRate);
    }

    /** Looking for all pairs anew. */
    void
    search(benchmark::State &bench)
    {
      LooseCells cells(bench.range(0));
      cells.grow(-1e-3);
      const double before = memory("VmRSS:");
      // New pairs cost more: the volumes with which they start.
      cells.contact.follow(cells.body.state, 0);
      const double n                   = cells.body.topology.n_cells();
      bench.counters["bytes_per_cell"] = (memory("VmRSS:") - before) / n;
      for (auto _ : bench)
        {
          // Far enough for a search each time.
          for (NodalVector &u : cells.body.state.displacement)
            u[0] += granite_edge;
          cells.contact.follow(cells.body.state, 0);
        }
      bench.counters["bytes_per_cell_at_most"] =
        (memory("VmHWM:") - before) / n;
      report(bench, cells);
    }

    /** A step between two searches. */
    void
    step(benchmark::State &bench, const double growth)
    {
      LooseCells cells(bench.range(0));
      cells.grow(-1e-3);
      cells.contact.follow(cells.body.state, 0);
      // Not so far that pairs would be searched for anew.
      cells.grow(growth);
      cells.body.state.step = 1;
      for (auto _ : bench)
        {
          cells.contact.follow(cells.body.state, 0);
          cells.contact.add_to(cells.body.state, cells.activity, 1e-8);
        }
      report(bench, cells);
    }

    void
    step_apart(benchmark::State &bench)
    {
      step(bench, -1e-3);
    }

    void
    step_pressed(benchmark::State &bench)
    {
      step(bench, 1e-3);
    }

    BENCHMARK(search)->Arg(6)->Arg(12)->Arg(26)->Arg(55)->Unit(
      benchmark::kMillisecond);
    BENCHMARK(step_apart)
      ->Arg(6)
      ->Arg(12)
      ->Arg(26)
      ->Arg(55)
      ->Unit(benchmark::kMillisecond);
    BENCHMARK(step_pressed)
      ->Arg(6)
      ->Arg(12)
      ->Arg(26)
      ->Unit(benchmark::kMillisecond);
  } // namespace
} // namespace rift::test
