// What is wrong with a mesh is said, and said exactly.

#include "bad_mesh.h"

#include <rift/mesh/child_process.h>
#include <rift/mesh/gmsh_session.h>

#include <gmsh.h>

#include <random>

using namespace rift;

// Files

TEST_F(BadMesh, GoodOnesPass)
{
  EXPECT_EQ(message(two_tetrahedra()), "(nothing was thrown)");
}

TEST_F(BadMesh, FileMissingOrOfAnotherKind)
{
  parameters.file = directory / "missing.msh";
  EXPECT_THROW(read_mesh(parameters), InputError);
  parameters.file = directory / "missing.geo";
  EXPECT_THROW(read_mesh(parameters), InputError);
  write_file(directory / "a.stl", "solid");
  parameters.file = directory / "a.stl";
  EXPECT_THROW(read_mesh(parameters), InputError);
  parameters.file.clear();
  EXPECT_THROW(read_mesh(parameters), InputError);

  EXPECT_EQ(message(""), "The mesh file 'a.msh' is empty or cannot be read.");
  const std::string no_msh = "The file 'a.msh' does not begin with "
                             "$MeshFormat, so it is no MSH file. Write the "
                             "mesh with gmsh, format MSH 4.1.";
  EXPECT_EQ(message("$NoMeshFormat\n"), no_msh);
  EXPECT_EQ(message("solid box\nendsolid\n"), no_msh);
  EXPECT_EQ(message(std::string("\0\1\2\377$$\n", 7)), no_msh);
  EXPECT_EQ(message("$MeshFormat\n1.0 0 8\n$EndMeshFormat\n"),
            "The mesh file 'a.msh' is of MSH version 1.0, but only 2.2 and "
            "4.1 can be read. Convert it: gmsh a.msh -save -format msh41 -o "
            "new.msh");
}

TEST_F(BadMesh, FileCutOff)
{
  const std::string text = two_tetrahedra().str();
  EXPECT_EQ(message(text.substr(0, text.find("$Nodes"))),
            "The mesh file 'a.msh' has no section $Nodes. It is cut off or "
            "damaged: write it again.");
  EXPECT_EQ(message(text.substr(0, text.find("$EndElements"))),
            "The mesh file 'a.msh' has no $EndElements. It is cut off or "
            "damaged: write it again.");
}

TEST_F(BadMesh, FileWithFewerNodesThanItSays)
{
  std::string text = two_tetrahedra().str();
  text.replace(text.find("$Nodes\n5"), 8, "$Nodes\n9");
  EXPECT_EQ(message(text).substr(0, 17), "a.msh: gmsh says:");
}

TEST_F(BadMesh, SizeForMeshThatIsThereAlready)
{
  const std::string expected =
    "The mesh file 'a.msh' is used as it is: 'Element size' and parameters "
    "by name have no effect on a .msh. Remove them, or use a .geo.";
  parameters.element_size = 1;
  EXPECT_EQ(message(two_tetrahedra()), expected);
  parameters.element_size   = 0;
  parameters.geo_parameters = {{"radius", 1}};
  EXPECT_EQ(message(two_tetrahedra()), expected);
}

// Elements

TEST_F(BadMesh, ElementsOfSecondOrder)
{
  MshText text  = two_tetrahedra();
  text.nodes    = {"0 0 0",
                   "1 0 0",
                   "0 1 0",
                   "0 0 1",
                   ".5 0 0",
                   ".5 .5 0",
                   "0 .5 0",
                   "0 0 .5",
                   "0 .5 .5",
                   ".5 0 .5"};
  text.elements = {"11 2 1 1 1 2 3 4 5 6 7 8 9 10"};
  EXPECT_EQ(message(text),
            "a.msh: element 1 of volume 1 is of type 'Tetrahedron 10' (order "
            "2, 10 nodes), but rift computes with 4-node tetrahedra of first "
            "order. Set Mesh.ElementOrder = 1.");
}

TEST_F(BadMesh, Hexahedra)
{
  MshText text = two_tetrahedra();
  text.nodes =
    {"0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 0 1", "1 0 1", "1 1 1", "0 1 1"};
  text.elements = {"5 2 1 1 1 2 3 4 5 6 7 8"};
  EXPECT_EQ(message(text),
            "a.msh: element 1 of volume 1 is of type 'Hexahedron 8' (order 1, "
            "8 nodes), but rift computes with 4-node tetrahedra of first "
            "order. Remove Recombine, Layers and the like from the mesh.");
}

