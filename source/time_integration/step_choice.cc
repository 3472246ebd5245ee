#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/base/parameter_text.h>
#include <rift/time_integration/step_choice.h>

#include <cmath>

namespace rift
{
  namespace
  {
    /** No body stands a step above the bound by this. */
    constexpr double largest_step_over_bound = 10;

    /** More are worth a warning. */
    constexpr double usual_number_of_steps = 1e7;

    /** Below this, few cells make the run ten times as long. */
    constexpr double least_step_over_mean = .1;

    /** Years of computing; more is a mistake in the scene. */
    constexpr double largest_number_of_steps = 1e12;
  } // namespace

  StepChoice
  choose_steps(const TimeParameters       &parameters,
               const CriticalTimeStep     &critical,
               const std::optional<double> of_checkpoint)
  {
    const bool is_automatic = parameters.time_step == 0;
    double     time_step    = is_automatic ?
                                parameters.safety_factor * critical.time_step :
                                parameters.time_step;
    time_step               = of_checkpoint.value_or(time_step);
    // A little tolerance, so that rounding does not add a step.
    const double n_steps =
      std::ceil(parameters.end_time / time_step * (1 - 1e-12));
    if (!(time_step > 0 && n_steps > 0 && n_steps <= largest_number_of_steps))
      throw InputError(
        "to come to the end time of " + to_text(parameters.end_time) +
        " s in steps of " + to_text(time_step) + " s takes " +
        to_text(n_steps) + " steps; rift counts to " +
        to_text(largest_number_of_steps) +
        ". Look at the end time, the time step, the stiffness factor, the "
        "cohesive penalty and the viscosities.");
    const auto last_step = static_cast<std::uint64_t>(n_steps);
    if (is_automatic && !of_checkpoint)
      time_step = parameters.end_time / last_step;
    if (time_step > largest_step_over_bound * critical.time_step)
      throw InputError("the time step of " + to_text(time_step) + " s is " +
                       short_text(time_step / critical.time_step) +
                       " times the bound at which it is sure to be stable, " +
                       short_text(critical.time_step) +
                       " s. Set \"Time step = auto\" in subsection Time.");
    return {time_step, last_step};
  }

  std::vector<std::string>
  warnings(const StepChoice &choice, const CriticalTimeStep &critical)
  {
    std::vector<std::string> result;
    if (choice.last_step > usual_number_of_steps)
      result.push_back("these are many steps. Is the end time in seconds?");
    if (critical.time_step < least_step_over_mean * critical.mean_time_step)
      result.push_back(
        "the smallest or flattest cell, " +
        std::to_string(critical.smallest_cell) + " of the mesh, allows " +
        short_text(critical.time_step / critical.mean_time_step) +
        " times the time step that cells allow on average, so that the run "
        "takes so many more steps. Is it a sliver? Try another \"Element "
        "size\", or \"Mesh.Algorithm3D = 10;\" in the .geo.");
    if (choice.time_step > critical.time_step)
      result.push_back("the time step is above the bound at which it is sure "
                       "to be stable");
    return result;
  }
} // namespace rift
