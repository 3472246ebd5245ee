#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>
#include <rift/time_integration/time_parameters.h>

namespace rift
{
  namespace
  {
    const char *const section = "Time";

    // 0 stands for an automatic time step.
    double
    parse_time_step(const std::string &text)
    {
      const std::string advice =
        "this should be auto or a number greater than zero. Units: s.";
      if (text == "auto")
        return 0;
      if (!dealii::Patterns::Double().match(text))
        throw ParameterError(section, "Time step", advice);
      const double time_step = dealii::Utilities::string_to_double(text);
      if (!(time_step > 0))
        throw ParameterError(section, "Time step", advice);
      return time_step;
    }
  } // namespace

  void
  TimeParameters::declare(dealii::ParameterHandler &prm)
  {
    const TimeParameters defaults;
    prm.enter_subsection(section);
    declare_number(prm,
                   "End time",
                   defaults.end_time,
                   "The run ends here. Must be set. Units: s.");
    prm.declare_entry("Time step",
                      "auto",
                      dealii::Patterns::Anything(),
                      "A fixed time step, or auto: the bound of stability "
                      "times the safety factor. Units: s.");
    declare_number(prm,
                   "Safety factor",
                   defaults.safety_factor,
                   "Part of the bound of stability that an automatic time "
                   "step takes, at most 1. Units: 1.");
    declare_number(prm,
                   "Largest energy residual",
                   defaults.largest_residual,
                   "The run is stopped when the energy balance is wrong by "
                   "more than this part of the energy in play. Units: 1.");
    prm.leave_subsection();
  }

  TimeParameters
  TimeParameters::parse(dealii::ParameterHandler &prm)
  {
    TimeParameters result;
    prm.enter_subsection(section);
    result.end_time         = prm.get_double("End time");
    result.time_step        = parse_time_step(prm.get("Time step"));
    result.safety_factor    = prm.get_double("Safety factor");
    result.largest_residual = prm.get_double("Largest energy residual");
    prm.leave_subsection();
    return result;
  }

  void
  TimeParameters::check() const
  {
    if (!(end_time > 0))
      throw ParameterError(section,
                           "End time",
                           "this must be greater than zero. Units: s.");
    if (time_step > end_time)
      throw ParameterError(section,
                           "Time step",
                           "this is more than the end time, " +
                             short_text(end_time) +
                             " s. Is one of the two in another unit? rift "
                             "uses s.");
    if (!(safety_factor > 0 && safety_factor <= 1))
      throw ParameterError(section,
                           "Safety factor",
                           "this must be greater than 0 and at most 1.");
    if (!(largest_residual > 0))
      throw ParameterError(section,
                           "Largest energy residual",
                           "this must be greater than zero.");
  }

  std::vector<InertEntries>
  TimeParameters::inert_entries() const
  {
    if (time_step == 0)
      return {};
    return {{section,
             {"Safety factor"},
             {{section, "Time step"}},
             "on a fixed time step"}};
  }
} // namespace rift
