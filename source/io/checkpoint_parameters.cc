#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/io/checkpoint_parameters.h>

namespace rift
{
  namespace
  {
    const char *const section = "Checkpoint";
  }

  void
  CheckpointParameters::declare(dealii::ParameterHandler &prm)
  {
    const CheckpointParameters defaults;
    prm.enter_subsection(section);
    prm.declare_entry("Interval in steps",
                      std::to_string(defaults.interval_in_steps),
                      dealii::Patterns::Integer(0),
                      "A checkpoint is written each time that so many steps "
                      "are done; 0: none.");
    declare_number(prm,
                   "Interval in minutes",
                   defaults.interval_in_minutes,
                   "A checkpoint is written when so much time of the clock on "
                   "the wall has passed since the last; 0: none. Units: min.");
    prm.declare_entry("Number of sets",
                      std::to_string(defaults.n_sets),
                      dealii::Patterns::Integer(1),
                      "The newest checkpoints that are kept. With "
                      "more than one, a run can still go on when the files of "
                      "the newest are damaged.");
    prm.leave_subsection();
  }

  CheckpointParameters
  CheckpointParameters::parse(dealii::ParameterHandler &prm)
  {
    CheckpointParameters result;
    prm.enter_subsection(section);
    result.interval_in_steps =
      static_cast<unsigned int>(prm.get_integer("Interval in steps"));
    result.interval_in_minutes = prm.get_double("Interval in minutes");
    result.n_sets =
      static_cast<unsigned int>(prm.get_integer("Number of sets"));
    prm.leave_subsection();
    return result;
  }

  void
  CheckpointParameters::check() const
  {
    if (!(interval_in_minutes >= 0))
      throw ParameterError(section,
                           "Interval in minutes",
                           "this cannot be negative. Units: min.");
  }
} // namespace rift