TEST_F(BadMesh, QuadranglesOnNamedSurface)
{
  MshText text = two_tetrahedra();
  text.names.push_back("2 4 \"left\"");
  text.elements.push_back("3 2 4 9 1 2 3 4");
  EXPECT_EQ(message(text),
            "a.msh: element 3 of surface 9 is of type 'Quadrilateral 4' (order "
            "1, 4 nodes), but rift computes with 3-node triangles of first "
            "order. Remove Recombine, Layers and the like from the mesh.");
}

TEST_F(BadMesh, NoCells)
{
  MshText text  = two_tetrahedra();
  text.elements = {"2 2 1 1 1 2 3"};
  EXPECT_EQ(message(text),
            "a.msh: there are no cells. Define a volume, and write the 3-D "
            "mesh, not the 2-D one.");
}

TEST_F(BadMesh, UnknownNode)
{
  MshText text     = two_tetrahedra();
  text.elements[1] = "4 2 1 1 1 2 3 77";
  EXPECT_EQ(message(text).substr(0, 17), "a.msh: gmsh says:");
  EXPECT_NE(message(text).find("77"), std::string::npos);
}

TEST_F(BadMesh, VolumesWithoutName)
{
  MshText text  = two_tetrahedra();
  text.elements = {"4 2 0 6 1 2 3 4"};
  EXPECT_EQ(message(text),
            "a.msh: unnamed region: volume 6 (cell 1) belongs to no physical "
            "volume, so it has no material. Give it one in gmsh: Physical "
            "Volume(\"name\") = {6};");
  text       = two_tetrahedra();
  text.names = {};
  EXPECT_EQ(message(text),
            "a.msh: unnamed region: physical volume 1 has no name of its own. "
            "Give it one in gmsh: Physical Volume(\"name\", 1) = ...;");
}

TEST_F(BadMesh, SurfaceWithoutName)
{
  MshText text = two_tetrahedra();
  text.elements.push_back("2 2 4 1 1 2 4");
  EXPECT_EQ(message(text),
            "a.msh: unnamed region: physical surface 4 has no name of its own. "
            "Give it one in gmsh: Physical Surface(\"name\", 4) = ...;");
}

TEST_F(BadMesh, NamesUsedTwice)
{
  MshText text = two_tetrahedra();
  text.names.push_back("3 2 \"rock\"");
  text.elements[1] = "4 2 2 2 1 3 2 5";
  EXPECT_EQ(message(text),
            "a.msh: unnamed region: physical volume 2 has no name of its own. "
            "Give it one in gmsh: Physical Volume(\"name\", 2) = ...;");
}

TEST_F(BadMesh, NamesThatDifferByBlanksAlone)
{
  MshText text  = two_tetrahedra();
  text.names    = {"3 1 \"hard  rock\"", "3 2 \" hard rock \""};
  text.elements = {"4 2 1 1 1 2 3 4", "4 2 2 2 1 3 2 5"};
  EXPECT_EQ(message(text),
            "a.msh: the physical volumes 1 and 2 have the same name 'hard "
            "rock'; blanks at its ends and doubled ones do not count. Rename "
            "one of them, or make one group of both.");
  text.names    = {"3 1 \"rock\"", "2 4 \"end\"", "2 7 \"end \""};
  text.elements = {"4 2 1 1 1 2 3 4", "2 2 4 4 1 2 4", "2 2 7 7 1 3 4"};
  text.nodes.pop_back();
  EXPECT_EQ(message(text),
            "a.msh: the physical surfaces 4 and 7 have the same name 'end'; "
            "blanks at its ends and doubled ones do not count. Rename one of "
            "them, or make one group of both.");
}

TEST_F(BadMesh, NameOfBlanksAlone)
{
  MshText text = two_tetrahedra();
  text.names   = {"3 1 \"  \""};
  EXPECT_EQ(message(text),
            "a.msh: unnamed region: physical volume 1 has no name of its own. "
            "Give it one in gmsh: Physical Volume(\"name\", 1) = ...;");
}

TEST_F(BadMesh, VolumeOfTwoMaterials)
{
  EXPECT_EQ(message("SetFactory(\"OpenCASCADE\");\n"
                    "Box(1) = {0, 0, 0, 1, 1, 1};\n"
                    "Physical Volume(\"a\", 3) = {1};\n"
                    "Physical Volume(\"b\", 4) = {1};\n",
                    "a.geo"),
            "a.geo: volume 1 belongs to the physical groups 3 and 4, but only "
            "one name can be given. Remove it from the others.");
}

TEST_F(BadMesh, FaceOfTwoNames)
{
  MshText text = two_tetrahedra();
  text.names.push_back("2 4 \"left\"");
  text.names.push_back("2 5 \"right\"");
  text.elements.push_back("2 2 4 4 1 2 4");
  text.elements.push_back("2 2 5 5 4 2 1");
  EXPECT_EQ(message(text),
            "a.msh: face 2 of cell 1 belongs to the surfaces 'left' and "
            "'right', but only one name can be given.");
}

