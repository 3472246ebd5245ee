// Good meshes of all kinds come in complete.

#include "../temporary_directory.h"
#include "msh_text.h"

#include <rift/mesh/child_process.h>
#include <rift/mesh/gmsh_reader.h>
#include <rift/mesh/gmsh_session.h>
#include <rift/mesh/mesh_checks.h>

#include <gmsh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace rift;

namespace
{
  MeshParameters
  from_file(const std::string &file)
  {
    MeshParameters parameters;
    parameters.file = file;
    return parameters;
  }

  double
  cell_volume(const MeshData &mesh, const std::size_t c)
  {
    const auto edge = [&](const unsigned int i) {
      return mesh.vertices[mesh.cells[c][i]] - mesh.vertices[mesh.cells[c][0]];
    };
    return dot(edge(1), cross(edge(2), edge(3))) / 6;
  }

  double
  volume(const MeshData &mesh)
  {
    double sum = 0;
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      sum += cell_volume(mesh, c);
    return sum;
  }

  // The sum of the outward area vectors' lengths, and the vectors' sum.
  double
  area(const MeshData               &mesh,
       const std::vector<NamedFace> &faces,
       const std::string            &name,
       Vector3<double>              *sum = nullptr)
  {
    double result = 0;
    for (const NamedFace &face : faces)
      if (mesh.surface_names[face.name] == name)
        {
          const auto corner = [&](const unsigned int i) {
            return mesh.vertices[mesh.cells[face.cell]
                                           [face_corners[face.local_face][i]]];
          };
          const auto normal =
            0.5 * cross(corner(1) - corner(0), corner(2) - corner(0));
          result += norm(normal);
          if (sum != nullptr)
            *sum += normal;
        }
    return result;
  }

  void
  expect_equal(const MeshData &a, const MeshData &b, const double tolerance)
  {
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (std::size_t v = 0; v < a.vertices.size(); ++v)
      ASSERT_LE(norm(a.vertices[v] - b.vertices[v]), tolerance);
    EXPECT_EQ(a.cells, b.cells);
    EXPECT_EQ(a.cell_tags, b.cell_tags);
    EXPECT_EQ(a.cell_materials, b.cell_materials);
    EXPECT_EQ(a.material_names, b.material_names);
    EXPECT_EQ(a.surface_names, b.surface_names);
    const auto list = [](const std::vector<NamedFace> &faces) {
      std::vector<std::array<unsigned int, 3>> result;
      for (const auto &face : faces)
        result.push_back({{face.cell, face.local_face, face.name}});
      return result;
    };
    EXPECT_EQ(list(a.boundary_faces), list(b.boundary_faces));
    EXPECT_EQ(list(a.internal_faces), list(b.internal_faces));
  }

  // Two blocks of different material with a joint between them, of which
  // only half is named; and the centre of an arc, which no cell uses.
  const char *two_blocks = R"(
    SetFactory("OpenCASCADE");
    DefineConstant[ element_size = 0.4 ];
    Box(1) = {0, 0, 0, 1, 1, 1};
    Box(2) = {1, 0, 0, 1, 1, 1};
    Rectangle(100) = {0, 0, 0, 1, 0.5};
    Rotate {{0, 1, 0}, {0, 0, 0}, -Pi/2} { Surface{100}; }
    Translate {1, 0, 0} { Surface{100}; }
    BooleanFragments{ Volume{1, 2}; Surface{100}; Delete; }{}
    eps = 1e-3;
    Point(1000) = {5, 5, 5, 0.1};
    left() = Surface In BoundingBox{-eps, -eps, -eps, eps, 1 + eps, 1 + eps};
    joint() = Surface In BoundingBox{1 - eps, -eps, -eps,
                                     1 + eps, 0.5 + eps, 1 + eps};
    Physical Volume("hard", 20) = {2};
    Physical Volume("soft", 10) = {1};
    Physical Surface("left", 7) = left();
    Physical Surface("joint", 5) = joint();
    Mesh.MeshSizeMin = element_size;
    Mesh.MeshSizeMax = element_size;
  )";

  // Writes the mesh of `two_blocks` in all flavours of MSH.
  void
  write_flavours(const TemporaryDirectory &directory)
  {
    write_file(directory / "blocks.geo", std::string(two_blocks) + "Mesh 3;\n");
    run_in_child_process([&]() {
      const GmshSession session;
      gmsh::open(directory / "blocks.geo");
      for (const double version : {2.2, 4.1})
        for (const bool binary : {false, true})
          {
            gmsh::option::setNumber("Mesh.MshFileVersion", version);
            gmsh::option::setNumber("Mesh.Binary", binary);
            gmsh::write(directory / (std::string(version < 3 ? "2.2" : "4.1") +
                                     (binary ? "-binary" : "-ascii") + ".msh"));
          }
      return std::string();
    });
  }
} // namespace

