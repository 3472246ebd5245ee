#include <rift/app/command_line.h>
#include <rift/base/exceptions.h>

#include <gtest/gtest.h>

namespace
{
  using Action = rift::CommandLine::Action;

  rift::CommandLine
  parse(std::vector<const char *> arguments)
  {
    arguments.insert(arguments.begin(), "rift");
    return rift::parse_command_line(static_cast<int>(arguments.size()),
                                    arguments.data());
  }
} // namespace

TEST(CommandLine, SceneAlone)
{
  const rift::CommandLine command = parse({"a b.prm"});
  EXPECT_EQ(command.action, Action::run);
  EXPECT_EQ(command.scene, "a b.prm");
  EXPECT_TRUE(command.overrides.empty());
  EXPECT_FALSE(command.restart);
}

TEST(CommandLine, Restart)
{
  const rift::CommandLine command = parse({"--restart", "a.prm"});
  EXPECT_EQ(command.action, Action::run);
  EXPECT_EQ(command.scene, "a.prm");
  EXPECT_TRUE(command.restart);
}

TEST(CommandLine, OverridesBeforeAndAfterTheScene)
{
  const rift::CommandLine command = parse({"--set",
                                           "Time/End time=1e-3",
                                           "scene.prm",
                                           "--set",
                                           "Mesh/Parameters=a=1, b=2",
                                           "--output",
                                           "out",
                                           "--validate"});
  EXPECT_EQ(command.action, Action::validate);
  EXPECT_EQ(command.scene, "scene.prm");
  EXPECT_EQ(command.overrides,
            (std::vector<std::string>{"Time/End time=1e-3",
                                      "Mesh/Parameters=a=1, b=2",
                                      "Output/Directory=out"}));
}

TEST(CommandLine, NeedsNoSceneToPrint)
{
  EXPECT_EQ(parse({"--defaults"}).action, Action::print_defaults);
  EXPECT_EQ(parse({"--reference"}).action, Action::print_reference);
  EXPECT_EQ(parse({"--version"}).text, "rift " RIFT_VERSION "\n");
  const rift::CommandLine help = parse({"--help"});
  EXPECT_EQ(help.action, Action::print_text);
  for (const char *option :
       {"--set", "--output", "--restart", "--validate", "--defaults"})
    EXPECT_NE(help.text.find(option), std::string::npos) << option;
}

TEST(CommandLine, RefusesWhatItDoesNotKnow)
{
  EXPECT_THROW(parse({}), rift::InputError);
  EXPECT_THROW(parse({"a.prm", "b.prm"}), rift::InputError);
  EXPECT_THROW(parse({"a.prm", "--outptu", "x"}), rift::InputError);
  EXPECT_THROW(parse({"a.prm", "--set"}), rift::InputError);
  EXPECT_THROW(parse({"a.prm", "--restart", "--validate"}), rift::InputError);
}
