#ifndef rift_cohesive_cohesive_parameters_h
#define rift_cohesive_cohesive_parameters_h

#include <rift/base/parameter_errors.h>
#include <rift/cohesive/cohesive_model.h>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /** Stiffness of the intrinsic model: P_coh of the literature. */
  struct Penalty
  {
    /** Pa, or a multiple of Young's modulus. */
    double value;
    bool   is_multiple;
  };

  /** The cohesive zone model: subsection `Fracture` of the .prm. */
  struct CohesiveParameters
  {
    /** Which faces have an element, and from when. */
    using Model = CohesiveModel;

    /** The entry Cohesive model. */
    Model model = Model::none;

    /** The law that is not of faces but of planes through nodes. */
    static constexpr const char *bonds = "bonds";

    /** Bonds in the extrinsic model, faces in the intrinsic one. */
    static constexpr const char *automatic = "automatic";

    /** `automatic`, `bonds`, or the name of one of the CohesiveLaws. */
    std::string law = automatic;

    /** The law that acts: never `automatic` where something breaks. */
    std::string
    chosen_law() const;

    /**
     * Room that the time step leaves for cohesive faces: the square of the
     * largest frequency of a loose cell may grow by three times this factor,
     * one for each of the faces that meet at a corner. Elastic branches and
     * penalties against overlap are as stiff as that allows.
     */
    double stiffness_factor = 0.25;

    /** Of the intrinsic model. */
    Penalty penalty = {10, true};

    /** Start of the random numbers of the Weibull scatter. */
    unsigned int seed = 1;

    /** Declares the entries of subsection Fracture. */
    static void
    declare(dealii::ParameterHandler &prm);

    /** Reads subsection Fracture. */
    static CohesiveParameters
    parse(dealii::ParameterHandler &prm);

    /** Throws ParameterError for a law that does not serve the model and a
     * stiffness that is too small. */
    void
    check() const;

    /** What has no effect with this model. */
    std::vector<InertEntries>
    inert_entries() const;

  private:
    void
    check_law() const;
  };

  /** The name of a model as in the .prm. */
  std::string
  to_string(CohesiveParameters::Model model);
} // namespace rift

#endif