TEST(GmshReader, AllFlavoursGiveTheSameMesh)
{
  const TemporaryDirectory directory;
  write_flavours(directory);
  const MeshData geo = read_mesh(from_file(directory / "blocks.geo"));
  EXPECT_GT(geo.cells.size(), 100u);
  for (const std::string name :
       {"2.2-ascii", "2.2-binary", "4.1-ascii", "4.1-binary"})
    {
      SCOPED_TRACE(name);
      const MeshData mesh = read_mesh(from_file(directory / (name + ".msh")));
      check_mesh(mesh);
      // 16 digits are written in ASCII.
      expect_equal(mesh, geo, name.find("ascii") != name.npos ? 1e-14 : 0);
      EXPECT_EQ(mesh.source, directory / (name + ".msh"));
    }
}

TEST(GmshReader, NamesFollowPhysicalTagsAndInternalSurfacesAreKept)
{
  const TemporaryDirectory directory;
  write_file(directory / "blocks.geo", two_blocks);
  const MeshData mesh = read_mesh(from_file(directory / "blocks.geo"));

  EXPECT_EQ(mesh.material_names, (std::vector<std::string>{"soft", "hard"}));
  EXPECT_EQ(mesh.surface_names, (std::vector<std::string>{"joint", "left"}));
  double volumes[2] = {0, 0};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    {
      volumes[mesh.cell_materials[c]] += cell_volume(mesh, c);
      const double x = mesh.vertices[mesh.cells[c][0]][0];
      EXPECT_TRUE(mesh.cell_materials[c] == 0 ? x <= 1 + 1e-9 : x >= 1 - 1e-9);
    }
  EXPECT_NEAR(volumes[0], 1, 1e-12);
  EXPECT_NEAR(volumes[1], 1, 1e-12);

  EXPECT_NEAR(area(mesh, mesh.internal_faces, "joint"), 0.5, 1e-12);
  EXPECT_EQ(area(mesh, mesh.internal_faces, "left"), 0);
  EXPECT_EQ(area(mesh, mesh.boundary_faces, "joint"), 0);
  Vector3<double> normal = {{0, 0, 0}};
  EXPECT_NEAR(area(mesh, mesh.boundary_faces, "left", &normal), 1, 1e-12);
  EXPECT_NEAR(normal[0], -1, 1e-12);
}

TEST(GmshReader, NamesHaveTheBlanksOfAScene)
{
  const TemporaryDirectory directory;
  MshText                  text = two_tetrahedra();
  text.names                    = {"3 1 \" coarse   granite  \"",
                                   "2 4 \"  upper\tend \"",
                                   "2 5 \"upper\""};
  text.elements.push_back("2 2 4 4 1 2 4");
  text.elements.push_back("2 2 5 5 1 3 4");
  write_file(directory / "a.msh", text.str());
  const MeshData mesh = read_mesh(from_file(directory / "a.msh"));
  EXPECT_EQ(mesh.material_names, (std::vector<std::string>{"coarse granite"}));
  EXPECT_EQ(mesh.surface_names,
            (std::vector<std::string>{"upper end", "upper"}));
}

TEST(GmshReader, NumbersReachTheScript)
{
  const TemporaryDirectory directory;
  write_file(directory / "box.geo", R"(
    SetFactory("OpenCASCADE");
    DefineConstant[ element_size = 0.5, height = {1, Name "Height"} ];
    DefineConstant[ depth = 1, start = 0 ];
    If (!Exists(width))
      width = 1; // not width = 17
    EndIf
    Box(1) = {start, 0, 0, width, depth, height};
    Physical Volume("rock") = {1};
    Mesh.MeshSizeMin = element_size;
    Mesh.MeshSizeMax = element_size;
  )");
  MeshParameters parameters = from_file(directory / "box.geo");
  const MeshData coarse     = read_mesh(parameters);
  EXPECT_NEAR(volume(coarse), 1, 1e-12);

  parameters.geo_parameters = {{"width", 2.125},
                               {"depth", 1 / 3.},
                               {"height", 3e-1},
                               {"start", -4}};
  parameters.element_size   = 0.1;
  const MeshData fine       = read_mesh(parameters);
  EXPECT_NEAR(volume(fine), 2.125 / 3 * 0.3, 1e-12);
  EXPECT_NEAR(
    (*std::min_element(fine.vertices.begin(), fine.vertices.end()))[0],
    -4,
    1e-12);
  EXPECT_GT(fine.cells.size(), 400u);
  EXPECT_LT(fine.cells.size(), 4000u);

  // Nothing of it is left for the next mesh.
  parameters.geo_parameters = {{"depth", 2}};
  parameters.element_size   = 0;
  EXPECT_NEAR(volume(read_mesh(parameters)), 2, 1e-12);
}

