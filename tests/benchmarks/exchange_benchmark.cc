// What it costs that ranks compute ghost cells instead of sending each other
// forces. Both ways take elastic steps of the same body in turn:
//
//   ghosts: forces of owned cells and ghosts in canonical order, kick and
//           drift, exchange of positions; bitwise the same on any number of
//           ranks. This is what rift does.
//   sums:   forces of owned cells alone, exchange and addition of the forces
//           of nodes that several ranks share, kick and drift.
//
//   mpirun -np 2 exchange_benchmark SCENE.prm [SECTION/NAME=VALUE ...]

#include <rift/base/exceptions.h>
#include <rift/mesh/partition.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "exchange_steps.h"

namespace rift::test
{
  namespace
  {
    constexpr unsigned int n_repetitions = 25;

    /** Cell-steps of all ranks together in one repetition. */
    constexpr double work_per_repetition = 2e7;

    /** Strains of about 1e-5 that depend on the place alone. */
    void
    deform(State &state)
    {
      for (NodeIndex node = 0; node < state.n_nodes(); ++node)
        for (unsigned int d = 0; d < dim; ++d)
          state.displacement[node][d] =
            1e-8 * std::sin(1e3 * (state.reference[node][d] +
                                   .5 * state.reference[node][(d + 1) % dim]));
    }

    /** Times per step, s, of all repetitions: the slowest rank's. */
    struct Times
    {
      std::vector<double> step, computing;
    };

    void
    measure(Steps              &steps,
            const unsigned int  n_steps,
            const Communicator &communicator,
            Times              &times)
    {
      MPI_Barrier(communicator.mpi());
      const double start = MPI_Wtime();
      for (unsigned int i = 0; i < n_steps; ++i)
        steps.step();
      const double wall = MPI_Wtime() - start;
      times.step.push_back(communicator.max(wall) / n_steps);
      times.computing.push_back(communicator.max(steps.take_computing_time()) /
                                n_steps);
    }

    double
    median(std::vector<double> values)
    {
      std::nth_element(values.begin(),
                       values.begin() + values.size() / 2,
                       values.end());
      return values[values.size() / 2];
    }

    double
    median_ratio(const std::vector<double> &a, const std::vector<double> &b)
    {
      std::vector<double> ratios;
      for (std::size_t i = 0; i < a.size(); ++i)
        ratios.push_back(a[i] / b[i]);
      return median(ratios);
    }

    /** Largest difference of displacements over the largest of them. */
    double
    difference(const Discretization &all, const OwnedPart &part)
    {
      double largest = 0, difference = 0;
      for (VertexIndex v = 0; v < part.vertex_numbers.size(); ++v)
        if (const NodeIndex node = part.vertex_numbers[v];
            node != invalid_index)
          for (unsigned int d = 0; d < dim; ++d)
            {
              const double u = all.state.displacement[v][d];
              largest        = std::max(largest, std::abs(u));
              difference =
                std::max(difference,
                         std::abs(u - part.state.displacement[node][d]));
            }
      return difference / largest;
    }

    void
    print(const char *name, const Times &times, const std::size_t n_bytes)
    {
      std::printf("%s: %.3f ms per step, of it %.3f ms of the processor for "
                  "forces and nodes; rank 0 sends %zu bytes\n",
                  name,
                  1e3 * median(times.step),
                  1e3 * median(times.computing),
                  n_bytes);
    }

    void
    compare(const std::string              &scene,
            const std::vector<std::string> &overrides,
            const Communicator             &communicator)
    {
      const Parameters parameters = read_parameters(scene, overrides);
      const MeshData   mesh       = make_mesh(parameters, communicator);
      Log              silence(nullptr);
      Body             body = make_body(
        parameters,
        mesh,
        partition_cells(mesh, communicator.size(), parameters.mesh.partition),
        communicator,
        silence);
      Discretization &all = body.discretization;
      if (all.topology.n_nodes() != all.topology.n_vertices())
        throw InputError("a body with pieces that only touch is not foreseen.");
      deform(all.state);
      OwnedPart  part(all);
      GhostSteps ghosts(body);
      SumSteps   sums(body, part);

      const auto sum_of = [&](const std::size_t n) {
        return communicator.sum(static_cast<std::int64_t>(n));
      };
      const double n_owned   = sum_of(all.topology.n_owned_cells());
      const double n_visible = sum_of(all.topology.n_cells());
      const auto   n_steps =
        static_cast<unsigned int>(std::ceil(work_per_repetition / n_owned));
      Times of_ghosts, of_sums;
      for (unsigned int i = 0; i < n_repetitions; ++i)
        {
          measure(ghosts, n_steps, communicator, of_ghosts);
          measure(sums, n_steps, communicator, of_sums);
        }
      const double error = communicator.max(difference(all, part));
      if (!(error < 1e-9))
        throw RunError("the two ways differ by " + std::to_string(error));
      if (!communicator.is_root())
        return;
      std::printf("%.0f cells, %d ranks, redundancy %.4f; %u repetitions of %u "
                  "steps; displacements differ by %.1e\n",
                  n_owned,
                  communicator.size(),
                  n_visible / n_owned,
                  n_repetitions,
                  n_steps,
                  error);
      print("ghosts", of_ghosts, all.exchange.n_bytes());
      print("sums", of_sums, sums.n_bytes());
      std::printf("ghosts over sums: %.3f; of the processor: %.3f\n",
                  median_ratio(of_ghosts.step, of_sums.step),
                  median_ratio(of_ghosts.computing, of_sums.computing));
    }
  } // namespace
} // namespace rift::test

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const rift::Communicator                 communicator(MPI_COMM_WORLD);
  try
    {
      if (argc < 2)
        throw rift::InputError("usage: exchange_benchmark SCENE.prm "
                               "[SECTION/NAME=VALUE ...]");
      rift::test::compare(argv[1], {argv + 2, argv + argc}, communicator);
    }
  catch (const rift::Error &error)
    {
      if (communicator.is_root())
        std::fprintf(stderr, "exchange_benchmark: %s\n", error.what());
      return 1;
    }
}
