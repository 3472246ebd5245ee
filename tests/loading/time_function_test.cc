#include <rift/base/exceptions.h>
#include <rift/loading/time_function.h>
#include <rift/loading/time_table.h>

#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace rift;

namespace
{
  const std::string where = "Boundary loaded / Pressure";

  const std::string advice =
    " Write an expression in the time t in seconds, such as "
    "\"1e6*sin(2*pi*t/1e-3)\", or the name of a .csv table.";

  std::string
  refusal(const std::string &text)
  {
    return message_of<InputError>([&] { TimeFunction(text, where); });
  }

  /** A table with this content, in a directory of its own. */
  struct TableFile
  {
    explicit TableFile(const std::string &content)
      : path(directory / "pulse.csv")
    {
      write_file(path, content);
    }

    TemporaryDirectory directory;
    std::string        path;
  };

  /** What reading the table says after the name of the file. */
  std::string
  table_refusal(const std::string &content, const std::string &unit = "")
  {
    const TableFile   file(content);
    const std::string message =
      message_of<InputError>([&] { TimeTable(file.path, where, unit); });
    const std::string start = where + ": table " + file.path + ", ";
    EXPECT_EQ(message.substr(0, start.size()), start);
    return message.substr(std::min(start.size(), message.size()));
  }
} // namespace

TEST(TimeFunction, Expressions)
{
  EXPECT_DOUBLE_EQ(TimeFunction("2.5e7", where)(3), 2.5e7);
  EXPECT_NEAR(TimeFunction(" sin(2*pi*t) ", where)(0.25), 1, 1e-15);
  const TimeFunction pulse("t <= 1e-5 ? 1e7*t^2 : 0", where);
  EXPECT_DOUBLE_EQ(pulse(1e-5), 1e-3);
  EXPECT_EQ(pulse(1.1e-5), 0);
  const TimeFunction copy = pulse;
  EXPECT_DOUBLE_EQ(copy(2e-6), 4e-5);
}

TEST(TimeFunction, ComparisonsAreNoAssignments)
{
  EXPECT_EQ(TimeFunction("(t >= 1) + (t == 2) + (t != 3)", where)(2), 3);
}

TEST(TimeFunction, UnknownName)
{
  EXPECT_EQ(refusal("2*foo(t)"),
            where +
              ": cannot understand \"2*foo(t)\": Unexpected token \"foo\" "
              "found at position 2." +
              advice);
}

TEST(TimeFunction, Unfinished)
{
  EXPECT_EQ(
    refusal("2*(t"),
    where + ": cannot understand \"2*(t\": Missing parenthesis at position 4." +
      advice);
}

TEST(TimeFunction, NumberWithItsUnit)
{
  EXPECT_EQ(refusal("1.5 MPa"),
            where +
              ": cannot understand \"1.5 MPa\": Unexpected token \"MPa\" "
              "found at position 4." +
              advice);
}

TEST(TimeFunction, MissingArgument)
{
  EXPECT_EQ(refusal("sin()"),
            where +
              ": cannot understand \"sin()\": Too few parameters for "
              "function \"sin\" at expression position 4." +
              advice);
}

TEST(TimeFunction, Assignment)
{
  EXPECT_EQ(refusal("t = 3"),
            where +
              ": cannot understand \"t = 3\": it assigns a value at position "
              "2; a comparison is ==." +
              advice);
}

TEST(TimeFunction, SeveralValues)
{
  EXPECT_EQ(refusal("1,5*t"),
            where +
              ": cannot understand \"1,5*t\": it has 2 values, separated by "
              "commas, instead of one." +
              advice);
}

TEST(TimeFunction, Empty)
{
  EXPECT_EQ(refusal("  "),
            where + ": cannot understand \"\": it is empty." + advice);
}

TEST(TimeFunction, NotFinite)
{
  const TimeFunction function("1/(t-0.5)", where);
  EXPECT_DOUBLE_EQ(function(1), 2);
  EXPECT_EQ(message_of<RunError>([&] { function(0.5); }),
            where +
              ": \"1/(t-0.5)\" is inf at t = 0.5 s. Change the expression so "
              "that it is finite during the whole run.");
  EXPECT_EQ(message_of<RunError>([] { TimeFunction("sqrt(-1-t)", where)(0); }),
            where +
              ": \"sqrt(-1-t)\" is nan at t = 0 s. Change the expression so "
              "that it is finite during the whole run.");
}

TEST(TimeFunction, Table)
{
  const TableFile    file("time [s],pressure [Pa]\n0,0\n2,10\n");
  const TimeFunction function(file.path, where, "Pa");
  EXPECT_DOUBLE_EQ(function(0.5), 2.5);
}

