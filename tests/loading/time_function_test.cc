#include <rift/base/exceptions.h>
#include <rift/loading/time_function.h>
#include <rift/loading/time_table.h>

#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <cmath>
#include <random>

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

TEST(TimeTable, MeanIsTheValueAtTheCentreWhereNoRowLiesInside)
{
  const TableFile file("t [s],p [Pa]\n0,.1\n1,.7\n3,-.2\n");
  const TimeTable table(file.path, where);
  for (const auto &[centre, width] :
       std::vector<std::pair<double, double>>{{-1, 2},
                                              {.3, .6},
                                              {.7, .1},
                                              {1.95, 1.8},
                                              {2, 2},
                                              {2.9, .1},
                                              {5, 4}})
    EXPECT_EQ(table.mean(centre, width), table(centre)) << centre;
  EXPECT_EQ(table.mean(1, 0), .7);
}

TEST(TimeTable, MeanIsTheIntegralOverTheWidth)
{
  const TableFile file("t [s],p [Pa]\n0,0\n1,6\n3,-2\n3.5,1\n");
  const TimeTable table(file.path, where);
  // 3 under the first line, 4 under the second, -.25 under the third.
  EXPECT_DOUBLE_EQ(table.mean(1.75, 3.5), 6.75 / 3.5);
  EXPECT_DOUBLE_EQ(table.mean(1.75, 3.7), (6.75 + .1) / 3.7);
  EXPECT_DOUBLE_EQ(table.mean(1, .5), (5.25 / 4 + 5.5 / 4) / .5);
  EXPECT_DOUBLE_EQ(table.mean(-1, 4), .5 * 6 / 4 * 1);
  EXPECT_DOUBLE_EQ(table.mean(5, 4), (1 * 3.5 + .5 * .5 * (-2 + 1)) / 4);

  // Of any division of time, the sum.
  std::mt19937                           random(1);
  std::uniform_real_distribution<double> width(.001, 1);
  double                                 time = -1, integral = 0;
  while (time < 5)
    {
      const double step = width(random);
      integral += step * table.mean(time + .5 * step, step);
      time += step;
    }
  EXPECT_NEAR(integral, 6.75 + (time - 3.5), 1e-13);
}

TEST(TimeFunction, TablesActWithTheirMeanAndExpressionsAtOneTime)
{
  const TableFile    file("t [s],p [Pa]\n0,0\n1e-8,1e9\n2e-8,0\n");
  const TimeFunction table(file.path, where, "Pa");
  // The force at the start acts for half a step.
  EXPECT_DOUBLE_EQ(.5 * 5.4e-7 * table.mean_around(0, 5.4e-7), 10);
  EXPECT_EQ(table.mean_around(5.4e-7, 5.4e-7), 0);
  EXPECT_DOUBLE_EQ(3e-8 * table.mean_around(1e-8, 3e-8), 10);
  EXPECT_DOUBLE_EQ(5.4e-7 * table.mean_after(0, 5.4e-7), 10);
  EXPECT_EQ(table.mean_after(2e-8, 1e-8), 0);
  EXPECT_EQ(table.mean_after(3e-9, 0), table(3e-9));

  const TimeFunction expression("1e3 + 2*t", where);
  EXPECT_EQ(expression.mean_around(0, 4), 1e3);
  EXPECT_EQ(expression.mean_around(3, 4), 1006);
  EXPECT_EQ(expression.mean_after(3, 4), 1010);
  EXPECT_EQ(expression.mean_after(3, 0), 1006);
}

namespace
{
  std::string
  half_sine(const double length)
  {
    const std::string l = std::to_string(length);
    return "t < " + l + " ? 3*sin(pi*t/" + l + ") : 0";
  }
} // namespace

