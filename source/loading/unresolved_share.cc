#include <rift/base/parameter_text.h>
#include <rift/loading/time_function.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    /** Values of an expression that are looked at, about. */
    constexpr std::uint64_t usual_number_of_values = 100000;

    /** In each step that is looked at. */
    constexpr std::uint64_t least_values = 8, most_values = 1000;

    /** A function that varies by less, relative to its mean, is a constant. */
    constexpr double smallest_variation = 1e-9;

    /** A larger share is worth a warning. */
    constexpr double largest_unresolved_share = .1;

    /** A stretch of time between two values of the function. */
    struct Piece
    {
      /** s */
      double length;

      /** The function at both ends, and how far that is from the straight line
       * between the values at the steps. */
      std::array<double, 2> values, missed;
    };

    /** Mean of |f| over a stretch in which f is linear, from its ends. */
    double
    mean_magnitude(const double a, const double b)
    {
      const double sum = std::abs(a) + std::abs(b);
      return a * b < 0 ? .5 * (a * a + b * b) / sum : .5 * sum;
    }

    /** Calls `visit` with the pieces from `begin` to `end`, the times of two
     * steps; `inner` are the times between which the function is looked at. */
    template <typename Function, typename Visit>
    void
    visit_step(const Function            &f,
               const double               begin,
               const double               end,
               const std::vector<double> &inner,
               const Visit               &visit)
    {
      const double at_begin = f(begin), at_end = f(end);
      double       time = begin, value = at_begin, missed = 0;
      const auto   go_to =
        [&](const double t, const double next, const double next_missed) {
          visit(Piece{t - time, {{value, next}}, {{missed, next_missed}}});
          time   = t;
          value  = next;
          missed = next_missed;
        };
      for (const double t : inner)
        {
          const double s = (t - begin) / (end - begin), next = f(t);
          go_to(t, next, next - ((1 - s) * at_begin + s * at_end));
        }
      go_to(end, at_end, 0);
    }

    /** The pieces of a table: nothing is missed in steps without a row. */
    template <typename Visit>
    void
    visit_table(const TimeTable &table,
                const double     time_step,
                const double     end,
                const Visit     &visit)
    {
      const std::vector<double> &rows = table.row_times();
      auto   row  = std::upper_bound(rows.begin(), rows.end(), 0.);
      double time = 0;
      while (row != rows.end() && *row < end)
        {
          const double n     = std::floor(*row / time_step);
          const double begin = std::min(n * time_step, *row);
          const double next  = (n + 1) * time_step;
          if (begin > time)
            visit_step(table, time, begin, {}, visit);
          std::vector<double> inner;
          for (; row != rows.end() && *row < next; ++row)
            inner.push_back(*row);
          visit_step(table, begin, next, inner, visit);
          time = next;
        }
      if (time < end)
        visit_step(table, time, end, {}, visit);
    }

    /** The pieces of an expression, in all steps or in some of very many. */
    template <typename Visit>
    void
    visit_expression(const std::function<double(double)> &f,
                     const double                         time_step,
                     const std::uint64_t                  n_steps,
                     const Visit                         &visit)
    {
      const std::uint64_t n_values =
        std::clamp(usual_number_of_values / n_steps, least_values, most_values);
      const std::uint64_t stride =
        1 + n_steps * least_values / usual_number_of_values;
      // Not at equal distances, between which all of an oscillation may lie.
      const double        golden_ratio = .5 * (std::sqrt(5.) - 1);
      double              offset       = 0;
      std::vector<double> inner(n_values);
      for (std::uint64_t step = 0; step < n_steps; step += stride)
        {
          for (std::uint64_t i = 0; i < n_values; ++i)
            {
              offset   = std::fmod(offset + golden_ratio, 1.);
              inner[i] = (step + (i + offset) / n_values) * time_step;
            }
          visit_step(f, step * time_step, (step + 1) * time_step, inner, visit);
        }
    }
  } // namespace

  double
  TimeFunction::unresolved_share(const double        time_step,
                                 const std::uint64_t n_steps) const
  {
    const auto visit_all = [&](const auto &visit) {
      if (table)
        visit_table(*table, time_step, n_steps * time_step, visit);
      else
        visit_expression(function, time_step, n_steps, visit);
    };
    double time = 0, integral = 0;
    visit_all([&](const Piece &piece) {
      time += piece.length;
      integral += .5 * piece.length * (piece.values[0] + piece.values[1]);
    });
    const double mean      = integral / time;
    double       variation = 0, missed = 0;
    visit_all([&](const Piece &piece) {
      variation += piece.length * mean_magnitude(piece.values[0] - mean,
                                                 piece.values[1] - mean);
      missed += piece.length * mean_magnitude(piece.missed[0], piece.missed[1]);
    });
    if (variation <= smallest_variation * std::abs(integral))
      return 0;
    // As far above the mean as below it.
    return missed / (.5 * variation);
  }

  std::string
  TimeFunction::warning(const double        time_step,
                        const std::uint64_t n_steps) const
  {
    const double share = unresolved_share(time_step, n_steps);
    if (!(share > largest_unresolved_share))
      return "";
    return where + ": \"" + text + "\" changes too fast for the time step of " +
           short_text(time_step) +
           " s: straight lines between its values at the steps miss " +
           short_text(100 * share) + " % of its variation. " +
           (table ? "It acts with its mean over each step, so that its "
                    "integral is right; set a smaller \"Time step\" if its "
                    "course matters." :
                    "It acts with its values at the steps, so that its "
                    "integral may be wrong. Set a smaller \"Time step\", or "
                    "give a table, which acts with its mean over each step.");
  }

  void
  add_doubts(const std::vector<TimeFunction> &functions,
             const double                     time_step,
             const std::uint64_t              n_steps,
             std::vector<std::string>        &warnings)
  {
    for (const TimeFunction &function : functions)
      if (const std::string warning = function.warning(time_step, n_steps);
          !warning.empty())
        warnings.push_back(warning);
  }
} // namespace rift
