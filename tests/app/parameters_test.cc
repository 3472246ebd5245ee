#include <rift/app/parameter_reference.h>
#include <rift/app/parameters.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
  using namespace rift;

  // Scenes with the files that they need, removed at the end of a test.
  class ParametersTest : public testing::Test
  {
  protected:
    const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("rift_parameters_" +
       std::string(
         testing::UnitTest::GetInstance()->current_test_info()->name()));

    ParametersTest()
    {
      std::filesystem::create_directories(folder);
      write("bar.geo", "");
      write("pulse.csv", "");
    }

    ~ParametersTest() override
    {
      std::filesystem::remove_all(folder);
    }

    std::string
    write(const std::string &name, const std::string &text) const
    {
      std::ofstream(folder / name) << text;
      return (folder / name).string();
    }
  };

  // Every kind of entry, with values that are nowhere a default.
  const char *const full_scene = R"(
set Title = Everything
subsection Mesh
  set File = bar.geo
  set Element size = 2.5e-3
  set Parameters = radius=0.019, length = 0.18
end
subsection Material granite
  set Density = 2641.0000000000005
  set Young's modulus = 40.6e9
  set Poisson's ratio = 0.2
  set Viscosity = 1e3
  set Initial velocity = 1, -2, 3e-1
  set Tensile strength = 15e6
  set Cohesion = 36.7e6
  set Friction angle = 50
  set Fracture energy I = 400
  set Fracture energy II = 401
  set Weibull modulus = 12.5
end
subsection Material steel
  set Density = 7850
  set Elasticity = anisotropic
  set Stiffness = 231e9, 135e9, 135e9, 0, 0, 0, 231e9, 135e9, 0, 0, 0, \
                  231e9, 0, 0, 0, 116e9, 1, 2, 116e9, 3, 116e9
  set Axis 1 = 0, 1, 0
  set Axis 2 = 0, 0, 1
  set Breakable = false
end
subsection Boundary loaded
  set Pressure = pulse.csv
  set Velocity y = 0
end
subsection Boundary side
  set Traction x = 1e6 * sin(t)
  set Traction z = pulse.csv
end
subsection Body force
  set Gravity = 0, 0, -9.81
end
subsection Fracture
  set Cohesive model = extrinsic
  set Cohesive law = faces
  set Stiffness factor = 0.5
  set Seed = 42
end
subsection Time
  set End time = 200e-6
  set Safety factor = 0.6
  set Largest energy residual = 0.01
end
subsection Output
  set Directory = somewhere else
  set Solution interval = 5e-6
  set History interval = 1e-7
  set Fields = velocity,  normal traction
  set Overwrite = true
  set Ranks per file = 8
end
subsection Checkpoint
  set Interval in steps = 500000
  set Interval in minutes = 12.5
  set Number of sets = 3
end
subsection Probe fspv
  set Field = velocity x
  set Boundary = free_end
end
subsection Probe middle
  set Field = stress yz
  set Point = 0.09, 0, 0
