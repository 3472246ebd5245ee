#ifndef rift_io_checkpoint_parameters_h
#define rift_io_checkpoint_parameters_h

#include <rift/base/parameter_errors.h>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /** Subsection `Checkpoint` of the .prm. */
  struct CheckpointParameters
  {
    /** A set is written each time that so many steps are done; 0: never. */
    unsigned int interval_in_steps = 0;

    /** A set is written when the last is so old, min of wall time; 0: never. */
    double interval_in_minutes = 0;

    /** How many of the newest sets are kept, at least 1. */
    unsigned int n_sets = 2;

    /** Declares the entries of subsection Checkpoint. */
    static void
    declare(dealii::ParameterHandler &prm);

    /** Reads subsection Checkpoint. */
    static CheckpointParameters
    parse(dealii::ParameterHandler &prm);

    /** Throws ParameterError for a negative interval. */
    void
    check() const;
  };
} // namespace rift

#endif
