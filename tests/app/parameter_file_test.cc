#include <rift/base/parameter_file.h>
#include <rift/base/parameter_text.h>

#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace
{
  using rift::ParameterFile;

  // A folder with files, removed at the end of a test.
  class ParameterFileTest : public testing::Test
  {
  protected:
    const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("rift_parameter_file_" +
       std::string(
         testing::UnitTest::GetInstance()->current_test_info()->name()));

    ParameterFileTest()
    {
      std::filesystem::create_directories(folder / "sub");
    }

    ~ParameterFileTest() override
    {
      std::filesystem::remove_all(folder);
    }

    std::string
    write(const std::string &name, const std::string &text) const
    {
      std::ofstream(folder / name, std::ios::binary) << text;
      return (folder / name).string();
    }
  };
} // namespace

TEST_F(ParameterFileTest, ReadsTheSyntax)
{
  const std::string   path = write("a.prm",
                                 "\xEF\xBB\xBF# comment\r\n"
                                   "set  Title =  A   bar # it is\r\n"
                                   "subsection  Material   coarse granite\r\n"
                                   "\tset Stiffness = 1, \\ # first\n"
                                   "       2, 3\n"
                                   "  set Empty =\n"
                                   "end # of it\n"
                                   "set f = a = b");
  const ParameterFile file(path);
  ASSERT_EQ(file.entries().size(), 4u);
  EXPECT_EQ(file.entries()[0].section, "");
  EXPECT_EQ(file.entries()[0].name, "Title");
  EXPECT_EQ(file.entries()[0].value, "A bar");
  EXPECT_EQ(file.entries()[0].line, 2u);
  EXPECT_EQ(file.entries()[1].section, "Material coarse granite");
  EXPECT_EQ(file.entries()[1].value, "1, 2, 3");
  EXPECT_EQ(file.entries()[1].line, 4u);
  EXPECT_EQ(file.entries()[2].value, "");
  EXPECT_EQ(file.entries()[2].line, 6u);
  EXPECT_EQ(file.entries()[3].value, "a = b");
  EXPECT_EQ(file.names_of("Material"),
            std::vector<std::string>{"coarse granite"});
  EXPECT_TRUE(file.names_of("Probe").empty());
}

TEST_F(ParameterFileTest, IncludesRelativeToTheIncludingFile)
{
  write("sub/inner.inc", "set File = bar.geo\n");
  write("sub/outer.inc", "subsection Mesh\n  include inner.inc\nend\n");
  const ParameterFile file(write("a.prm", "include sub/outer.inc\n"));
  const auto         *entry = file.find("Mesh", "File");
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->file, (folder / "sub/inner.inc").string());
  EXPECT_EQ(entry->line, 1u);
  EXPECT_EQ(file.resolve("Mesh", "File", "../bar.geo"),
            (folder / "bar.geo").string());
  EXPECT_EQ(file.resolve("Mesh", "File", "/bar.geo"), "/bar.geo");
}

TEST_F(ParameterFileTest, SetTwiceInTwoFilesNamesBoth)
{
  const std::string inner = write("b.inc", "set A = 1\n");
  const std::string outer = write("a.prm", "set A = 2\ninclude b.inc\n");
  try
    {
      const ParameterFile file(outer);
      FAIL() << "the second set was accepted";
    }
  catch (const rift::InputError &error)
    {
      EXPECT_EQ(error.what(),
                inner + ":1: A = 1: this has been set already at " + outer +
                  ":1 to \"2\". Remove one of the two.");
    }
}

TEST_F(ParameterFileTest, OverridesTakeTheirPlace)
{
  const ParameterFile file(
    write("a.prm", "subsection Time\n  set End time = 1\nend\n"),
    {"Time/End time = 2", "Title=a=b", "Time/Time step=auto"});
  ASSERT_EQ(file.entries().size(), 3u);
  EXPECT_EQ(file.find("Time", "End time")->value, "2");
  EXPECT_TRUE(file.find("Time", "End time")->is_override);
  EXPECT_EQ(file.find("", "Title")->value, "a=b");
  EXPECT_EQ(file.find("Time", "Time step")->value, "auto");
  // Relative to the scene, not to the folder in which rift is started.
  EXPECT_EQ(file.resolve("Time", "End time", "x.csv"),
            (folder / "x.csv").string());
}

TEST_F(ParameterFileTest, WhatTheCommandLineSwitchesOffIsForgiven)
{
  const std::string                     path  = write("a.prm",
                                 "subsection Fracture\n"
                                                      "  set Cohesive model = extrinsic\n"
                                                      "  set Seed = 7\nend\n");
  const std::vector<rift::InertEntries> inert = {
    {"Fracture", {"Seed"}, {{"Fracture", "Cohesive model"}}, "here"}};
  EXPECT_THROW(ParameterFile(path).refuse_inert(inert), rift::ParameterError);
  EXPECT_NO_THROW(
    ParameterFile(path, {"Fracture/Cohesive model=none"}).refuse_inert(inert));
  // An entry on the command line itself is never forgiven.
  EXPECT_THROW(
    ParameterFile(path, {"Fracture/Cohesive model=none", "Fracture/Seed=8"})
      .refuse_inert(inert),
    rift::ParameterError);
}

TEST_F(ParameterFileTest, GarbageIsRefusedReadably)
{
  const std::string path = write("a.prm", std::string("\x01\x02\0\x7f ok", 7));
  try
    {
      const ParameterFile file(path);
      FAIL() << "garbage was accepted";
    }
  catch (const rift::InputError &error)
    {
      EXPECT_EQ(std::string(error.what())
                  .find(path + ":1: cannot understand "
                               "\"???? ok\"."),
                0u)
        << error.what();
    }
}

