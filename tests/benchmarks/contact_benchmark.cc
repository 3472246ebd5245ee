// Contact of loose cells per second: a cube in pieces of one cell each, which
// are all a little larger than their place, so that each presses against its
// four neighbours and those at its edges, or a little smaller. All of them
// travel.

#include <rift/contact/contact_force.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "granite.h"

namespace rift::test
{
  namespace
  {
    constexpr double time_step = 1e-8;

    /** By so much the cells grow or shrink in a step on the way to their size. */
    constexpr double growth_per_step = 2e-3;

    class LooseCells
    {
    public:
      /** Cells that have come apart and are smaller than their place by a
       * share of 1e-3. */
      explicit LooseCells(const unsigned int n)
        : body(in_pieces(n))
        , activity(body.topology)
        , contact(body.topology, communicator, interface(body))
      {
        activity.wake_all(body.topology);
        // Cracks that have opened so far are contact's business.
        move(-4 * ContactForce::opening);
        follow();
        grow(-1e-3);
      }

      /** Makes the cells larger about their centres, or smaller, in steps. */
      void
      grow(const double new_share)
      {
        while (share != new_share)
          {
            move(std::clamp(new_share,
                            share - growth_per_step,
                            share + growth_per_step));
            follow();
          }
        std::fill(body.state.velocity.begin(),
                  body.state.velocity.end(),
                  NodalVector());
      }

      /** Gives all nodes a velocity along x, by which they move `distance` in a
       * step, m. */
      void
      set_travel(const double distance)
      {
        travel = distance;
        for (NodalVector &v : body.state.velocity)
          v[0] = distance / time_step;
      }

      /** Moves all nodes by a step of their travel. */
      void
      drift()
      {
        for (NodalVector &u : body.state.displacement)
          u[0] += travel;
        ++body.state.step;
      }

      void
      follow()
      {
        contact.follow(body.state, activity, time_step);
      }

      void
      add_forces()
      {
        contact.add_to(body.state, activity, time_step);
      }

      DiscreteBody body;
      Communicator communicator;
      Activity     activity;
      ContactForce contact;

    private:
      /** Nothing else than contact acts between the cells. */
      static DiscreteBody
      in_pieces(const unsigned int n)
      {
        DiscreteBody body = discretize(make_box({{n, n, n}}, granite_edge, .15),
                                       {granite().density},
                                       {true});
        std::fill(body.topology.face_states.begin(),
                  body.topology.face_states.end(),
                  FaceState::released);
        return body;
      }

      static ContactForce::Interface
      interface(const DiscreteBody &body)
      {
        std::vector<double>               spare;
        std::vector<ContactCellConstants> cells;
        for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
          {
            const double mass =
              granite().density *
              body.reference[cell / batch_size].volume[cell % batch_size];
            spare.push_back(mass / n_corners * 1e14);
            cells.push_back({mass, invalid_index});
          }
        return {cells,
                ContactStiffnesses(body.topology, body.reference, spare, 0),
                {{.5}},
                0};
      }

      /** Brings the cells to another size within a step. */
      void
      move(const double new_share)
      {
        const Topology &topology = body.topology;
        State          &state    = body.state;
        for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
          {
            if (topology.is_padding(cell))
              continue;
            Vector3<double> centre{};
            for (unsigned int c = 0; c < n_corners; ++c)
              centre += .25 * state.reference[topology.node(cell, c)].vector();
            for (unsigned int c = 0; c < n_corners; ++c)
              {
                const NodeIndex node = topology.node(cell, c);
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    const double way = (new_share - share) *
                                       (state.reference[node][d] - centre[d]);
                    state.displacement[node][d] += way;
                    state.velocity[node][d] = way / time_step;
                  }
              }
          }
        share = new_share;
      }

      double share = 0, travel = 0;
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
      using benchmark::Counter;
      const double n                      = cells.body.topology.n_cells();
      const double n_touching             = cells.contact.count_touching();
      bench.counters["cells"]             = n;
      bench.counters["touching_per_cell"] = n_touching / n;
      bench.counters["per_cell"] =
        Counter(n * bench.iterations(), Counter::kIsRate | Counter::kInvert);
      if (n_touching > 0)
        bench.counters["per_touching_pair"] =
          Counter(n_touching * bench.iterations(),
                  Counter::kIsRate | Counter::kInvert);
    }

    /** Looking for all pairs anew. */
    void
    search(benchmark::State &bench)
    {
      const double before = memory("VmRSS:");
      LooseCells   cells(bench.range(0));
      const double n                   = cells.body.topology.n_cells();
      bench.counters["bytes_per_cell"] = (memory("VmRSS:") - before) / n;
      // Far enough for a search of all each time.
      cells.set_travel(.1 * granite_edge);
      for (auto _ : bench)
        {
          bench.PauseTiming();
          cells.drift();
          bench.ResumeTiming();
          cells.follow();
        }
      report(bench, cells);
    }

    /** A step in which cells move by so much of their size; searches are rare
     * and included. */
    void
    step(benchmark::State &bench, const double growth)
    {
      LooseCells cells(bench.range(0));
      cells.grow(growth);
      cells.set_travel(1e-4 * granite_edge);
      // The pairs are born.
      cells.follow();
      cells.add_forces();
      for (auto _ : bench)
        {
          bench.PauseTiming();
          cells.drift();
          bench.ResumeTiming();
          cells.follow();
          cells.add_forces();
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
