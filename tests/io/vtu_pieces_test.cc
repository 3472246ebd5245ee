// Output for ParaView on several ranks, read back by rank 0.

#include <rift/base/exceptions.h>
#include <rift/io/vtu_output.h>

#include "../file_size_limit.h"
#include "../support/shared_directory.h"
#include "../support/vtu_file.h"

using namespace rift;
using namespace rift::test;

namespace
{
  /** `n` tetrahedra that tell of the rank; they have one point in common. */
  Solution
  piece_of(const int rank, const unsigned int n)
  {
    Solution    solution;
    OutputField speed{"speed [m/s]", 1, {}}, number{"number", 1, {}};
    for (unsigned int i = 0; i <= 3 * n && n > 0; ++i)
      {
        solution.points.push_back({{1. * rank, .1 * i, 1. / (1 + i)}});
        speed.values.push_back(static_cast<float>(100 * rank + i));
      }
    for (unsigned int i = 0; i < n; ++i)
      {
        for (const unsigned int point : {0u, 3 * i + 1, 3 * i + 2, 3 * i + 3})
          solution.cells.push_back(point);
        number.values.push_back(static_cast<float>(1000 * rank + i));
      }
    solution.point_data = {speed};
    solution.cell_data  = {number};
    return solution;
  }

  /** Some ranks have no cells; one has more than a block of data. */
  unsigned int
  n_cells_of(const int rank)
  {
    return rank == 1 ? 0 : rank == 2 ? 30000 : 2;
  }

  void
  expect_piece(const VtuFile &piece, const Solution &expected)
  {
    EXPECT_EQ(attribute(piece.element("<Piece"), "NumberOfPoints"),
              std::to_string(expected.points.size()));
    EXPECT_EQ(attribute(piece.element("<Piece"), "NumberOfCells"),
              std::to_string(expected.cells.size() / 4));
    std::vector<double> coordinates;
    for (const auto &point : expected.points)
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    EXPECT_EQ(piece.array<double>("Points"), coordinates);
    EXPECT_EQ(piece.array<std::uint32_t>("connectivity"), expected.cells);
    EXPECT_EQ(piece.array<float>("speed [m/s]"), expected.point_data[0].values);
    EXPECT_EQ(piece.array<float>("number"), expected.cell_data[0].values);
  }

  std::string
  file_name(const int state, const int group, const int n_groups)
  {
    return "solid-0000" + std::to_string(state) +
           (n_groups > 1 ? "." + std::to_string(group) : "") + ".vtu";
  }
} // namespace

TEST(VtuPieces, EachRankHasAPieceInTheFileOfItsGroup)
{
  const Communicator all(MPI_COMM_WORLD);
  for (const int ranks_per_file : {1, 2, 64})
    {
      const SharedDirectory directory(all);
      SolutionSeries series(directory.path, "solid", all, ranks_per_file);
      series.write(0, piece_of(all.rank(), 1));
      series.write(1.5, piece_of(all.rank(), n_cells_of(all.rank())));
      if (!all.is_root())
        continue;

      const int n_groups = (all.size() + ranks_per_file - 1) / ranks_per_file;
      for (int rank = 0; rank < all.size(); ++rank)
        {
          const int     group = rank / ranks_per_file;
          const VtuFile file(directory / file_name(1, group, n_groups));
          EXPECT_EQ(
            file.n_pieces(),
            std::min(all.size() - group * ranks_per_file, ranks_per_file));
          EXPECT_NE(file.content.find(">1.5</DataArray>"), std::string::npos);
          expect_piece(file.piece(rank % ranks_per_file),
                       piece_of(rank, n_cells_of(rank)));
        }

      std::string list;
      for (const int state : {0, 1})
        for (int group = 0; group < n_groups; ++group)
          list += std::string("<DataSet timestep=\"") +
                  (state == 0 ? "0" : "1.5") + "\" part=\"" +
                  std::to_string(group) + "\" file=\"" +
                  file_name(state, group, n_groups) + "\"/>\n";
      EXPECT_NE(read_file(directory / "solid.pvd").find(">\n" + list + "</"),
                std::string::npos);
    }
}

TEST(VtuPieces, StatesOfAnotherNumberOfRanksAreListed)
{
  const Communicator    all(MPI_COMM_WORLD);
  const SharedDirectory directory(all);
  SolutionSeries        series(directory.path, "solid", all, 64);
  series.go_on_after({{0, 1}, {.5, 2}});
  series.write(1, piece_of(all.rank(), 1));
  ASSERT_EQ(series.states().size(), 3u);
  EXPECT_EQ(series.states()[2].n_files, 1);
  const std::string list = read_file(directory / "solid.pvd");
  for (const char *expected :
       {"\"0\" part=\"0\" file=\"solid-00000.vtu\"/>\n<DataSet",
        "\"0.5\" part=\"0\" file=\"solid-00001.0.vtu\"/>\n<DataSet",
        "\"0.5\" part=\"1\" file=\"solid-00001.1.vtu\"/>\n<DataSet",
        "\"1\" part=\"0\" file=\"solid-00002.vtu\"/>\n</Collection>"})
    EXPECT_NE(list.find(expected), std::string::npos) << expected << list;
}

TEST(VtuPieces, FullDiskOfOneGroupIsAnErrorOnAllRanks)
{
  const Communicator all(MPI_COMM_WORLD);
  for (const int ranks_per_file : {1, 2})
    {
      const SharedDirectory directory(all);
      SolutionSeries series(directory.path, "solid", all, ranks_per_file);
      series.write(0, piece_of(all.rank(), 1));
      const std::string list = read_file(directory / "solid.pvd");

      // The rank that writes the last file has a full disk.
      const int           last_group = (all.size() - 1) / ranks_per_file;
      const FileSizeLimit limit(
        all.rank() == last_group * ranks_per_file ? 500 : RLIM_INFINITY);
      try
        {
          series.write(1, piece_of(all.rank(), 30000));
          FAIL() << "nothing was thrown";
        }
      catch (const Error &error)
        {
          EXPECT_EQ(error.exit_code, ExitCode::disk_error);
          EXPECT_EQ(error.what(),
                    "Cannot write " +
                      (directory / file_name(1, last_group, last_group + 1)) +
                      ".tmp: File too large. Raise the limit on the size of a "
                      "file (ulimit -f), or write to another disk.");
        }
      EXPECT_EQ(read_file(directory / "solid.pvd"), list);
    }
}
