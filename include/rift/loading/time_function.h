#ifndef rift_loading_time_function_h
#define rift_loading_time_function_h

#include <rift/loading/time_table.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rift
{
  /**
   * A number that depends on time, as a user writes it in a .prm: either an
   * expression in the time `t`, or the name of a .csv table (see TimeTable).
   *
   * Expressions are those of muParser: `+ - * / ^`, comparisons, `&&`, `||`,
   * `a ? b : c`, the functions sin, cos, tan, asin, acos, atan, atan2, sinh,
   * cosh, tanh, exp, ln, log10, log2, sqrt, abs, sign, rint, min, max, and the
   * constant `pi`. `t < 1e-5 ? 1e7*sin(pi*t/1e-5) : 0` is a half-sine pulse.
   *
   * Copies share what they evaluate: not to be called from several threads.
   */
  class TimeFunction
  {
  public:
    /**
     * @param text  an expression, or a path that ends in `.csv`.
     * @param where what the function is for, as messages say it: "Boundary
     *   loaded / Pressure".
     * @param unit  of the value, such as "Pa"; a table must have it in its
     *   header. Empty: not checked.
     *
     * @throws InputError if the expression cannot be understood, with
     *   muParser's reason and the position, or for what TimeTable says.
     */
    TimeFunction(const std::string &text,
                 const std::string &where,
                 const std::string &unit = "");

    /**
     * The value at time t, s.
     *
     * @throws RunError if it is not a finite number.
     */
    double
    operator()(double t) const;

    /**
     * What acts as a force at t_n, s: an expression with its value there, a
     * table with its mean over the time in which the force of the step acts,
     * from half a step before t_n to half a step after, and at the start over
     * the half step after t_0. So all rows of a table count, however close they
     * are.
     *
     * @throws RunError as operator().
     */
    double
    mean_around(double t, double time_step) const;

    /**
     * What is the velocity from t_n, s, to the end of the step: an expression
     * with its value in the middle, a table with its mean.
     *
     * @throws RunError as operator().
     */
    double
    mean_after(double t, double time_step) const;

    /**
     * How much of the function a run of `n_steps` steps does not see: the area
     * between it and straight lines between its values at the steps, over the
     * area between it and its mean, on one side of the mean. A pulse that falls
     * between two steps has 1, a half sine .2 in two steps and .05 in four. Not
     * a number if the function is not one somewhere. Of an expression, an
     * estimate from about 1e5 values.
     */
    double
    unresolved_share(double time_step, std::uint64_t n_steps) const;

    /** A sentence for the log if the steps do not see a tenth of the function
     * (see unresolved_share()), else empty. */
    std::string
    warning(double time_step, std::uint64_t n_steps) const;

    /** "Boundary loaded / Pressure" */
    const std::string &
    name() const
    {
      return where;
    }

    /** As the user has written it. */
    const std::string &
    expression() const
    {
      return text;
    }

  private:
    std::string                      text;
    std::string                      where;
    std::function<double(double)>    function;
    std::shared_ptr<const TimeTable> table;
  };

  /** Adds what TimeFunction::warning() says of some functions. */
  void
  add_doubts(const std::vector<TimeFunction> &functions,
             double                           time_step,
             std::uint64_t                    n_steps,
             std::vector<std::string>        &warnings);
} // namespace rift

#endif
