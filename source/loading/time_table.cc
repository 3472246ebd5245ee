#include <rift/base/check.h>
#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/loading/time_table.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace rift
{
  namespace
  {
    /** One line without its comment, and where it stands, for messages. */
    struct Line
    {
      std::string      text;
      std::string_view cells[2];
      std::string      where;

      /** Finds the two cells. */
      void
      split()
      {
        const auto n_cells = 1 + std::count(text.begin(), text.end(), ',');
        if (n_cells != 2)
          throw InputError(where + "found " + std::to_string(n_cells) +
                           (n_cells == 1 ? " column" : " columns") + " in \"" +
                           text +
                           "\". A row has two, time and value, with a "
                           "comma between them.");
        const std::string_view view  = text;
        const auto             comma = view.find(',');
        cells[0]                     = trim(view.substr(0, comma));
        cells[1]                     = trim(view.substr(comma + 1));
      }
    };

    std::ifstream
    open_table(const std::string &path, const std::string &where)
    {
      // Opening a folder succeeds, and reading from it looks like an empty
      // file.
      std::error_code ignored;
      const bool      is_folder = std::filesystem::is_directory(path, ignored);
      errno                     = 0;
      std::ifstream file(path);
      if (is_folder || !file)
        throw InputError(where + ": cannot read the table " + path + ": " +
                         std::strerror(is_folder ? EISDIR : errno) +
                         ". Check the name; it is relative to the folder of "
                         "the .prm.");
      return file;
    }

    /** The text in the brackets of a header's cell; empty if there is none. */
    std::string_view
    unit_of(const std::string_view cell)
    {
      const auto open = cell.rfind('['), close = cell.rfind(']');
      if (open == std::string_view::npos || close == std::string_view::npos ||
          close < open)
        return {};
      return trim(cell.substr(open + 1, close - open - 1));
    }

    void
    check_header(const Line &line, const std::string &unit)
    {
      const std::string example =
        "\"time [s],value [" + (unit.empty() ? "Pa" : unit) + "]\"";
      if (unit_of(line.cells[0]).empty() || unit_of(line.cells[1]).empty())
        throw InputError(line.where + "found \"" + line.text +
                         "\" instead of a header. The first line must name "
                         "both columns with their units in brackets, such "
                         "as " +
                         example + ".");

      const std::string expected[2] = {"s", unit};
      for (unsigned int i = 0; i < 2; ++i)
        if (!expected[i].empty() && unit_of(line.cells[i]) != expected[i])
          throw InputError(
            line.where + "the unit of column " + std::to_string(i + 1) +
            " is [" + std::string(unit_of(line.cells[i])) + "], but must be [" +
            expected[i] + "]. Convert the numbers and write the header as " +
            example + ".");
    }

    double
    number_in(const Line &line, const unsigned int i)
    {
      double value = 0;
      if (!from_text(line.cells[i], value) || !std::isfinite(value))
        throw InputError(line.where + "column " + std::to_string(i + 1) +
                         " holds \"" + std::string(line.cells[i]) +
                         "\", which is not a finite number. Write it like "
                         "1.5e-6, with a point and without its unit.");
      return value;
    }
  } // namespace

  TimeTable::TimeTable(const std::string &path,
                       const std::string &where,
                       const std::string &unit)
  {
    std::ifstream file           = open_table(path, where);
    bool          header_is_read = false;
    unsigned int  line_of_time   = 0;
    std::string   text;
    for (unsigned int number = 1; std::getline(file, text); ++number)
      {
        // Some programs mark a file as UTF-8 by three bytes at its start.
        if (number == 1 && text.compare(0, 3, "\xEF\xBB\xBF") == 0)
          text.erase(0, 3);

        Line line;
        line.text = std::string(trim(text.substr(0, text.find('#'))));
        line.where =
          where + ": table " + path + ", line " + std::to_string(number) + ": ";
        if (line.text.empty())
          continue;
        line.split();

        if (!header_is_read)
          {
            check_header(line, unit);
            header_is_read = true;
            continue;
          }

        const double time = number_in(line, 0);
        if (!times.empty() && !(time > times.back()))
          throw InputError(line.where + "time " + to_text(time) +
                           " s is not larger than " + to_text(times.back()) +
                           " s in line " + std::to_string(line_of_time) +
                           ". Times must increase from row to row; give a "
                           "jump two times that differ a little.");
        times.push_back(time);
        values.push_back(number_in(line, 1));
        line_of_time = number;
      }
    if (file.bad())
      throw InputError(where + ": the table " + path +
                       " could not be read to its end. Check the disk.");
    if (times.empty())
      throw InputError(where + ": the table " + path +
                       " has no rows. Give a header and at least one row of "
                       "time and value.");
  }

  double
  TimeTable::operator()(const double t) const
  {
    const auto next = std::upper_bound(times.begin(), times.end(), t);
    if (next == times.begin())
      return values.front();
    if (next == times.end())
      return values.back();

    const auto   i = next - times.begin() - 1;
    const double s = (t - times[i]) / (times[i + 1] - times[i]);
    rift_check(s >= 0 && s <= 1);
    return (1 - s) * values[i] + s * values[i + 1];
  }

  double
  TimeTable::mean(const double centre, const double width) const
  {
    const double begin = centre - .5 * width, end = centre + .5 * width;
    auto         row  = std::upper_bound(times.begin(), times.end(), begin);
    const auto   last = std::lower_bound(times.begin(), times.end(), end);
    if (row >= last)
      return (*this)(centre);

    // The trapezoidal rule from row to row.
    double     integral = 0, time = begin, value = (*this)(begin);
    const auto go_to = [&](const double next_time, const double next_value) {
      integral += .5 * (next_time - time) * (value + next_value);
      time  = next_time;
      value = next_value;
    };
    for (; row != last; ++row)
      go_to(*row, values[row - times.begin()]);
    rift_check(begin <= time && time <= end);
    go_to(end, (*this)(end));
    return integral / width;
  }
} // namespace rift
