#include <rift/base/exceptions.h>
#include <rift/io/vtu_output.h>

#include "../file_size_limit.h"
#include "../support/vtu_file.h"
#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace rift;
using namespace rift::test;

namespace
{
  /** Two tetrahedra that share a face. */
  Solution
  two_tetrahedra()
  {
    Solution solution;
    solution.points = {{{0, 0, 0}},
                       {{1, 0, 0}},
                       {{0, 1, 0}},
                       {{0, 0, 1}},
                       {{123456.000001, 1, 1}}};
    solution.cells  = {0, 1, 2, 3, 1, 2, 3, 4};
    OutputField velocity{"velocity [m/s]", 3, {}};
    for (unsigned int i = 0; i < 15; ++i)
      velocity.values.push_back(0.5f * i);
    solution.point_data = {velocity, {"a <\"&> b", 1, {1, 2, 3, 4, 5}}};
    solution.cell_data  = {
       {"stress [Pa]", 6, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
       {"axes [m]", 3, {1, 2, 3, 4, 5, 6}, {"long", "middle", "short"}}};
    return solution;
  }
} // namespace

TEST(VtuOutput, TetrahedraReadBack)
{
  const TemporaryDirectory directory;
  const Solution           solution = two_tetrahedra();
  write_vtu(directory / "s.vtu", 1.5e-6, solution);
  const VtuFile file(directory / "s.vtu");

  const std::string piece = file.element("<Piece");
  EXPECT_EQ(attribute(piece, "NumberOfPoints"), "5");
  EXPECT_EQ(attribute(piece, "NumberOfCells"), "2");
  EXPECT_NE(file.content.find(">1.5e-06</DataArray>"), std::string::npos);

  EXPECT_EQ(attribute(file.array_element("Points"), "type"), "Float64");
  const auto points = file.array<double>("Points");
  ASSERT_EQ(points.size(), 15u);
  EXPECT_EQ(points[12], 123456.000001);
  for (unsigned int i = 0; i < 15; ++i)
    EXPECT_EQ(points[i], solution.points[i / 3][i % 3]);

  EXPECT_EQ(file.array<std::uint32_t>("connectivity"), solution.cells);
  EXPECT_EQ(file.array<std::int32_t>("offsets"),
            (std::vector<std::int32_t>{4, 8}));
  EXPECT_EQ(file.array<std::uint8_t>("types"),
            (std::vector<std::uint8_t>{10, 10}));
}

TEST(VtuOutput, FieldsReadBack)
{
  const TemporaryDirectory directory;
  const Solution           solution = two_tetrahedra();
  write_vtu(directory / "s.vtu", 0, solution);
  const VtuFile file(directory / "s.vtu");

  EXPECT_EQ(file.array<float>("velocity [m/s]"), solution.point_data[0].values);
  EXPECT_EQ(
    attribute(file.array_element("velocity [m/s]"), "NumberOfComponents"),
    "3");
  EXPECT_EQ(attribute(file.array_element("velocity [m/s]"), "ComponentName0"),
            "(none)");
  EXPECT_EQ(file.array<float>("a &lt;&quot;&amp;&gt; b"),
            solution.point_data[1].values);

  // From xx yy zz yz xz xy to xx yy zz xy yz xz.
  EXPECT_EQ(file.array<float>("stress [Pa]"),
            (std::vector<float>{1, 2, 3, 6, 4, 5, 7, 8, 9, 12, 10, 11}));
  const std::string stress = file.array_element("stress [Pa]");
  EXPECT_EQ(attribute(stress, "NumberOfComponents"), "6");
  EXPECT_EQ(attribute(stress, "ComponentName3"), "XY");

  const std::string axes = file.array_element("axes [m]");
  EXPECT_EQ(attribute(axes, "ComponentName0"), "long");
  EXPECT_EQ(attribute(axes, "ComponentName2"), "short");

  const auto point_data = file.content.find("<PointData>");
  const auto cell_data  = file.content.find("<CellData>");
  EXPECT_LT(point_data, file.content.find("velocity"));
  EXPECT_LT(file.content.find("velocity"), cell_data);
  EXPECT_LT(cell_data, file.content.find("stress"));
}

TEST(VtuOutput, ManyBlocks)
{
  const TemporaryDirectory directory;
  Solution                 solution;
  solution.nodes_per_cell = 3;
  // 65536 cells: the connectivity is three full blocks, no partial one.
  const unsigned int n_cells = 65536;
  OutputField        damage{"damage", 1, {}};
  for (unsigned int i = 0; i < n_cells; ++i)
    {
      solution.points.push_back({{0.1 * i, 1. / (i + 1), 0}});
      for (unsigned int a = 0; a < 3; ++a)
        solution.cells.push_back((7919u * i + a) % n_cells);
      damage.values.push_back(std::sin(i));
    }
  solution.cell_data = {damage};
  write_vtu(directory / "f.vtu", 0, solution);

  const VtuFile file(directory / "f.vtu");
  EXPECT_EQ(file.array<std::uint32_t>("connectivity"), solution.cells);
  EXPECT_EQ(file.array<float>("damage"), damage.values);
  EXPECT_EQ(file.array<std::uint8_t>("types"),
            std::vector<std::uint8_t>(n_cells, 5));
  const auto points = file.array<double>("Points");
  ASSERT_EQ(points.size(), 3 * n_cells);
  EXPECT_EQ(points[3 * 1234 + 1], 1. / 1235);
}

TEST(VtuOutput, NothingBrokenYet)
{
  const TemporaryDirectory directory;
  Solution                 solution;
  solution.nodes_per_cell = 3;
  solution.cell_data      = {{"damage", 1, {}}};
  write_vtu(directory / "f.vtu", 0, solution);
  const VtuFile file(directory / "f.vtu");
  EXPECT_EQ(attribute(file.element("<Piece"), "NumberOfCells"), "0");
  EXPECT_TRUE(file.array<float>("damage").empty());
}

TEST(VtuOutput, TwoRunsGiveTheSameFile)
{
  const TemporaryDirectory directory;
  write_vtu(directory / "1.vtu", 0, two_tetrahedra());
  write_vtu(directory / "2.vtu", 0, two_tetrahedra());
  EXPECT_EQ(read_file(directory / "1.vtu"), read_file(directory / "2.vtu"));
}

TEST(VtuOutput, WrongSizes)
{
  const auto message = [](const Solution &solution) {
    return message_of<std::logic_error>(
      [&] { write_vtu("/dev/null", 0, solution); });
  };
  Solution solution = two_tetrahedra();
  solution.point_data[0].values.pop_back();
  EXPECT_EQ(message(solution),
            "write_vtu: field velocity [m/s] has 14 values instead of 15");
  solution                           = two_tetrahedra();
  solution.cell_data[0].n_components = 2;
  EXPECT_EQ(message(solution),
            "write_vtu: field stress [Pa] has 2 components instead of 1, 3 or "
            "6");
  solution          = two_tetrahedra();
  solution.cells[7] = 5;
  EXPECT_EQ(message(solution),
            "write_vtu: a cell has a node that does not exist");
  solution.cells.pop_back();
  EXPECT_EQ(message(solution), "write_vtu: the last cell is incomplete");
  solution.nodes_per_cell = 8;
  EXPECT_EQ(message(solution),
            "write_vtu: cells have 8 nodes instead of 3 or 4");
}

TEST(SolutionSeries, ListsAllStates)
{
  const TemporaryDirectory directory;
  SolutionSeries           series(directory.path, "solid");
  series.write(0, two_tetrahedra());
  const std::string start = "<?xml version=\"1.0\"?>\n"
                            "<VTKFile type=\"Collection\" version=\"1.0\">\n"
                            "<Collection>\n";
  const std::string first =
    "<DataSet timestep=\"0\" part=\"0\" file=\"solid-00000.vtu\"/>\n";
  const std::string end = "</Collection>\n</VTKFile>\n";
  EXPECT_EQ(read_file(directory / "solid.pvd"), start + first + end);

  Solution moved  = two_tetrahedra();
  moved.points[0] = {{-1, 0, 0}};
  series.write(2e-5, moved);
  EXPECT_EQ(read_file(directory / "solid.pvd"),
            start + first +
              "<DataSet timestep=\"2e-05\" part=\"0\" "
              "file=\"solid-00001.vtu\"/>\n" +
              end);
  EXPECT_EQ(VtuFile(directory / "solid-00000.vtu").array<double>("Points")[0],
            0);
  EXPECT_EQ(VtuFile(directory / "solid-00001.vtu").array<double>("Points")[0],
            -1);
}

TEST(SolutionSeries, DirectoryIsGone)
{
  EXPECT_EQ(message_of<DiskError>([] {
              SolutionSeries("/proc/rift", "solid").write(0, {});
            }).substr(0, 50),
            "Cannot create /proc/rift/solid-00000.vtu.tmp: No s");
}

TEST(SolutionSeries, FullDiskKeepsWhatThereWas)
{
  const TemporaryDirectory directory;
  SolutionSeries           series(directory.path, "solid");
  series.write(0, two_tetrahedra());
  const std::string list = read_file(directory / "solid.pvd");
  {
    const FileSizeLimit limit(500);
    EXPECT_EQ(message_of<DiskError>([&] { series.write(1, two_tetrahedra()); }),
              "Cannot write " + (directory / "solid-00001.vtu.tmp") +
                ": File too large. Raise the limit on the size of a file "
                "(ulimit -f), or write to another disk.");
  }
  EXPECT_EQ(read_file(directory / "solid.pvd"), list);
  EXPECT_FALSE(std::filesystem::exists(directory / "solid-00001.vtu"));
  EXPECT_FALSE(std::filesystem::exists(directory / "solid-00001.vtu.tmp"));
}
