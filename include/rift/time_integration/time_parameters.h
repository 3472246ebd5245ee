#ifndef rift_time_integration_time_parameters_h
#define rift_time_integration_time_parameters_h

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
  };
} // namespace rift

#endif