TEST(GmshReader, ScriptThatMeshesItselfIsNotMeshedAgain)
{
  const TemporaryDirectory directory;
  write_file(directory / "box.geo", R"(
    SetFactory("OpenCASCADE");
    Box(1) = {0, 0, 0, 1, 1, 1};
    Physical Volume("rock") = {1};
    Mesh.MeshSizeMax = 0.2;
    Mesh 3;
    Mesh.MeshSizeMax = 1;
  )");
  EXPECT_GT(read_mesh(from_file(directory / "box.geo")).cells.size(), 400u);
}

TEST(GmshReader, BuiltInBox)
{
  MeshParameters parameters;
  parameters.shape        = MeshParameters::Shape::box;
  parameters.box_size     = {{0.03, 0.02, 0.01}};
  parameters.element_size = 2.5e-3;
  parameters.material     = "basalt";
  const MeshData mesh     = read_mesh(parameters);
  check_mesh(mesh);

  EXPECT_EQ(mesh.source, "built-in box");
  EXPECT_EQ(mesh.material_names, std::vector<std::string>{"basalt"});
  EXPECT_NEAR(volume(mesh), 6e-6, 1e-17);
  EXPECT_EQ(mesh.surface_names,
            (std::vector<std::string>{"x_min",
                                      "x_max",
                                      "y_min",
                                      "y_max",
                                      "z_min",
                                      "z_max"}));
  const double areas[] = {2e-4, 2e-4, 3e-4, 3e-4, 6e-4, 6e-4};
  for (unsigned int i = 0; i < 6; ++i)
    {
      Vector3<double> normal = {{0, 0, 0}};
      area(mesh, mesh.boundary_faces, mesh.surface_names[i], &normal);
      EXPECT_NEAR(normal[i / 2], (i % 2 == 0 ? -1 : 1) * areas[i], 1e-15);
      EXPECT_NEAR(norm(normal), areas[i], 1e-15);
    }
}

TEST(GmshReader, BuiltInCylinder)
{
  const double   radius = 0.019, length = 0.06, size = 4e-3;
  MeshParameters parameters;
  parameters.shape           = MeshParameters::Shape::cylinder;
  parameters.cylinder_radius = radius;
  parameters.cylinder_length = length;
  parameters.element_size    = size;
  const MeshData mesh        = read_mesh(parameters);
  check_mesh(mesh);

  EXPECT_EQ(mesh.surface_names,
            (std::vector<std::string>{"start", "end", "side"}));
  // The circle is a regular polygon of about 2 pi r / h corners.
  const double n      = std::round(2 * M_PI * radius / size);
  const double circle = n / 2 * radius * radius * std::sin(2 * M_PI / n);
  EXPECT_NEAR(area(mesh, mesh.boundary_faces, "start"), circle, 0.002 * circle);
  EXPECT_NEAR(area(mesh, mesh.boundary_faces, "end"), circle, 0.002 * circle);
  EXPECT_NEAR(volume(mesh), circle * length, 0.005 * circle * length);
  EXPECT_LT(volume(mesh), M_PI * radius * radius * length);
  const double side = 2 * M_PI * radius * length;
  EXPECT_NEAR(area(mesh, mesh.boundary_faces, "side"), side, 0.01 * side);

  Vector3<double> normal = {{0, 0, 0}};
  for (const auto &name : mesh.surface_names)
    area(mesh, mesh.boundary_faces, name, &normal);
  EXPECT_NEAR(norm(normal), 0, 1e-15);
  for (const auto &face : mesh.boundary_faces)
    {
      const auto &x =
        mesh.vertices[mesh.cells[face.cell][face_corners[face.local_face][0]]];
      if (mesh.surface_names[face.name] == "side")
        EXPECT_NEAR(std::hypot(x[1], x[2]), radius, 1e-12);
      else
        EXPECT_NEAR(x[0],
                    mesh.surface_names[face.name] == "end" ? length : 0,
                    1e-12);
    }
}

TEST(GmshReader, SameRequestSameMesh)
{
  MeshParameters parameters;
  parameters.shape           = MeshParameters::Shape::cylinder;
  parameters.cylinder_radius = 0.019;
  parameters.cylinder_length = 0.04;
  parameters.element_size    = 4e-3;
  const MeshData first       = read_mesh(parameters);
  expect_equal(read_mesh(parameters), first, 0);
}