TEST_F(ParameterFileTest, WhatIsNoUtf8IsRefusedWithItsLine)
{
  // Comments are nobody's business.
  EXPECT_EQ(
    ParameterFile(write("a.prm", "# H\xe4rte\nset Title = H\u00e4rte\n"))
      .entries()[0]
      .value,
    "H\u00e4rte");
  const auto message = [](const std::string              &path,
                          const std::vector<std::string> &overrides) {
    return rift::message_of<rift::InputError>(
      [&] { ParameterFile(path, overrides); });
  };
  const std::string bad =
    write("bad.prm", "set Title = a \\\n  b \\\n  H\xe4rte\n");
  EXPECT_EQ(message(bad, {}),
            bad + ":3: the byte 0xe4 in \"H?rte\" is not valid UTF-8. Save the "
                  "file as UTF-8, or use ASCII.");
  // As an editor that takes itself for Windows saves it.
  const std::string wide =
    write("wide.prm", std::string("\xff\xfes\0e\0t\0", 8));
  EXPECT_EQ(
    message(wide, {}),
    wide +
      ":1: the byte 0xff in \"??s?e?t?\" is not valid UTF-8. Save the file "
      "as UTF-8, or use ASCII.");
  const std::string good = write("good.prm", "set Title = a\n");
  EXPECT_EQ(
    message(good, {"Output/Directory=H\xe4rte"}),
    "--set Output/Directory=H?rte: the byte 0xe4 in "
    "\"Output/Directory=H?rte\" is not valid UTF-8. Use UTF-8 or ASCII.");
}

TEST(Utf8, IsToldFromOtherBytes)
{
  using rift::find_invalid_utf8;
  for (const std::string good : {"",
                                 "a",
                                 "\x7f",
                                 "\xc2\x80",
                                 "\u00e4",
                                 "\u20ac",
                                 "\xed\x9f\xbf",
                                 "\xee\x80\x80",
                                 "\xf0\x90\x80\x80",
                                 "\xf4\x8f\xbf\xbf"})
    EXPECT_EQ(find_invalid_utf8(good), std::string::npos) << good;
  EXPECT_EQ(find_invalid_utf8("\u00e4\u20ac\xe4x"), 5u);
  // Cut off, overlong, surrogates, beyond Unicode, and lone bytes.
  for (const std::string bad : {"\x80",
                                "\xbf",
                                "\xc3",
                                "\xe2\x82",
                                "\xf0\x90\x80",
                                "\xc0\xaf",
                                "\xc1\xbf",
                                "\xe0\x9f\xbf",
                                "\xf0\x8f\xbf\xbf",
                                "\xed\xa0\x80",
                                "\xf4\x90\x80\x80",
                                "\xf5\x80\x80\x80",
                                "\xfe",
                                "\xff",
                                "\xe2\x28\xa1"})
    EXPECT_EQ(find_invalid_utf8("ab" + bad), 2u);
}

TEST(Excerpt, IsPrintableAndShort)
{
  EXPECT_EQ(rift::excerpt("a\tb\xe4\u00e4"), "a?b?\u00e4");
  const std::string text(59, 'x');
  EXPECT_EQ(rift::excerpt(text + "y"), text + "y");
  EXPECT_EQ(rift::excerpt(text + "yz"), text + "y...");
  // Not within a character.
  EXPECT_EQ(rift::excerpt(text + "\u00e4"), text + "...");
}

TEST(Name, HasNoCharactersWithAMeaning)
{
  for (const std::string good : {"granite 2", "1", "H\u00e4rte", "a.b-c_d+e"})
    EXPECT_EQ(rift::name_problem(good), "");
  for (const char c : std::string("/#,;\"'[]{}()=\\"))
    EXPECT_EQ(rift::name_problem(std::string("a") + c),
              "a name cannot have any of / # , ; \" ' [ ] { } ( ) = \\ in it");
  EXPECT_EQ(rift::name_problem("H\xe4rte"), "a name must be UTF-8");
}

TEST(Suggestion, NeverNamesNothing)
{
  EXPECT_EQ(rift::suggestion("tpo", {"top", "side"}), " Did you mean \"top\"?");
  EXPECT_EQ(rift::suggestion("joint", {"top", "side"}),
            " Known are top and side.");
  EXPECT_EQ(rift::suggestion("joint", {}), " There are none.");
  EXPECT_EQ(rift::suggestion("joint", {}, "The list is empty."),
            " The list is empty.");
}

TEST(NearestName, FindsWhatIsMeant)
{
  const std::vector<std::string> known = {"Density",
                                          "Young's modulus",
                                          "Weibull modulus",
                                          "Element size"};
  EXPECT_EQ(rift::nearest_name("Denisty", known), "Density");
  EXPECT_EQ(rift::nearest_name("density", known), "Density");
  EXPECT_EQ(rift::nearest_name("Young", known), "Young's modulus");
  EXPECT_EQ(rift::nearest_name("Youngs modulus", known), "Young's modulus");
  EXPECT_EQ(rift::nearest_name("Elem size", known), "Element size");
  EXPECT_EQ(rift::nearest_name("Colour", known), "");
  EXPECT_EQ(rift::nearest_name("", known), "");
  EXPECT_EQ(rift::nearest_name("x", {}), "");
}

TEST(Enumeration, JoinsWords)
{
  EXPECT_EQ(rift::enumeration({}), "");
  EXPECT_EQ(rift::enumeration({"a"}), "a");
  EXPECT_EQ(rift::enumeration({"a", "b"}), "a or b");
  EXPECT_EQ(rift::enumeration({"a", "b", "c"}, "and"), "a, b and c");
}
