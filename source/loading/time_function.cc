#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/loading/time_function.h>
#include <rift/loading/time_table.h>

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>

namespace rift
{
  namespace
  {
    /** muParser and the variable that its expression reads. */
    struct Expression
    {
      double     t = 0;
      mu::Parser parser;
    };

    [[noreturn]] void
    refuse(const std::string &text,
           const std::string &where,
           const std::string &reason)
    {
      throw InputError(where + ": cannot understand \"" + text +
                       "\": " + reason +
                       " Write an expression in the time t in seconds, such "
                       "as \"1e6*sin(2*pi*t/1e-3)\", or the name of a .csv "
                       "table.");
    }

    bool
    names_a_table(const std::string &text)
    {
      if (text.size() < 4)
        return false;
      std::string ending = text.substr(text.size() - 4);
      for (char &c : ending)
        c = std::tolower(static_cast<unsigned char>(c));
      return ending == ".csv";
    }

    /** An assignment such as `t = 3` would change the time itself. */
    void
    check_no_assignment(const std::string &text, const std::string &where)
    {
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '=')
          {
            const bool after_comparison =
              i > 0 &&
              std::string("<>!").find(text[i - 1]) != std::string::npos;
            const bool doubled = i + 1 < text.size() && text[i + 1] == '=';
            if (!after_comparison && !doubled)
              refuse(text,
                     where,
                     "it assigns a value at position " + std::to_string(i) +
                       "; a comparison is ==.");
            if (doubled)
              ++i;
          }
    }

    std::function<double(double)>
    parse(const std::string &text, const std::string &where)
    {
      check_no_assignment(text, where);
      const auto expression = std::make_shared<Expression>();
      try
        {
          expression->parser.DefineVar("t", &expression->t);
          expression->parser.DefineConst("pi", std::acos(-1.0));
          expression->parser.SetExpr(text);

          // muParser looks at the text when it is first evaluated.
          int n_results = 0;
          expression->parser.Eval(n_results);
          if (n_results != 1)
            refuse(text,
                   where,
                   "it has " + std::to_string(n_results) +
                     " values, separated by commas, instead of one.");
        }
      catch (const mu::ParserError &error)
        {
          std::string reason = error.GetMsg();
          const auto  position =
            std::min<std::size_t>(error.GetPos(), text.size());
          if (reason.find("position") == std::string::npos)
            reason += " at position " + std::to_string(position);
          refuse(text, where, reason + (reason.back() == '.' ? "" : "."));
        }
      return [expression](const double t) {
        expression->t = t;
        return expression->parser.Eval();
      };
    }
  } // namespace

  TimeFunction::TimeFunction(const std::string &text,
                             const std::string &where,
                             const std::string &unit)
    : text(trim(text))
    , where(where)
  {
    if (this->text.empty())
      refuse(this->text, where, "it is empty.");
    if (names_a_table(this->text))
      {
        table    = std::make_shared<TimeTable>(this->text, where, unit);
        function = [table = table](const double t) { return (*table)(t); };
      }
    else
      function = parse(this->text, where);
  }

  double
  TimeFunction::operator()(const double t) const
  {
    const double value = function(t);
    if (!std::isfinite(value))
      throw RunError(where + ": \"" + text + "\" is " + to_text(value) +
                     " at t = " + to_text(t) +
                     " s. Change the expression so that it is finite during "
                     "the whole run.");
    return value;
  }

  double
  TimeFunction::mean_around(const double t, const double time_step) const
  {
    if (!table)
      return (*this)(t);
    return t > 0 ? table->mean(t, time_step) :
                   table->mean(t + .25 * time_step, .5 * time_step);
  }

  double
  TimeFunction::mean_after(const double t, const double time_step) const
  {
    const double middle = t + .5 * time_step;
    return table ? table->mean(middle, time_step) : (*this)(middle);
  }
} // namespace rift
