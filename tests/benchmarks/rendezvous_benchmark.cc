// What it costs to divide space and to search for contact on several ranks:
// loose cells at the surface of a sphere, of which each rank owns a slice.
// usage: mpirun -np N rendezvous_benchmark [CELLS OF ALL RANKS]

#include <rift/contact/background_octree.h>
#include <rift/contact/rendezvous.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdio>
#include <random>

namespace rift::test
{
  namespace
  {
    /** As those of a mesh are. */
    void
    order_along_curve(std::vector<ContactCell> &cells,
                      const std::int64_t        first_name)
    {
      const SpaceDivision space({{-1, -1, -1}}, 2, {});
      std::sort(cells.begin(), cells.end(), [&](const auto &a, const auto &b) {
        return space.key_of(a.positions[0]) < space.key_of(b.positions[0]);
      });
      auto name = static_cast<GlobalCellIndex>(first_name);
      for (ContactCell &cell : cells)
        {
          cell.cell = name++;
          for (unsigned int c = 0; c < n_corners; ++c)
            cell.groups[c] = std::uint64_t(n_corners) * cell.cell + c;
        }
    }

    /** In one layer, so dense that they lie in each other. */
    std::vector<ContactCell>
    own_cells(const Communicator &communicator, const std::int64_t n_cells)
    {
      std::mt19937                     random(communicator.rank());
      std::normal_distribution<double> normal;
      const double                     size = 4 / std::sqrt(double(n_cells));
      const auto                       n    = n_cells / communicator.size();
      std::vector<ContactCell>         cells;
      for (std::int64_t i = 0; i < n; ++i)
        {
          Vector3<double> x;
          for (double &component : x)
            component = normal(random);
          x = (1 / norm(x)) * x;
          // The slice of this rank.
          x[2] =
            2 * (communicator.rank() + std::abs(x[2])) / communicator.size() -
            1;
          ContactCell cell{};
          cell.owner          = communicator.rank();
          cell.constants.body = invalid_index;
          cell.margin         = .1 * size;
          cell.behind.fill(invalid_index);
          for (unsigned int c = 0; c < n_corners; ++c)
            {
              cell.positions[c] = x;
              if (c > 0)
                cell.positions[c][c - 1] += size;
            }
          cells.push_back(cell);
        }
      order_along_curve(cells, communicator.rank() * n);
      return cells;
    }

    /** Seconds that `f` takes on the slowest rank. */
    template <typename Function>
    double
    time_of(const Communicator &communicator, const Function &f)
    {
      MPI_Barrier(communicator.mpi());
      const double start = MPI_Wtime();
      f();
      return communicator.max(MPI_Wtime() - start);
    }

    void
    run(const Communicator &communicator, const std::int64_t n_cells)
    {
      const std::vector<ContactCell> own = own_cells(communicator, n_cells);
      std::vector<Vector3<double>>   points;
      for (const ContactCell &cell : own)
        points.push_back(cell.positions[0]);
      Rendezvous  rendezvous(communicator, [&](const ContactCell &) {
        return std::vector<int>{communicator.rank()};
      });
      double      divide = 1e9, search = 1e9;
      std::size_t n_pairs = 0;
      rendezvous.update(own);
      for (unsigned int i = 0; i < 10; ++i)
        {
          divide = std::min(divide, time_of(communicator, [&] {
                              divide_space(points, communicator);
                            }));
          search = std::min(search, time_of(communicator, [&] {
                              n_pairs = rendezvous.update(own).pairs.size();
                            }));
        }
      if (communicator.is_root())
        std::printf(
          "%d ranks, %ld cells, %.1f pairs per cell: division %.1f "
          "ms (%.2f us per cell), search %.1f ms (%.2f us per cell)\n",
          communicator.size(),
          static_cast<long>(n_cells),
          double(n_pairs) / own.size(),
          1e3 * divide,
          1e6 * divide / own.size(),
          1e3 * search,
          1e6 * search / own.size());
    }
  } // namespace
} // namespace rift::test

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const rift::Communicator                 communicator(MPI_COMM_WORLD);
  if (argc > 1)
    rift::test::run(communicator, std::atol(argv[1]));
  else
    for (const std::int64_t n_cells : {1000, 10000, 100000, 1000000})
      rift::test::run(communicator, n_cells);
}
