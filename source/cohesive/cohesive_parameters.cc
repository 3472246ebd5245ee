#include <deal.II/base/parameter_handler.h>

#include <rift/base/number_text.h>
#include <rift/base/parameter_declarations.h>
#include <rift/cohesive/cohesive_parameters.h>
#include <rift/cohesive/laws/all.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    const char *const section = "Fracture";

    /** In the order of CohesiveParameters::Model. */
    const std::vector<std::string> model_names = {"none",
                                                  "extrinsic",
                                                  "intrinsic"};

    /** All laws of a name. */
    struct NamedLaw
    {
      std::string                name, summary;
      std::vector<CohesiveModel> models;
    };

    template <typename... Laws>
    std::vector<NamedLaw>
    by_name(LawList<Laws...>)
    {
      std::vector<NamedLaw> result = {
        {CohesiveParameters::bonds,
         "cracks run along planes through nodes, and the traction on a plane "
         "is "
         "what holds its sides together, up to a Mohr-Coulomb envelope that "
         "softens; strength and fracture energy do not depend on the mesh",
         {CohesiveModel::extrinsic}}};
      for (const NamedLaw &law :
           {NamedLaw{Laws::name, Laws::summary, {Laws::model}}...})
        {
          const auto same = std::find_if(
            result.begin(),
            result.end(),
            [&law](const NamedLaw &other) { return other.name == law.name; });
          if (same == result.end())
            result.push_back(law);
          else
            same->models.push_back(law.models.front());
        }
      return result;
    }

    const std::vector<NamedLaw> laws = by_name(CohesiveLaws());

    bool
    serves(const NamedLaw &law, const CohesiveModel model)
    {
      return std::find(law.models.begin(), law.models.end(), model) !=
             law.models.end();
    }

    /** The law of a model where the scene chooses none. */
    std::string
    automatic_law(const CohesiveModel model)
    {
      CohesiveParameters parameters;
      parameters.model = model;
      return parameters.chosen_law();
    }

    /** "A|B|C": what "Cohesive law" can be. */
    std::string
    law_names()
    {
      std::string text = CohesiveParameters::automatic;
      for (const NamedLaw &law : laws)
        text += "|" + law.name;
      return text;
    }

    std::string
    description_of_laws()
    {
      std::string text =
        "What cracks follow, and how the traction between their sides follows "
        "the jump. automatic: " +
        automatic_law(CohesiveModel::extrinsic) + " in the extrinsic model, " +
        automatic_law(CohesiveModel::intrinsic) + " in the intrinsic one.";
      for (const NamedLaw &law : laws)
        {
          text += " " + law.name + " (";
          for (const CohesiveModel model : law.models)
            text +=
              (model == law.models.front() ? "" : ", ") + to_string(model);
          text += "): " + law.summary + ".";
        }
      return text;
    }

    /** "10 E" or a number in Pa. */
    Penalty
    read_penalty(const std::string &text)
    {
      std::string_view number = trim(text);
      Penalty          penalty{0, false};
      if (!number.empty() && number.back() == 'E')
        {
          penalty.is_multiple = true;
          number.remove_suffix(1);
        }
      if (!from_text(number, penalty.value))
        throw ParameterError(section,
                             "Cohesive penalty",
                             "this must be a multiple of Young's modulus, as "
                             "in \"10 E\", or a number in Pa.");
      return penalty;
    }
  } // namespace

  std::string
  to_string(const CohesiveParameters::Model model)
  {
    return model_names[static_cast<std::size_t>(model)];
  }

  void
  CohesiveParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    const CohesiveParameters defaults;
    prm.enter_subsection(section);
    prm.declare_entry("Cohesive model",
                      "none",
                      Patterns::Selection("none|extrinsic|intrinsic"),
                      "none: nothing breaks, strengths and fracture energies "
                      "of the materials are not used. extrinsic: cohesive "
                      "elements are inserted where the stress on a face "
                      "reaches the strength. intrinsic: all faces of "
                      "breakable materials have a cohesive element from the "
                      "start; it costs time and slows waves down, and is here "
                      "to be compared with.");
    prm.declare_entry("Cohesive law",
                      defaults.law,
                      Patterns::Selection(law_names()),
                      description_of_laws());
    declare_number(prm,
                   "Stiffness factor",
                   defaults.stiffness_factor,
                   "Room that the automatic time step leaves for cohesive "
                   "elements: the square of the largest frequency of a loose "
                   "cell may grow by three times this factor. Elastic branches "
                   "and penalties against overlap are as stiff as that allows; "
                   "the time step falls with 1/sqrt(1 + 3 factor). Units: 1.");
    prm.declare_entry("Cohesive penalty",
                      to_text(defaults.penalty.value) + " E",
                      Patterns::Anything(),
                      "Stiffness of the cohesive elements of the intrinsic "
                      "model before their strength is reached, over the "
                      "shortest edge of each: a multiple of Young's modulus "
                      "such as 10 E (of anisotropic materials that of the mean "
                      "over all directions; between two materials the softer "
                      "one counts), or a number in Pa. The time step falls "
                      "with one over its root.");
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
    result.model            = static_cast<Model>(std::find(model_names.begin(),
                                                model_names.end(),
                                                prm.get("Cohesive model")) -
                                      model_names.begin());
    result.law              = prm.get("Cohesive law");
    result.penalty          = read_penalty(prm.get("Cohesive penalty"));
    result.stiffness_factor = prm.get_double("Stiffness factor");
    result.seed = static_cast<unsigned int>(prm.get_integer("Seed"));
    prm.leave_subsection();
    return result;
  }

  void
  CohesiveParameters::check() const
  {
    check_law();
    // Below, faces are so soft that they part or overlap by their own size.
    constexpr double smallest_factor = 1e-3, smallest_multiple = .01;
    if (!(stiffness_factor >= smallest_factor))
      throw ParameterError(section,
                           "Stiffness factor",
                           "this must be " + to_text(smallest_factor) +
                             " or more.");
    if (!(penalty.value > 0 && std::isfinite(penalty.value)))
      throw ParameterError(section,
                           "Cohesive penalty",
                           "this must be greater than zero and finite.");
    if (penalty.is_multiple && penalty.value < smallest_multiple)
      throw ParameterError(section,
                           "Cohesive penalty",
                           "with less than " + to_text(smallest_multiple) +
                             " E faces are so soft that the body falls apart "
                             "without breaking.");
    // No solid is that soft; somebody has forgotten the E.
    constexpr double smallest_penalty = 1e6;
    if (!penalty.is_multiple && penalty.value < smallest_penalty)
      throw ParameterError(section,
                           "Cohesive penalty",
                           "this is in Pa, and less than " +
                             to_text(smallest_penalty) +
                             ". For a multiple of Young's modulus write \"" +
                             to_text(penalty.value) + " E\".");
  }

  void
  CohesiveParameters::check_law() const
  {
    if (model == Model::none || law == automatic)
      return;
    std::string others;
    for (const NamedLaw &other : laws)
      if (serves(other, model))
        {
          if (other.name == law)
            return;
          others += (others.empty() ? "" : ", ") + other.name;
        }
    throw ParameterError(section,
                         "Cohesive law",
                         "this law does not serve the " + to_string(model) +
                           " model; choose another \"Cohesive model\", or a "
                           "law that does: " +
                           others + ".");
  }

  std::vector<InertEntries>
  CohesiveParameters::inert_entries() const
  {
    std::vector<std::string> names;
    if (model != Model::extrinsic)
      names.push_back("Stiffness factor");
    if (model != Model::intrinsic)
      names.push_back("Cohesive penalty");
    if (model == Model::none)
      names.insert(names.end(), {"Cohesive law", "Seed"});
    std::vector<InertEntries> result = {{section,
                                         names,
                                         {{section, "Cohesive model"}},
                                         model == Model::none ?
                                           "without a cohesive model" :
                                           "with this cohesive model"}};
    if (model == Model::extrinsic && chosen_law() == bonds)
      result.push_back({section,
                        {"Stiffness factor"},
                        {{section, "Cohesive law"}},
                        "with bonds, which have no springs and are the "
                        "default of \"Cohesive law\"; it serves \"faces\""});
    return result;
  }
} // namespace rift