TEST_F(BadMesh, TriangleOffTheMesh)
{
  MshText text = two_tetrahedra();
  text.names.push_back("2 4 \"left\"");
  text.elements.push_back("2 2 4 1 1 4 5");
  EXPECT_EQ(message(text),
            "a.msh: triangle 3 of the surface 'left' (nodes 1, 4, 5) is no "
            "face of any cell. Make the surface part of the volumes "
            "(BooleanFragments, Coherence or Surface{...} In Volume{...}) or "
            "take its name away.");
  // The same with a node that no cell has.
  text.nodes.push_back("7 7 7");
  text.elements.back() = "2 2 4 1 1 2 6";
  EXPECT_NE(message(text).find("(nodes 1, 2, 6) is no face"),
            std::string::npos);
}

TEST_F(BadMesh, OrphanInVolume)
{
  MshText     text = two_tetrahedra();
  std::string msh4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                     "$PhysicalNames\n1\n3 1 \"rock\"\n$EndPhysicalNames\n"
                     "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 1 0\n$EndEntities\n"
                     "$Nodes\n1 5 1 5\n3 1 0 5\n1\n2\n3\n4\n5\n"
                     "0 0 0\n1 0 0\n0 1 0\n0 0 1\n.25 .5 3\n$EndNodes\n"
                     "$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";
  EXPECT_EQ(message(msh4),
            "a.msh: orphan node 5 at (0.25, 0.5, 3) lies in a volume, but no "
            "cell uses it. Remove it, or mesh again.");

  // gmsh's mesher leaves such nodes behind.
  write_file(directory / "orphan.msh", msh4);
  write_file(directory / "a.geo", "Merge \"orphan.msh\";\n");
  parameters.file = directory / "a.geo";
  EXPECT_EQ(read_mesh(parameters).vertices.size(), 4U);
}

// What only check_mesh() sees

TEST_F(BadMesh, CoordinateThatIsNotANumber)
{
  MshText text  = two_tetrahedra();
  text.nodes[4] = "0 nan -1";
  EXPECT_EQ(message(text),
            "a.msh: a corner of cell 2 is at (0, nan, -1), which is no point "
            "in space. Write the mesh again.");
}

TEST_F(BadMesh, CoincidentNodes)
{
  MshText text = two_tetrahedra();
  text.nodes.push_back("1 0 0");
  text.elements[1] = "4 2 1 1 1 3 6 5";
  EXPECT_NE(message(text).find("a.msh: two vertices are at the same position "
                               "(1, 0, 0), one of cell 1 and one of cell 2"),
            std::string::npos);
}

// Garbage: a mesh or a message, but no crash and no other exception.

TEST_F(BadMesh, DamagedFilesOfAllFlavours)
{
  run_in_child_process([&]() {
    const GmshSession session;
    gmsh::model::occ::addBox(0, 0, 0, 1, 1, 1);
    gmsh::model::occ::synchronize();
    gmsh::model::addPhysicalGroup(3, {1}, 1);
    gmsh::model::setPhysicalName(3, 1, "rock");
    gmsh::model::addPhysicalGroup(2, {1}, 1);
    gmsh::model::setPhysicalName(2, 1, "left");
    gmsh::option::setNumber("Mesh.MeshSizeMin", 1);
    gmsh::model::mesh::generate(3);
    for (const int flavour : {0, 1, 2, 3})
      {
        gmsh::option::setNumber("Mesh.MshFileVersion", flavour < 2 ? 2.2 : 4.1);
        gmsh::option::setNumber("Mesh.Binary", flavour % 2);
        gmsh::write(directory / (std::to_string(flavour) + ".msh"));
      }
    return std::string();
  });

  std::mt19937 random(1);
  unsigned int n_messages = 0;
  for (const std::string flavour : {"0", "1", "2", "3"})
    {
      const std::string good = read_file(directory / (flavour + ".msh"));
      ASSERT_EQ(message(good), "(nothing was thrown)");
      for (unsigned int i = 0; i < 25; ++i)
        {
          std::string bad = good;
          if (i < 5)
            bad.erase(good.size() * (i + 0.5) / 5);
          else
            for (unsigned int j = 0; j < i % 5 + 1; ++j)
              bad[random() % bad.size()] = static_cast<char>(random());
          n_messages += message(bad) != "(nothing was thrown)";
        }
    }
  // Some changes of digits make another good mesh.
  EXPECT_GT(n_messages, 50u);
}
