#ifndef rift_loading_time_table_h
#define rift_loading_time_table_h

#include <string>
#include <vector>

namespace rift
{
  /**
   * A function of time given by points in a .csv file, with straight lines
   * between them. Before the first time it has the first value and after the
   * last time the last value, so that a pulse should begin and end with a row
   * of value 0.
   *
   * The file has a header with the two columns' names and units in brackets,
   * then one row for each point, in ascending time; empty lines and what
   * follows a `#` are skipped:
   * @code
   *   # surrogate of the measured pulse
   *   time [s],pressure [Pa]
   *   0,0
   *   1e-5,2.5e7
   *   3e-5,0
   * @endcode
   */
  class TimeTable
  {
  public:
    /**
     * Reads the file.
     *
     * @param path  of the file.
     * @param where what the table is for, as messages say it: "Boundary
     *   loaded / Pressure".
     * @param unit  which the second column must have, such as "Pa"; empty: not
     *   checked. The first column must be in "s".
     *
     * @throws InputError, with the line, if the file cannot be read, has no
     *   header or no rows, or has a row that is not two finite numbers or
     *   whose time is not larger than that of the row before.
     */
    TimeTable(const std::string &path,
              const std::string &where,
              const std::string &unit = "");

    /** The value at time t, s. */
    double
    operator()(double t) const;

    /**
     * The mean from `centre - width/2` to `centre + width/2`, s: the exact
     * integral over the width. Where no row lies inside of this interval, the
     * table is linear there, and this is the value at the centre to the last
     * bit.
     */
    double
    mean(double centre, double width) const;

    /** The times of all rows, s, ascending. */
    const std::vector<double> &
    row_times() const
    {
      return times;
    }

  private:
    std::vector<double> times;
    std::vector<double> values;
  };
} // namespace rift

#endif
