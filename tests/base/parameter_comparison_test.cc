#include <rift/base/parameter_comparison.h>

#include <gtest/gtest.h>

namespace
{
  using rift::parameter_differences;
  using Lines = std::vector<std::string>;

  const std::string scene = "set Title = a bar\n"
                            "\n"
                            "subsection Material rock\n"
                            "  set Density = 2641\n"
                            "  set Young's modulus = 40.6e9\n"
                            "end\n"
                            "\n"
                            "subsection Boundary x_min\n"
                            "  set Pressure = t == 0 ? 1 : a/b\n"
                            "end\n"
                            "\n"
                            "subsection Time\n"
                            "  set End time = 1e-3\n"
                            "end\n";

  std::string
  replaced(std::string        text,
           const std::string &old_part,
           const std::string &new_part)
  {
    const auto position = text.find(old_part);
    EXPECT_NE(position, std::string::npos) << old_part;
    return text.replace(position, old_part.size(), new_part);
  }
} // namespace

TEST(ParameterDifferences, NoneWithinTheSameText)
{
  EXPECT_EQ(parameter_differences(scene, scene, {}), Lines());
  EXPECT_EQ(parameter_differences("", "", {}), Lines());
}

TEST(ParameterDifferences, EachEntryIsNamedWithBothValues)
{
  std::string other = replaced(scene, "2641", "2700");
  other             = replaced(other, "a/b", "a = b");
  other             = replaced(other, "a bar", "another");
  EXPECT_EQ(
    parameter_differences(other, scene, {}),
    (Lines{"Title is another here and a bar in the checkpoint",
           "Material rock / Density is 2700 here and 2641 in the checkpoint",
           "Boundary x_min / Pressure is t == 0 ? 1 : a = b here and t == 0 ? "
           "1 : a/b in the checkpoint"}));
}

TEST(ParameterDifferences, EntriesThatOnlyOneHas)
{
  const std::string other = replaced(scene, "  set Density = 2641\n", "");
  EXPECT_EQ(parameter_differences(scene, other, {}),
            Lines{"Material rock / Density is 2641 here and not set in the "
                  "checkpoint"});
  EXPECT_EQ(parameter_differences(other, scene, {}),
            Lines{"Material rock / Density is not set here and 2641 in the "
                  "checkpoint"});
}

TEST(ParameterDifferences, SubsectionsThatOnlyOneHas)
{
  const std::string probe = "subsection Probe end\n  set Field = velocity x\n"
                            "  set Boundary = x_max\nend\n";
  EXPECT_EQ(parameter_differences(scene + probe, scene, {}),
            Lines{"The subsection \"Probe end\" is here, but not in the "
                  "checkpoint"});
  EXPECT_EQ(parameter_differences(scene, scene + probe, {}),
            Lines{"The subsection \"Probe end\" is not here, but in the "
                  "checkpoint"});
  // A name that begins in the same way is another subsection.
  EXPECT_EQ(parameter_differences(replaced(scene, "Material rock", "Material"),
                                  scene,
                                  {}),
            (Lines{"The subsection \"Material\" is here, but not in the "
                   "checkpoint",
                   "The subsection \"Material rock\" is not here, but in the "
                   "checkpoint"}));
  EXPECT_EQ(parameter_differences(scene, scene + probe, {"Probe end"}),
            Lines());
}

TEST(ParameterDifferences, SomeMayDiffer)
{
  std::string other   = replaced(scene, "1e-3", "2e-3");
  other               = replaced(other, "2641", "2700");
  other               = replaced(other, "set Title = a bar\n", "");
  const Lines density = {
    "Material rock / Density is 2700 here and 2641 in the checkpoint"};
  const Lines end = {"Time / End time is 2e-3 here and 1e-3 in the checkpoint"};

  EXPECT_EQ(parameter_differences(other, scene, {"Title", "Time/End time"}),
            density);
  EXPECT_EQ(parameter_differences(other, scene, {"Title", "Time"}), density);
  EXPECT_EQ(parameter_differences(other, scene, {"Title", "Material rock"}),
            end);
  EXPECT_EQ(
    parameter_differences(other, scene, {"Title", "Material", "Time/End"}),
    (Lines{density[0], end[0]}));
}

TEST(ParameterDifferences, OrderDoesNotCount)
{
  EXPECT_EQ(parameter_differences("subsection A\nset x = 1\nset y = 2\nend\n"
                                  "subsection B\nset x = 3\nend\n",
                                  "subsection B\nset x = 3\nend\n"
                                  "subsection A\nset y = 2\nset x = 1\nend\n",
                                  {}),
            Lines());
}

TEST(ParameterDifferences, NestedSubsections)
{
  const std::string nested = "subsection A\n  subsection B\n    set x = 1\n"
                             "  end\n  set y = 2\nend\nset z = 3\n";
  EXPECT_EQ(parameter_differences(nested, "", {"A/B"}),
            (Lines{"The subsection \"A\" is here, but not in the checkpoint",
                   "z is 3 here and not set in the checkpoint"}));
  EXPECT_EQ(
    parameter_differences(nested, "", {"A/y", "z"}),
    Lines{"The subsection \"A / B\" is here, but not in the checkpoint"});
  EXPECT_EQ(
    parameter_differences(nested, replaced(nested, "x = 1", "x = 4"), {}),
    Lines{"A / B / x is 1 here and 4 in the checkpoint"});
}
