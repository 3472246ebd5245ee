#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/cohesive/cohesive_parameters.h>

namespace rift
{
  namespace
  {
    const char *const section = "Fracture";
  }

  void
  CohesiveParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    const CohesiveParameters defaults;
    prm.enter_subsection(section);
    prm.declare_entry("Cohesive model",
                      "none",
                      Patterns::Selection("none|extrinsic"),
                      "none: nothing breaks, strengths and fracture energies "
                      "of the materials are not used. extrinsic: cohesive "
                      "elements are inserted where the stress on a face "
                      "reaches the strength.");
    declare_number(prm,
                   "Stiffness factor",
                   defaults.stiffness_factor,
                   "Room that the automatic time step leaves for cohesive "
                   "elements: the square of the largest frequency of a loose "
                   "cell may grow by three times this factor. Elastic branches "
                   "and penalties against overlap are as stiff as that allows; "
                   "the time step falls with 1/sqrt(1 + 3 factor). Units: 1.");
    prm.declare_entry("Seed",
                      std::to_string(defaults.seed),
                      Patterns::Integer(0),
                      "Start of the random numbers of the Weibull scatter: "
                      "the same seed gives the same strengths.");
    prm.leave_subsection();
  }

  CohesiveParameters
  CohesiveParameters::parse(dealii::ParameterHandler &prm)
  {
    CohesiveParameters result;
    prm.enter_subsection(section);
    result.model =
      prm.get("Cohesive model") == "extrinsic" ? Model::extrinsic : Model::none;
    result.stiffness_factor = prm.get_double("Stiffness factor");
    result.seed = static_cast<unsigned int>(prm.get_integer("Seed"));
    prm.leave_subsection();
    return result;
  }

  void
  CohesiveParameters::check() const
  {
    if (!(stiffness_factor > 0))
      throw ParameterError(section,
                           "Stiffness factor",
                           "this must be greater than zero.");
  }

  std::vector<InertEntries>
  CohesiveParameters::inert_entries() const
  {
    if (model != Model::none)
      return {};
    return {{section,
             {"Stiffness factor", "Seed"},
             {{section, "Cohesive model"}},
             "without a cohesive model"}};
  }
} // namespace rift
