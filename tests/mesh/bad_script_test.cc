// What is wrong with a script, or with the request for a shape.

#include "bad_mesh.h"

#include <limits>

using namespace rift;

TEST_F(BadMesh, ScriptWithSyntaxError)
{
  EXPECT_EQ(message("radius = 1;\nSphere(1) = {0, 0;\n", "a.geo"),
            "a.geo: gmsh says: 'a.geo', line 2: syntax error (;)");
  EXPECT_EQ(message("Point(1) = {x, 0, 0, 1};\n", "a.geo"),
            "a.geo: gmsh says: 'a.geo', line 1: Unknown variable 'x'");
}

TEST_F(BadMesh, ScriptWithoutVolume)
{
  EXPECT_EQ(message("SetFactory(\"OpenCASCADE\");\n"
                    "Rectangle(1) = {0, 0, 0, 1, 1};\n",
                    "a.geo"),
            "a.geo: there are no cells. Define a volume, and write the 3-D "
            "mesh, not the 2-D one.");
}

TEST_F(BadMesh, ScriptThatEndsTheProgram)
{
  EXPECT_EQ(message("Exit;\n", "a.geo"),
            "a.geo: gmsh ended early with exit code 0 while it was at work on "
            "it. The file may be damaged or ask for a mesh that is too large; "
            "see what gmsh itself makes of it.");
}

TEST_F(BadMesh, ScriptThatDoesNotUseParameter)
{
  parameters.geo_parameters = {{"radius", 1}};
  const std::string expected =
    "The gmsh script 'a.geo' does not use the parameter 'radius'. Remove it "
    "from the scene, or write DefineConstant[ radius = ... ]; into the "
    "script and use it.";
  EXPECT_EQ(message("radius_2 = 1;\n", "a.geo"), expected);
  EXPECT_EQ(message("// radius\n", "a.geo"), expected);
  EXPECT_EQ(message("/* radius\n */ x = 1;", "a.geo"), expected);
  EXPECT_EQ(message("Printf(\"radius\");", "a.geo"), expected);

  parameters.geo_parameters.clear();
  parameters.element_size = 1;
  EXPECT_EQ(message("h = 1;\n", "a.geo"),
            "The gmsh script 'a.geo' does not use the parameter "
            "'element_size'. Remove it from the scene, or write "
            "DefineConstant[ element_size = ... ]; into the script and use "
            "it.");
}

TEST_F(BadMesh, ScriptThatOverwritesParameter)
{
  parameters.geo_parameters = {{"radius", 1}};
  const std::string expected =
    "The gmsh script 'a.geo' sets 'radius' itself, so that the value of the "
    "scene would be lost. Write DefineConstant[ radius = ... ]; in place of "
    "radius = ...;";
  EXPECT_EQ(message("radius = 1;\n", "a.geo"), expected);
  EXPECT_EQ(message("DefineConstant[ x[] = {1, 2} ]; radius = 1;\n", "a.geo"),
            expected);
  EXPECT_EQ(message("radius = DefineNumber[ 1, Name \"radius\" ];\n", "a.geo"),
            expected);
  write_file(directory / "b.geo", "radius = 1;\n");
  EXPECT_EQ(message("Include \"b.geo\";\nx = radius;\n", "a.geo"), expected);
}

TEST_F(BadMesh, ScriptThatIncludesWhatIsNotThere)
{
  EXPECT_EQ(message("Include \"c.geo\";\n", "a.geo"),
            "The gmsh script 'c.geo' cannot be opened. Check its path and that "
            "it may be read.");
  EXPECT_EQ(message("Include \"a.geo\";\n", "a.geo"),
            "The gmsh script 'a.geo' includes itself. Remove its Include.");
}

TEST_F(BadMesh, ScriptWithParameterSetTwiceOrInfinite)
{
  parameters.geo_parameters = {{"element_size", 1}};
  parameters.element_size   = 2;
  EXPECT_EQ(message("DefineConstant[ element_size = 1 ];\n", "a.geo"),
            "The parameter element_size of the gmsh script 'a.geo' is set "
            "twice, as 'Element size' and by name. Remove one of them.");
  parameters.element_size   = 0;
  parameters.geo_parameters = {{"x", std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(message("DefineConstant[ x = 1 ];\n", "a.geo"),
            "The parameter 'x' of the gmsh script 'a.geo' is inf. Give it a "
            "finite number.");
}

TEST_F(BadMesh, BuiltInShapeWithoutSize)
{
  parameters.shape        = MeshParameters::Shape::box;
  parameters.element_size = 0.1;
  EXPECT_THROW(read_mesh(parameters), InputError);
  parameters.box_size     = {{1, 1, 1}};
  parameters.element_size = 0;
  EXPECT_THROW(read_mesh(parameters), InputError);
  parameters.shape        = MeshParameters::Shape::cylinder;
  parameters.element_size = 0.1;
  EXPECT_THROW(read_mesh(parameters), InputError);
}
