#ifndef rift_time_integration_time_parameters_h
#define rift_time_integration_time_parameters_h

#include <rift/base/parameter_errors.h>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /** Subsection `Time` of the .prm. */
  struct TimeParameters
  {
    /** The run ends here, s. */
    double end_time = 0;

    /** Fixed time step, s; 0: the safe bound times the safety factor. */
    double time_step = 0;

    /** Fraction of the safe bound that an automatic step takes. */
    double safety_factor = 0.7;

    /**
     * The run is stopped when the residual of the energy ledger exceeds this
     * fraction of the energy that has been put in.
     */
    double largest_residual = 0.1;

    /** Declares the entries of subsection Time. */
    static void
    declare(dealii::ParameterHandler &prm);

    /**
     * Reads subsection Time. Throws ParameterError if the time step is neither
     * `auto` nor a positive number.
     */
    static TimeParameters
    parse(dealii::ParameterHandler &prm);

    /**
     * Throws ParameterError for an end time that is not positive, a time step
     * beyond it, a safety factor outside (0, 1], a residual that is not
     * positive.
     */
    void
    check() const;

    /** What has no effect with a fixed time step. */
    std::vector<InertEntries>
    inert_entries() const;
  };
} // namespace rift

#endif
