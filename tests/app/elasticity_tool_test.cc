#include <rift/app/elasticity_tool.h>
#include <rift/base/exceptions.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace rift;

namespace
{
  const std::string scene = RIFT_SOURCE_DIRECTORY "/prm/barre/pulse.prm";

  std::string
  run(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), "rift-elasticity");
    std::vector<const char *> argv;
    for (const std::string &argument : arguments)
      argv.push_back(argument.c_str());
    std::ostringstream out;
    run_elasticity_tool(static_cast<int>(argv.size()), argv.data(), out);
    return out.str();
  }

  void
  expect_error(const std::vector<std::string> &arguments,
               const std::string              &message)
  {
    try
      {
        run(arguments);
        ADD_FAILURE() << "no error: " << message;
      }
    catch (const InputError &error)
      {
        EXPECT_EQ(std::string(error.what()), message);
      }
  }

  void
  expect_contains(const std::string &text, const std::string &part)
  {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }

  /** Table 1 of Fukuda et al. (2021); its rows 4 to 6 are 12, 23, 31. */
  const std::string table_1 =
    "54.7e9, 8.08e9, 7.13e9, 0, 0, 0, 40.7e9, 5.54e9, 0, 0, 0, 35.2e9, 0, 0, "
    "0, 15.5e9, 0, 0, 17.9e9, 0, 19.2e9";
} // namespace

TEST(ElasticityTool, PrintsStiffnessAndSpeeds)
{
  const std::string text = run({scene, "--direction", "1 1 1"});
  expect_contains(text, "54.666");
  // sqrt(35.105e9 / 2610)
  expect_contains(text, "0 0 1                      3667.5");
  expect_contains(text, "1 1 1 ");
}

TEST(ElasticityTool, FitsTableOneOfTheArticle)
{
  const auto fit = [](const std::string &scheme) {
    return run({scene,
                "barre",
                "--set",
                "Material barre/Crack scheme=" + scheme,
                "--fit-stiffness",
                table_1});
  };
  expect_contains(fit("dilute"),
                  "set Crack groups = 0 1 0: 0.1035, 0 0 1: 0.1654, random: "
                  "0.3027");
  // Over 21 components; over the 9 that are not zero 0.214 GPa.
  expect_contains(fit("differential"), "GPa; root mean square 0.140");
}

TEST(ElasticityTool, FitsMeasuredSpeeds)
{
  const std::string text = run({scene,
                                "barre",
                                "--fit-speeds",
                                RIFT_SOURCE_DIRECTORY "/prm/barre/speeds.csv"});
  expect_contains(text, "m/s; root mean square 0.000");
  expect_contains(text, "1 0 0                      4630.0");
  expect_contains(text, "0 1 0                      3940.0");
}

TEST(ElasticityTool, SaysWhenCracksCannotExplainTheSpeeds)
{
  const std::string table = testing::TempDir() + "/fast_speeds.csv";
  std::ofstream(table) << "x,y,z,wave,speed [m/s]\n1, 0, 0, P, 6700\n"
                          "0, 1, 0, P, 7000\n0, 0, 1, P, 6400\n";
  expect_contains(run({scene,
                       "barre",
                       "--set",
                       "Material barre/Crack scheme=dilute",
                       "--direction",
                       "1, 1, 0",
                       "--fit-speeds",
                       table}),
                  "WARNING: densities are at their limit, zero");
}

TEST(ElasticityTool, SaysWhatIsWrong)
{
  expect_contains(run({"--help"}), "--fit-speeds");
  expect_error({scene, "barer"},
               "command line: there is no elastic material \"barer\" in the "
               "scene. Did you mean \"barre\"?");
  expect_error({scene, "--direction", "1 1"},
               "command line: the direction \"1 1\" is not of the form \"1 1 "
               "0\".");
  expect_error({scene, "barre", "--fit-stiffness", "1e9, 2e9"},
               "command line: a stiffness has 21 numbers with commas between "
               "them, 11, 12, ..., 66; there are 2.");
  expect_error({scene, "--fit-stiffness", table_1},
               "command line: say which material is to be fitted, after the "
               "scene.");
  expect_error({scene,
                "barre",
                "--set",
                "Material barre/Elasticity=isotropic",
                "--fit-stiffness",
                table_1},
               "the material \"barre\" is not microcracked; only crack "
               "densities can be fitted.");
  expect_error({scene, "barre", "--fit-speeds", "nowhere.csv"},
               "cannot read the table nowhere.csv: No such file or "
               "directory.");
  expect_error({"--speed", scene},
               "command line: The following argument was not expected: "
               "--speed. Run \"rift-elasticity --help\" for what there is.");

  const std::string table = testing::TempDir() + "/speeds.csv";
  const auto        write = [&table](const std::string &row) {
    std::ofstream(table) << "x,y,z,wave,speed [m/s]\n" << row << '\n';
  };
  std::ofstream(table) << "0, 0, 1, P, 3670\n";
  expect_error({scene, "barre", "--fit-speeds", table},
               table +
                 ":1: found \"0, 0, 1, P, 3670\" instead of a header; the "
                 "first line is \"x, y, z, wave, speed [m/s]\".");
  write("0, 0, 1, Q, 3670");
  expect_error({scene, "barre", "--fit-speeds", table},
               table +
                 ":2: found \"0, 0, 1, Q, 3670\"; a row is a direction, P, S1 "
                 "or S2, and a speed, as in \"0, 0, 1, P, 3670\".");
  write("0, 0, 1, P, 3670");
  expect_error({scene, "barre", "--fit-speeds", table},
               "a fit of 3 crack densities needs as many measured values; "
               "there are 1.");
}
