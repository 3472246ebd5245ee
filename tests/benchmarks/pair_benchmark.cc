// Forces of pairs of cells per second, with friction and all that belongs to
// them but the sums at nodes; the scalar overlap alone; and gaps.

#include <rift/contact/separation.h>

#include <benchmark/benchmark.h>

#include "../support/contact_pairs.h"
#include "../support/scalar_overlap.h"

#include <memory>

namespace rift::test
{
  namespace
  {
    /** As many as do not fit into the fastest memory. */
    constexpr unsigned int n_pairs = 32 * PairKernel::chunk_size;

    /** Pairs of a kind that overlap, or that do not. */
    PairList
    make_pairs(const PairKind kind)
    {
      PairGenerator make(1);
      PairList      list;
      while (list.pairs.size() < n_pairs)
        {
          list.add(make, kind);
          const CellPair &pair = list.pairs.back();
          const Overlap   common =
            scalar_overlap(unpack(list.cells[pair.a]).positions,
                           unpack(list.cells[pair.b]).positions);
          if ((common.volume > 0) == (kind == PairKind::parted))
            list.pairs.pop_back();
        }
      return list;
    }

    void
    report(benchmark::State &bench)
    {
      bench.counters["per_pair"] = benchmark::Counter(
        1. * n_pairs * bench.iterations(),
        benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    }

    void
    forces(benchmark::State &bench, const PairKind kind)
    {
      const PairList           list = make_pairs(kind);
      std::vector<ContactPair> pairs;
      for (const CellPair &cells : list.pairs)
        pairs.push_back({cells, {1e9, .5, .1, 1e3}, {}});
      const auto              kernel = std::make_unique<PairKernel>();
      std::vector<PairForces> result(PairKernel::chunk_size);
      for (auto _ : bench)
        for (unsigned int i = 0; i < n_pairs; i += PairKernel::chunk_size)
          {
            kernel->compute(list.cells.data(),
                            &pairs[i],
                            PairKernel::chunk_size,
                            1e-8,
                            result.data());
            benchmark::DoNotOptimize(result.data());
          }
      report(bench);
    }

    void
    overlaps(benchmark::State &bench, const PairKind kind)
    {
      const PairList list  = make_pairs(kind);
      const auto     batch = std::make_unique<OverlapBatch>();
      for (auto _ : bench)
        for (unsigned int i = 0; i < n_pairs; i += OverlapBatch::chunk_size)
          benchmark::DoNotOptimize(batch->intersect(list.cells.data(),
                                                    &list.pairs[i],
                                                    OverlapBatch::chunk_size));
      report(bench);
    }

    void
    scalar_overlaps(benchmark::State &bench, const PairKind kind)
    {
      const PairList list = make_pairs(kind);
      for (auto _ : bench)
        for (const CellPair &pair : list.pairs)
          benchmark::DoNotOptimize(
            scalar_overlap(unpack(list.cells[pair.a]).positions,
                           unpack(list.cells[pair.b]).positions));
      report(bench);
    }

    void
    gaps(benchmark::State &bench)
    {
      const PairList            list = make_pairs(PairKind::parted);
      std::vector<std::uint8_t> axes(n_pairs, no_axis);
      std::vector<double>       result(n_pairs);
      for (auto _ : bench)
        {
          find_gaps(list.cells.data(),
                    list.pairs.data(),
                    n_pairs,
                    axes.data(),
                    result.data());
          benchmark::DoNotOptimize(result.data());
        }
      report(bench);
    }

    BENCHMARK_CAPTURE(scalar_overlaps, pressed, PairKind::pressed);
    BENCHMARK_CAPTURE(overlaps, pressed, PairKind::pressed);
    BENCHMARK_CAPTURE(forces, pressed, PairKind::pressed);
    BENCHMARK_CAPTURE(scalar_overlaps, deep, PairKind::deep);
    BENCHMARK_CAPTURE(overlaps, deep, PairKind::deep);
    BENCHMARK_CAPTURE(forces, deep, PairKind::deep);
    BENCHMARK_CAPTURE(scalar_overlaps, tip_in_face, PairKind::tip_in_face);
    BENCHMARK_CAPTURE(overlaps, tip_in_face, PairKind::tip_in_face);
    BENCHMARK_CAPTURE(forces, tip_in_face, PairKind::tip_in_face);
    BENCHMARK(gaps);
  } // namespace
} // namespace rift::test
