// Cohesive faces per second: a cube of granite whose faces are all cut.

#include <rift/cohesive/cohesive_force.h>
#include <rift/solid/internal_force.h>
#include <rift/time_integration/central_difference.h>

#include <benchmark/benchmark.h>

#include "granite.h"

namespace rift::test
{
  namespace
  {
    CohesiveParameters
    parameters_of(const CohesiveModel model)
    {
      CohesiveParameters parameters;
      parameters.model = model;
      parameters.law   = "faces";
      return parameters;
    }

    /** The cube in pieces of one cell, joined by cohesive elements. */
    class CutGranite
    {
    public:
      CutGranite(const unsigned int n, const CohesiveModel model)
        : body(discretize(make_box({{n, n, n}}, granite_edge, .15),
                          {granite().density},
                          model == CohesiveModel::intrinsic ?
                            std::vector<bool>{true} :
                            std::vector<bool>()))
        , activity(body.topology)
        , strengths(body.topology, body.reference, {granite()}, {})
        , force(
            body.topology,
            body.reference,
            strengths,
            parameters_of(model),
            IntrinsicPenalty(body.topology,
                             body.reference,
                             body.state,
                             {10, true},
                             {granite()},
                             {stiffness_matrix(make_elasticity(granite()))}))
      {
        if (model == CohesiveModel::intrinsic)
          {
            activity.wake_all(body.topology);
            force.start_all(body.state);
            return;
          }
        std::vector<FaceIndex> faces(body.topology.faces.size());
        for (FaceIndex face = 0; face < faces.size(); ++face)
          faces[face] = face;
        const TopologyChange change = split_nodes(body.topology, faces);
        body.state.grow(change);
        activity = Activity(body.topology);
        activity.wake_all(body.topology);
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

      DiscreteBody  body;
      Activity      activity;
      FaceStrengths strengths;
      CohesiveForce force;
    };

    void
    count_faces(benchmark::State &run, CohesiveForce &force)
    {
      const CohesiveFaces &faces = force.faces();
      const double         n     = faces.size();
      run.counters["faces"]      = n;
      run.counters["bytes_per_face"] =
        (faces.batches.size() * sizeof(CohesiveBatch) +
         force.elements_of_law().n_bytes()) /
          n +
        sizeof(CohesiveFaceInfo);
      run.counters["face_steps"] =
        benchmark::Counter(n * run.iterations(), benchmark::Counter::kIsRate);
    }

    void
    elastic(benchmark::State &run, const CohesiveModel model)
    {
      CutGranite cut(run.range(0), model);
      cut.pull(1e-6);
      for (auto _ : run)
        cut.force.add_to(cut.body.state, cut.activity);
      if (cut.force.energy(cut.body.state).fracture.value() != 0)
        run.SkipWithError("Faces have softened.");
      count_faces(run, cut.force);
    }

    /** Whole steps of the intrinsic model: cells, faces, kick and drift. */
    void
    intrinsic_steps(benchmark::State &run)
    {
      CutGranite    cut(run.range(0), CohesiveModel::intrinsic);
      InternalForce internal_force(cut.body.topology,
                                   cut.body.reference,
                                   {make_elasticity(granite())});
      cut.pull(1e-7);
      for (auto _ : run)
        {
          benchmark::DoNotOptimize(
            internal_force.add_to(cut.body.state, cut.activity));
          cut.force.add_to(cut.body.state, cut.activity);
          advance(cut.body.state, cut.activity, 1e-12);
        }
      if (cut.force.energy(cut.body.state).fracture.value() != 0)
        run.SkipWithError("Faces have softened.");
      count_faces(run, cut.force);
      run.counters["cell_steps"] = benchmark::Counter(
        static_cast<double>(cut.body.topology.n_owned_cells()) *
          run.iterations(),
        benchmark::Counter::kIsRate);
    }

    void
    softening(benchmark::State &run)
    {
      CutGranite cut(run.range(0), CohesiveModel::extrinsic);
      double     share = 0;
      for (auto _ : run)
        {
          run.PauseTiming();
          share += 1e-4;
          cut.pull(share);
          run.ResumeTiming();
          cut.force.add_to(cut.body.state, cut.activity);
        }
      if (!(cut.force.energy(cut.body.state).fracture.value() > 0))
        run.SkipWithError("No face has softened.");
      count_faces(run, cut.force);
    }

    // 48,000 cells; the softening run ends when about half of the faces have
    // failed.
    BENCHMARK_CAPTURE(elastic, extrinsic, CohesiveModel::extrinsic)
      ->Arg(20)
      ->Unit(benchmark::kMillisecond);
    BENCHMARK_CAPTURE(elastic, intrinsic, CohesiveModel::intrinsic)
      ->Arg(20)
      ->Unit(benchmark::kMillisecond);
    BENCHMARK(intrinsic_steps)
      ->Arg(6)
      ->Arg(10)
      ->Arg(20)
      ->Unit(benchmark::kMillisecond);
    BENCHMARK(softening)->Arg(20)->Iterations(300)->Unit(
      benchmark::kMillisecond);
  } // namespace
} // namespace rift::test