end
)";

  void
  expect_full_scene(const Parameters &p, const std::string &folder)
  {
    EXPECT_EQ(p.title, "Everything");
    EXPECT_EQ(p.mesh.shape, MeshParameters::Shape::file);
    EXPECT_EQ(p.mesh.file, folder + "/bar.geo");
    EXPECT_EQ(p.mesh.element_size, 2.5e-3);
    EXPECT_EQ(
      p.mesh.geo_parameters,
      (std::map<std::string, double>{{"radius", 0.019}, {"length", 0.18}}));
    ASSERT_EQ(p.materials.size(), 2u);
    const MaterialParameters &granite = p.materials[0];
    EXPECT_EQ(granite.name, "granite");
    EXPECT_EQ(granite.density, 2641.0000000000005);
    EXPECT_EQ(granite.elasticity, MaterialParameters::Elasticity::isotropic);
    EXPECT_EQ(granite.youngs_modulus, 40.6e9);
    EXPECT_EQ(granite.poissons_ratio, 0.2);
    EXPECT_EQ(granite.viscosity, 1e3);
    EXPECT_EQ(granite.initial_velocity, (Vector3<double>{{1, -2, 0.3}}));
    EXPECT_TRUE(granite.breakable);
    EXPECT_EQ(granite.tensile_strength.smallest(), 15e6);
    EXPECT_EQ(granite.cohesion.smallest(), 36.7e6);
    EXPECT_NEAR(granite.friction_angle, 0.872664625997165, 1e-15);
    EXPECT_EQ(granite.fracture_energy_1.smallest(), 400);
    EXPECT_EQ(granite.fracture_energy_2.smallest(), 401);
    EXPECT_FALSE(granite.has_directional_strength());
    EXPECT_EQ(granite.weibull_modulus, 12.5);
    const MaterialParameters &steel = p.materials[1];
    EXPECT_EQ(steel.elasticity, MaterialParameters::Elasticity::anisotropic);
    EXPECT_EQ(steel.stiffness[0], 231e9);
    EXPECT_EQ(steel.stiffness[6], 231e9);
    EXPECT_EQ(steel.stiffness[17], 2);
    EXPECT_EQ(steel.stiffness[20], 116e9);
    EXPECT_EQ(steel.axis_1, (Vector3<double>{{0, 1, 0}}));
    EXPECT_EQ(steel.axis_2, (Vector3<double>{{0, 0, 1}}));
    EXPECT_FALSE(steel.breakable);
    ASSERT_EQ(p.boundaries.size(), 2u);
    EXPECT_EQ(p.boundaries[0].name, "loaded");
    EXPECT_EQ(p.boundaries[0].pressure, folder + "/pulse.csv");
    EXPECT_EQ(p.boundaries[0].velocity,
              (std::array<std::string, 3>{{"", "0", ""}}));
    EXPECT_EQ(p.boundaries[1].pressure, "");
    EXPECT_EQ(p.boundaries[1].traction,
              (std::array<std::string, 3>{
                {"1e6 * sin(t)", "", folder + "/pulse.csv"}}));
    EXPECT_NE(used_parameters(p).find("set Gravity = 0, 0, -9.81"),
              std::string::npos);
    EXPECT_EQ(p.cohesive.model, CohesiveParameters::Model::extrinsic);
    EXPECT_EQ(p.cohesive.stiffness_factor, 0.5);
    EXPECT_EQ(p.cohesive.seed, 42u);
    EXPECT_EQ(p.time.end_time, 200e-6);
    EXPECT_EQ(p.time.time_step, 0);
    EXPECT_EQ(p.time.safety_factor, 0.6);
    EXPECT_EQ(p.time.largest_residual, 0.01);
    EXPECT_EQ(p.output.directory, "somewhere else");
    EXPECT_EQ(p.output.solution_interval, 5e-6);
    EXPECT_EQ(p.output.history_interval, 1e-7);
    EXPECT_EQ(p.output.fields.words,
              (std::vector<std::string>{"velocity", "normal traction"}));
    EXPECT_TRUE(p.output.overwrite);
    EXPECT_EQ(p.output.ranks_per_file, 8);
    EXPECT_EQ(p.checkpoint.interval_in_steps, 500000u);
    EXPECT_EQ(p.checkpoint.interval_in_minutes, 12.5);
    EXPECT_EQ(p.checkpoint.n_sets, 3u);
    ASSERT_EQ(p.probes.size(), 2u);
    EXPECT_EQ(p.probes[0].name, "fspv");
    EXPECT_EQ(p.probes[0].field.name, "velocity");
    EXPECT_EQ(p.probes[0].field.unit, "m/s");
    EXPECT_EQ(p.probes[0].field.location, FieldLocation::node);
    EXPECT_EQ(p.probes[0].field.index, 0u);
    EXPECT_EQ(p.probes[0].boundary, "free_end");
    EXPECT_EQ(p.probes[1].field.name, "stress");
    EXPECT_EQ(p.probes[1].field.unit, "Pa");
    EXPECT_EQ(p.probes[1].field.location, FieldLocation::cell);
    EXPECT_EQ(p.probes[1].field.index, 3u);
    EXPECT_EQ(p.probes[1].point, (Vector3<double>{{0.09, 0, 0}}));
  }
} // namespace

TEST_F(ParametersTest, EveryEntryArrives)
{
  expect_full_scene(read_parameters(write("full.prm", full_scene)),
                    folder.string());
}

TEST_F(ParametersTest, StrengthsByDirection)
{
  std::string text = full_scene;
  text.replace(text.find("= 401"), 5, "= 401, 300, 250.5");
  const Parameters p      = read_parameters(write("directional.prm", text));
  const auto      &energy = p.materials[0].fracture_energy_2;
  EXPECT_EQ(energy.at({{1, 0, 0}}), 401);
  EXPECT_EQ(energy.at({{0, 1, 0}}), 300);
  EXPECT_EQ(energy.at({{0, 0, 1}}), 250.5);
  EXPECT_TRUE(p.materials[0].has_directional_strength());
}

TEST_F(ParametersTest, UsedParametersGiveTheSameScene)
{
  const Parameters first = read_parameters(write("full.prm", full_scene));
  std::filesystem::create_directories(folder / "results");
  const Parameters second =
    read_parameters(write("results/parameters.prm", used_parameters(first)));
  expect_full_scene(second, folder.string());
  EXPECT_EQ(used_parameters(first), used_parameters(second));
}

TEST_F(ParametersTest, UsedParametersOfASwitchedOffModelCanBeRead)
{
  const Parameters first =
    read_parameters(write("full.prm", full_scene),
                    {"Fracture/Cohesive model=none", "Time/Time step=1e-9"});
  EXPECT_EQ(first.cohesive.model, CohesiveParameters::Model::none);
  const Parameters second =
    read_parameters(write("parameters.prm", used_parameters(first)));
  EXPECT_EQ(second.time.time_step, 1e-9);
  EXPECT_EQ(used_parameters(first), used_parameters(second));
}