TEST(GmshReader, CellsAreLargeForTheirEdges)
{
  // The smallest altitude limits the time step.
  MeshParameters parameters;
  parameters.shape           = MeshParameters::Shape::cylinder;
  parameters.cylinder_radius = 0.019;
  parameters.cylinder_length = 0.06;
  parameters.element_size    = 2.5e-3;
  const MeshData mesh        = read_mesh(parameters);
  double         smallest    = 1;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const auto &face : face_corners)
      {
        const auto corner = [&](const unsigned int i) {
          return mesh.vertices[mesh.cells[c][face[i]]];
        };
        const double twice_area =
          norm(cross(corner(1) - corner(0), corner(2) - corner(0)));
        smallest = std::min(smallest, 6 * cell_volume(mesh, c) / twice_area);
      }
  EXPECT_GT(smallest, 0.3 * parameters.element_size);
}

TEST(GmshReader, SpallingCylinder)
{
  MeshParameters parameters =
    from_file(RIFT_SOURCE_DIRECTORY "/prm/spalling/cylinder.geo");
  parameters.element_size             = 8e-3;
  parameters.geo_parameters["length"] = 0.1;
  const MeshData mesh                 = read_mesh(parameters);
  check_mesh(mesh);
  EXPECT_EQ(mesh.material_names, std::vector<std::string>{"granite"});
  const double    circle = M_PI * 0.019 * 0.019;
  Vector3<double> loaded = {{0, 0, 0}}, free_end = loaded, side = loaded;
  area(mesh, mesh.boundary_faces, "loaded", &loaded);
  area(mesh, mesh.boundary_faces, "free_end", &free_end);
  EXPECT_NEAR(loaded[0], -circle, 0.05 * circle);
  EXPECT_NEAR(free_end[0], circle, 0.05 * circle);
  EXPECT_NEAR(area(mesh, mesh.boundary_faces, "side", &side),
              2 * M_PI * 0.019 * 0.1,
              0.02 * 2 * M_PI * 0.019 * 0.1);
  EXPECT_NEAR(norm(loaded + free_end + side), 0, 1e-15);
}

TEST(GmshReader, CellsComeOutWithPositiveVolume)
{
  const TemporaryDirectory directory;
  MshText                  text = two_tetrahedra();
  text.elements                 = {"4 2 1 1 1 2 3 4", "4 2 1 1 1 2 3 5"};
  write_file(directory / "a.msh", text.str());
  const MeshData mesh = read_mesh(from_file(directory / "a.msh"));
  check_mesh(mesh);
  EXPECT_DOUBLE_EQ(cell_volume(mesh, 0), 1. / 6);
  EXPECT_DOUBLE_EQ(cell_volume(mesh, 1), 1. / 6);
}

TEST(GmshReader, NodesOfNoElementAreLeftOut)
{
  const TemporaryDirectory directory;
  MshText                  text = two_tetrahedra();
  // First in the file, so that others are shifted, and as a point.
  text.nodes    = {"9 9 9", "8 8 8", "0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  text.elements = {"15 2 0 1 2", "4 2 1 1 3 4 5 6"};
  write_file(directory / "a.msh", text.str());
  const MeshData mesh = read_mesh(from_file(directory / "a.msh"));
  check_mesh(mesh);
  ASSERT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.cell_tags, std::vector<std::size_t>{2});
  EXPECT_EQ(mesh.vertices[1], (Vector3<double>{{1, 0, 0}}));
  EXPECT_DOUBLE_EQ(volume(mesh), 1. / 6);
}

TEST(GmshReader, SparseTagsAreMapped)
{
  const TemporaryDirectory directory;
  std::string              text = MshText().str();
  text = text.substr(0, text.find("$Nodes")) + "$Nodes\n4\n" +
         "1000000000 0 0 1\n70 0 0 0\n900 0 1 0\n80 1 0 0\n$EndNodes\n" +
         "$Elements\n1\n5000000 4 2 1 1 70 80 900 1000000000\n$EndElements\n";
  write_file(directory / "a.msh", text);
  const MeshData mesh = read_mesh(from_file(directory / "a.msh"));
  check_mesh(mesh);
  EXPECT_EQ(mesh.cell_tags, std::vector<std::size_t>{5000000});
  EXPECT_EQ(mesh.vertices[3], (Vector3<double>{{0, 0, 1}}));
  EXPECT_DOUBLE_EQ(volume(mesh), 1. / 6);
}
