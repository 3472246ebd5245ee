#ifndef rift_time_integration_step_choice_h
#define rift_time_integration_step_choice_h

#include <rift/time_integration/critical_time_step.h>
#include <rift/time_integration/time_parameters.h>

#include <cstdint>
#include <optional>

namespace rift
{
  /** The time steps of a run. */
  struct StepChoice
  {
    /** s */
    double time_step;

    /** Number of the step at the end time. */
    std::uint64_t last_step;
  };

  /**
   * Chooses the time step: that of the scene or, if it gives none, the safe one
   * made a little shorter, so that the end time is met.
   *
   * @param of_checkpoint with which the run has begun; it is kept, so that the
   *   end is met to one step only.
   * @throws InputError where no number of steps leads to the end, and for a
   *   step that is far above the bound.
   */
  StepChoice
  choose_steps(const TimeParameters   &parameters,
               const CriticalTimeStep &critical,
               std::optional<double>   of_checkpoint);

  /** What may not be meant about the choice, for warnings. */
  std::vector<std::string>
  warnings(const StepChoice &choice, const CriticalTimeStep &critical);
} // namespace rift

#endif
