// What check_mesh() must find, and what it must let pass.

#include "../temporary_directory.h"

#include <rift/base/exceptions.h>
#include <rift/mesh/mesh_checks.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace rift;

namespace
{
  MeshData
  mesh_of_two()
  {
    MeshData mesh;
    mesh.source         = "two";
    mesh.vertices       = {{{0, 0, 0}},
                           {{1, 0, 0}},
                           {{0, 1, 0}},
                           {{0, 0, 1}},
                           {{0, 0, -1}}};
    mesh.cells          = {{{0, 1, 2, 3}}, {{0, 2, 1, 4}}};
    mesh.cell_tags      = {11, 12};
    mesh.cell_materials = {0, 0};
    mesh.material_names = {"rock"};
    return mesh;
  }

  std::string
  check(const MeshData &mesh)
  {
    return message_of<InputError>([&]() { check_mesh(mesh); });
  }
} // namespace

TEST(CheckMesh, GoodMeshPasses)
{
  EXPECT_EQ(check(mesh_of_two()), "(nothing was thrown)");
}

TEST(CheckMesh, Regions)
{
  MeshData mesh          = mesh_of_two();
  mesh.cell_materials[1] = 4;
  EXPECT_EQ(check(mesh),
            "two: unnamed region: cell 12 belongs to volume number 4, which "
            "has no name. Name it by a physical volume.");
  mesh.cell_materials[1] = 0;
  mesh.material_names    = {""};
  EXPECT_EQ(check(mesh),
            "two: unnamed region: cell 11 belongs to volume number 0, which "
            "has no name. Name it by a physical volume.");
  mesh.cells.clear();
  EXPECT_EQ(check(mesh),
            "two: there are no cells. Define a volume and mesh it in 3-D.");
}

TEST(CheckMesh, Vertices)
{
  MeshData mesh    = mesh_of_two();
  mesh.cells[1][3] = 5;
  EXPECT_EQ(check(mesh),
            "two: cell 12 uses vertex 5, but there are only 5 vertices. Write "
            "the mesh again.");
  mesh                = mesh_of_two();
  mesh.vertices[4][1] = std::nan("");
  EXPECT_EQ(check(mesh),
            "two: a corner of cell 12 is at (0, nan, -1), which is no point in "
            "space. Write the mesh again.");
  mesh.vertices[4][1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(check(mesh),
            "two: a corner of cell 12 is at (0, inf, -1), which is no point in "
            "space. Write the mesh again.");
  mesh = mesh_of_two();
  mesh.vertices.push_back({{7, 8, 9}});
  EXPECT_EQ(check(mesh),
            "two: orphan vertex 5 at (7, 8, 9): no cell uses it. Remove it.");
}

TEST(CheckMesh, Volumes)
{
  MeshData mesh = mesh_of_two();
  std::swap(mesh.cells[1][0], mesh.cells[1][1]);
  EXPECT_EQ(check(mesh),
            "two: cell 12 at (0.25, 0.25, -0.25) has the volume -0.166667 m3, "
            "with a longest edge of 1.41421 m: it is flat or inside out. Mesh "
            "again with optimisation (Mesh.Optimize = 1) or another element "
            "size.");
  mesh                = mesh_of_two();
  mesh.vertices[4][2] = 0;
  mesh.vertices[4][0] = -1;
  EXPECT_NE(check(mesh).find("cell 12 at (0, 0.25, 0) has the volume 0 m3"),
            std::string::npos);
  // Just below and just above the limit: longest edge 2, volume z / 6.
  mesh.vertices[4][2] = -4.7e-11;
  EXPECT_NE(check(mesh).find("cell 12 at"), std::string::npos);
  mesh.vertices[4][2] = -4.9e-11;
  EXPECT_EQ(check(mesh), "(nothing was thrown)");
}

TEST(CheckMesh, CellTwice)
{
  MeshData mesh = mesh_of_two();
  mesh.cells.push_back({{2, 1, 4, 0}});
  mesh.cell_tags.push_back(13);
  mesh.cell_materials.push_back(0);
  mesh.cells.erase(mesh.cells.begin());
  mesh.cell_tags.erase(mesh.cell_tags.begin());
  mesh.vertices[3] = {{0, 0, -1}};
  mesh.vertices.pop_back();
  mesh.cells = {{{0, 2, 1, 3}}, {{2, 1, 0, 3}}};
  EXPECT_EQ(check(mesh),
            "two: cell 12 at (0.25, 0.25, -0.25) is there twice, again as cell "
            "13. Remove one of them.");
}

TEST(CheckMesh, CellsOnTheSameSideOfTheirFace)
{
  MeshData mesh    = mesh_of_two();
  mesh.vertices[4] = {{0, 0, 2}};
  mesh.cells[1]    = {{0, 1, 2, 4}};
  EXPECT_EQ(check(mesh),
            "two: cell 11 at (0.25, 0.25, 0.25) and cell 12 at (0.25, 0.25, "
            "0.5) lie on the same side of the face that they share, so they "
            "overlap. Mesh again.");
}

TEST(CheckMesh, FaceOfThreeCells)
{
  MeshData mesh = mesh_of_two();
  mesh.vertices.push_back({{0, 0, 2}});
  mesh.cells.push_back({{0, 1, 2, 5}});
  mesh.cell_tags.push_back(13);
  mesh.cell_materials.push_back(0);
  EXPECT_EQ(check(mesh),
            "two: cell 11 at (0.25, 0.25, 0.25), cell 12 at (0.25, 0.25, "
            "-0.25) and cell 13 at (0.25, 0.25, 0.5) share one face, but a "
            "face has only two sides. Mesh again.");
}

TEST(CheckMesh, CoincidentVertices)
{
  MeshData mesh = mesh_of_two();
  mesh.vertices.push_back({{1, 0, 0}});
  mesh.cells[1] = {{0, 2, 5, 4}};
  EXPECT_EQ(check(mesh),
            "two: two vertices are at the same position (1, 0, 0), one of cell "
            "11 and one of cell 12: the body would be torn there. Merge them "
            "in gmsh (Coherence Mesh, or BooleanFragments before meshing), or "
            "leave a gap, such as 1e-6 m, between bodies that touch by contact "
            "alone.");
  // The tolerance is 1e-12 of the diagonal, sqrt(6), in every direction and
  // on both sides of every box that the search may use.
  for (unsigned int d = 0; d < 3; ++d)
    for (int i = -50; i < 50; ++i)
      for (const double distance : {2e-12, 3e-12})
        {
          mesh.vertices[1] = {{1, 0, 0}};
          mesh.vertices[1][d] += 1e-10 * i;
          mesh.vertices[5] = mesh.vertices[1];
          mesh.vertices[5][d] += distance;
          EXPECT_EQ(check(mesh) == "(nothing was thrown)", distance > 2.5e-12);
        }
}
