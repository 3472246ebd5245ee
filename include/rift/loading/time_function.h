#ifndef rift_loading_time_function_h
#define rift_loading_time_function_h

#include <functional>
#include <string>

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

  private:
    std::string                   text;
    std::string                   where;
    std::function<double(double)> function;
  };
} // namespace rift

#endif