TEST(TimeTable, Interpolates)
{
  const TableFile file("\xEF\xBB\xBF# a comment\r\n\r\n"
                       "time [s], pressure [MPa] # more\r\n"
                       " 1 , -4 \r\n2,6\r\n#3,7\r\n4,1.5e1");
  const TimeTable table(file.path, where);
  EXPECT_EQ(table(-1), -4);
  EXPECT_EQ(table(1), -4);
  EXPECT_DOUBLE_EQ(table(1.25), -1.5);
  EXPECT_EQ(table(2), 6);
  EXPECT_DOUBLE_EQ(table(3), 10.5);
  EXPECT_EQ(table(4), 15);
  EXPECT_EQ(table(100), 15);
}

TEST(TimeTable, OneRowIsAConstant)
{
  const TableFile file("t [s],p [Pa]\n1,3\n");
  const TimeTable table(file.path, where);
  EXPECT_EQ(table(0), 3);
  EXPECT_EQ(table(2), 3);
}

TEST(TimeTable, MissingFile)
{
  const TemporaryDirectory directory;
  EXPECT_EQ(
    message_of<InputError>([&] { TimeFunction(directory / "no.CSV", where); }),
    where + ": cannot read the table " + (directory / "no.CSV") +
      ": No such file or directory. Check the name; it is relative to "
      "the folder of the .prm.");
  EXPECT_EQ(message_of<InputError>([&] { TimeTable(directory.path, where); }),
            where + ": cannot read the table " + directory.path +
              ": Is a directory. Check the name; it is relative to the folder "
              "of the .prm.");
}

TEST(TimeTable, NoRows)
{
  for (const char *content : {"", "time [s],p [Pa]\n", "# nothing\n\n"})
    {
      const TableFile file(content);
      EXPECT_EQ(message_of<InputError>([&] { TimeTable(file.path, where); }),
                where + ": the table " + file.path +
                  " has no rows. Give a header and at least one row of time "
                  "and value.");
    }
}

TEST(TimeTable, NoHeader)
{
  for (const std::string header : {"0,0", "time,pressure", "time [s],[]"})
    EXPECT_EQ(table_refusal("# c\n" + header + "\n1,1\n"),
              "line 2: found \"" + header +
                "\" instead of a header. The first line must name both columns "
                "with their units in brackets, such as \"time [s],value "
                "[Pa]\".");
}

TEST(TimeTable, WrongUnits)
{
  EXPECT_EQ(table_refusal("time [us],p [Pa]\n0,0\n"),
            "line 1: the unit of column 1 is [us], but must be [s]. Convert "
            "the numbers and write the header as \"time [s],value [Pa]\".");
  EXPECT_EQ(table_refusal("time [s],v [mm/s]\n0,0\n", "m/s"),
            "line 1: the unit of column 2 is [mm/s], but must be [m/s]. "
            "Convert the numbers and write the header as \"time [s],value "
            "[m/s]\".");
}

TEST(TimeTable, NotANumber)
{
  EXPECT_EQ(table_refusal("t [s],p [Pa]\n0,0\n1e-6,2 MPa\n"),
            "line 3: column 2 holds \"2 MPa\", which is not a finite number. "
            "Write it like 1.5e-6, with a point and without its unit.");
  for (const std::string text : {"nan", "inf", "-inf", "1e999", "", "1d5"})
    EXPECT_EQ(table_refusal("t [s],p [Pa]\n" + text + ",0\n"),
              "line 2: column 1 holds \"" + text +
                "\", which is not a finite number. Write it like 1.5e-6, with "
                "a point and without its unit.");
}

TEST(TimeTable, NotIncreasing)
{
  EXPECT_EQ(table_refusal("t [s],p [Pa]\n0,0\n2e-6,0\n\n1e-6,1\n"),
            "line 5: time 1e-06 s is not larger than 2e-06 s in line 3. Times "
            "must increase from row to row; give a jump two times that differ "
            "a little.");
  EXPECT_EQ(table_refusal("t [s],p [Pa]\n1,0\n1,1\n").substr(0, 38),
            "line 3: time 1 s is not larger than 1 ");
}

TEST(TimeTable, WrongNumberOfColumns)
{
  EXPECT_EQ(table_refusal("t [s],p [Pa]\n0,0,0\n"),
            "line 2: found 3 columns in \"0,0,0\". A row has two, time and "
            "value, with a comma between them.");
  EXPECT_EQ(table_refusal("t [s];p [Pa]\n0;0\n"),
            "line 1: found 1 column in \"t [s];p [Pa]\". A row has two, time "
            "and value, with a comma between them.");
}
