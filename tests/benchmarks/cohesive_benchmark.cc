// Cohesive faces per second: a cube of granite whose faces are all cut.

#include <rift/cohesive/cohesive_force.h>

#include <benchmark/benchmark.h>

#include "granite.h"

namespace rift::test
{
  namespace
  {
    /** The cube in pieces of one cell, joined by cohesive elements. */
    class CutGranite
    {
    public:
      explicit CutGranite(const unsigned int n)
        : body(discretize(make_box({{n, n, n}}, granite_edge, .15),
                          {granite().density}))
        , strengths(body.topology, {granite()}, {})
        , force(body.topology,
                body.reference,
                strengths,
                {stiffness_matrix(make_elasticity(granite()))},
                {granite().density},
                time_step)
      {
        std::vector<FaceIndex> faces(body.topology.faces.size());
        for (FaceIndex face = 0; face < faces.size(); ++face)
          faces[face] = face;
        const TopologyChange change = split_nodes(body.topology, faces);
        body.state.grow(change);
        force.apply(change);
        force.start_openings(body.state, force.hold_partings(body.state, {}));
      }

      /** Every cell moves away from its neighbours: by `share` of its place
       * along x, and half of that along y, a mixed opening. */
      void
      pull(const double share)
      {
        const Topology &topology = body.topology;
        for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
          if (!topology.is_padding(cell))
            {
              double x = 0;
              for (unsigned int c = 0; c < n_corners; ++c)
                x += .25 * body.state.reference[topology.node(cell, c)][0];
              for (unsigned int c = 0; c < n_corners; ++c)
                {
                  NodalVector &u =
                    body.state.displacement[topology.node(cell, c)];
                  u[0] = share * x;
                  u[1] = .5 * share * x;
                }
            }
      }

      static constexpr double time_step = 5e-8;

      DiscreteBody  body;
      FaceStrengths strengths;
      CohesiveForce force;
    };

    void
    count_faces(benchmark::State &run, const CohesiveForce &force)
    {
      run.counters["faces"] = force.faces().size();
      run.counters["bytes_per_face"] =
        sizeof(CohesiveBatch) / batch_size + sizeof(CohesiveFaceInfo);
      run.counters["face_steps"] = benchmark::Counter(
        static_cast<double>(force.faces().size()) * run.iterations(),
        benchmark::Counter::kIsRate);
    }

    void
    elastic(benchmark::State &run)
    {
      CutGranite cut(run.range(0));
      cut.pull(1e-6);
      for (auto _ : run)
        cut.force.add_to(cut.body.state);
      if (cut.force.energy().fracture.value() != 0)
        run.SkipWithError("Faces have softened.");
      count_faces(run, cut.force);
    }

    void
    softening(benchmark::State &run)
    {
      CutGranite cut(run.range(0));
      double     share = 0;
      for (auto _ : run)
        {
          run.PauseTiming();
          share += 1e-4;
          cut.pull(share);
          run.ResumeTiming();
          cut.force.add_to(cut.body.state);
        }
      if (!(cut.force.energy().fracture.value() > 0))
        run.SkipWithError("No face has softened.");
      count_faces(run, cut.force);
    }

    // 48,000 cells; the softening run ends when about half of the faces have
    // failed.
    BENCHMARK(elastic)->Arg(20)->Unit(benchmark::kMillisecond);
    BENCHMARK(softening)->Arg(20)->Iterations(300)->Unit(
      benchmark::kMillisecond);
  } // namespace
} // namespace rift::test