TEST(UnresolvedShare, OfPulsesOfSomeSteps)
{
  // Before a long rest, for which the mean is next to nothing. Lines between
  // n + 1 points of a half sine leave 1 - pi/(2n) cot(pi/(2n)) of its area.
  for (const unsigned int n : {2, 3, 4, 10, 40})
    {
      const double angle = M_PI / (2 * n);
      EXPECT_NEAR(TimeFunction(half_sine(n), where).unresolved_share(1, 1000),
                  1 - angle / std::tan(angle),
                  4e-3)
        << n;
    }
}

TEST(UnresolvedShare, OfTablesIsThatOfTheExpression)
{
  const TableFile    file("t [s],p [Pa]\n.1,0\n3.5,3\n3.7,-1\n7,-1\n");
  const TimeFunction table(file.path, where);
  const TimeFunction expression("t < .1 ? 0 : t < 3.5 ? 3*(t-.1)/3.4 : "
                                "t < 3.7 ? 3-20*(t-3.5) : -1",
                                where);
  EXPECT_GT(table.unresolved_share(1, 8), .1);
  EXPECT_LT(table.unresolved_share(.01, 800), .01);
  for (const unsigned int n : {8, 20, 100})
    EXPECT_NEAR(table.unresolved_share(8. / n, n),
                expression.unresolved_share(8. / n, n),
                2e-3);
}

TEST(UnresolvedShare, OfWhatNoStepSees)
{
  // An oscillation of one period in each step, in many steps; a spike upon a
  // load that stays.
  EXPECT_GT(TimeFunction("sin(2*pi*t)", where).unresolved_share(1, 100), .9);
  EXPECT_GT(TimeFunction("sin(2*pi*t)", where).unresolved_share(1, 1e9), .9);
  const TableFile spike("t [s],p [Pa]\n0,1e6\n3.3,1e6\n3.4,1e8\n3.5,1e6\n");
  EXPECT_GT(TimeFunction(spike.path, where).unresolved_share(1, 1e6), .9);
}

TEST(UnresolvedShare, OfConstantsAndLinesIsNothing)
{
  EXPECT_EQ(TimeFunction("0", where).unresolved_share(1, 100), 0);
  EXPECT_EQ(
    TimeFunction("1e6*(sin(t)^2+cos(t)^2)", where).unresolved_share(1, 100),
    0);
  EXPECT_LT(TimeFunction("3-7*t", where).unresolved_share(1, 100), 1e-14);
  const TableFile file("t [s],p [Pa]\n0,4\n5,4\n6,4\n");
  EXPECT_EQ(TimeFunction(file.path, where).unresolved_share(1, 100), 0);
}

TEST(UnresolvedShare, Doubt)
{
  const std::string pulse = half_sine(2);
  EXPECT_EQ(TimeFunction(pulse, where).warning(.1, 1000), "");
  const std::string found = TimeFunction(pulse, where).warning(1, 1000);
  EXPECT_EQ(found.substr(0, 120),
            (where + ": \"" + pulse +
             "\" changes too fast for the time step "
             "of 1 s: straight lines between its values at the steps miss ")
              .substr(0, 120));
  EXPECT_NE(found.find(" % of its variation. It acts with its values at the "
                       "steps, so that its integral may be wrong. Set a "
                       "smaller \"Time step\", or give a table, which acts "
                       "with its mean over each step."),
            std::string::npos);

  const TableFile file("t [s],p [Pa]\n0,0\n.25,1\n.5,0\n");
  EXPECT_EQ(TimeFunction(file.path, where).warning(1, 1000),
            where + ": \"" + file.path +
              "\" changes too fast for the time step of 1 s: straight lines "
              "between its values at the steps miss 100.1 % of its variation. "
              "It acts with its mean over each step, so that its integral is "
              "right; set a smaller \"Time step\" if its course matters.");
  // What is not finite is said when it is met.
  EXPECT_EQ(TimeFunction("1/(t-0.5)", where).warning(.1, 10), "");
  EXPECT_EQ(TimeFunction("sqrt(-1-t)", where).warning(.1, 10), "");
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
