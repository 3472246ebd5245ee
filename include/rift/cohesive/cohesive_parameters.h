#ifndef rift_cohesive_cohesive_parameters_h
#define rift_cohesive_cohesive_parameters_h

#include <rift/base/parameter_errors.h>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /** The cohesive zone model: subsection `Fracture` of the .prm. */
  struct CohesiveParameters
  {
    enum class Model
    {
      none,
      extrinsic
    };

    Model model = Model::none;

    /**
     * Slope of the elastic branch and of the penalty against overlap, as a
     * fraction of what the cells beside a face bear: a cohesive face raises
     * the square of the largest frequency of a cell by this factor.
     */
    double stiffness_factor = 0.25;

    /** Start of the random numbers of the Weibull scatter. */
    unsigned int seed = 1;

    /** Declares the entries of subsection Fracture. */
    static void
    declare(dealii::ParameterHandler &prm);

    /** Reads subsection Fracture. */
    static CohesiveParameters
    parse(dealii::ParameterHandler &prm);

    /** Throws ParameterError for a stiffness factor that is not positive. */
    void
    check() const;

    /** What has no effect without a model. */
    std::vector<InertEntries>
    inert_entries() const;
  };
} // namespace rift

#endif