TEST_F(ParametersTest, DefaultsAreThoseOfTheStructures)
{
  const Parameters p = read_parameters(write("small.prm", R"(
subsection Mesh
  set Shape = cylinder
  set Element size = 2.5e-3
  set Cylinder radius = 0.019
  set Cylinder length = 0.18
end
subsection Material rock
  set Density = 2641
  set Young's modulus = 40.6e9
end
subsection Time
  set End time = 1e-3
end
)"));
  EXPECT_EQ(p.mesh.shape, MeshParameters::Shape::cylinder);
  EXPECT_EQ(p.mesh.cylinder_radius, 0.019);
  EXPECT_EQ(p.mesh.cylinder_length, 0.18);
  EXPECT_EQ(p.mesh.material, "rock");
  EXPECT_EQ(p.materials[0].axis_1, MaterialParameters().axis_1);
  EXPECT_EQ(p.materials[0].axis_2, MaterialParameters().axis_2);
  EXPECT_EQ(p.materials[0].breakable, MaterialParameters().breakable);
  EXPECT_EQ(p.cohesive.model, CohesiveParameters().model);
  EXPECT_EQ(p.cohesive.stiffness_factor, CohesiveParameters().stiffness_factor);
  EXPECT_EQ(p.cohesive.seed, CohesiveParameters().seed);
  EXPECT_EQ(p.time.safety_factor, TimeParameters().safety_factor);
  EXPECT_EQ(p.time.largest_residual, TimeParameters().largest_residual);
  EXPECT_EQ(p.output.directory, OutputParameters().directory);
  EXPECT_EQ(p.output.solution_interval, OutputParameters().solution_interval);
  EXPECT_EQ(p.output.history_interval, OutputParameters().history_interval);
  EXPECT_EQ(p.output.fields.words, OutputParameters().fields.words);
  EXPECT_EQ(p.output.ranks_per_file, OutputParameters().ranks_per_file);
  EXPECT_EQ(p.output.overwrite, OutputParameters().overwrite);
  EXPECT_EQ(p.checkpoint.interval_in_steps,
            CheckpointParameters().interval_in_steps);
  EXPECT_EQ(p.checkpoint.interval_in_minutes,
            CheckpointParameters().interval_in_minutes);
  EXPECT_EQ(p.checkpoint.n_sets, CheckpointParameters().n_sets);
}

TEST_F(ParametersTest, DoubtsWhatMayNotBeMeant)
{
  const std::string scene = write("everything.prm", full_scene);
  EXPECT_TRUE(warnings(read_parameters(scene)).empty());
  const auto found = warnings(read_parameters(
    scene,
    {"Fracture/Cohesive model=none", "Output/Solution interval=1e3"}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0],
            "Material granite has strengths, but nothing breaks without a "
            "\"Cohesive model\" in subsection Fracture.");
  EXPECT_EQ(found[1],
            "Output/Solution interval is longer than the run. Are both times "
            "in seconds?");
}

TEST_F(ParametersTest, SummaryNamesWhatTheSceneHas)
{
  std::ostringstream out;
  print_summary(out, read_parameters(write("full.prm", full_scene)));
  EXPECT_EQ(out.str(),
            "title:      Everything\n"
            "mesh:       " +
              folder.string() +
              "/bar.geo\n"
              "materials:  granite, steel\n"
              "boundaries: loaded, side\n"
              "probes:     fspv, middle\n"
              "fracture:   extrinsic, faces\n"
              "contact:    yes\n"
              "end time:   0.0002 s\n"
              "output:     somewhere else\n");

  std::string       scene = full_scene;
  const std::string entry = "  set Stiffness factor = 0.5\n";
  scene.erase(scene.find(entry), entry.size());
  std::ostringstream intrinsic;
  print_summary(intrinsic,
                read_parameters(write("full.prm", scene),
                                {"Fracture/Cohesive model=intrinsic"}));
  EXPECT_NE(intrinsic.str().find("fracture:   intrinsic, faces\n"),
            std::string::npos);
}

TEST(Reference, NamesUnitsChoicesAndDefaults)
{
  std::ostringstream out;
  generate_reference(out);
  EXPECT_NE(out.str().find("| Density | `0` | kg/m^3 | a number | Mass "
                           "density. Must be set. |\n"),
            std::string::npos);
  EXPECT_NE(out.str().find("| Safety factor | `0.7` | 1 |"), std::string::npos);
  EXPECT_NE(out.str().find(
              "| Cohesive model | `none` |  | none, extrinsic or intrinsic |"),
            std::string::npos);
  EXPECT_NE(out.str().find("## Probe NAME\n"), std::string::npos);
}
