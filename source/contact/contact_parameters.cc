#include <deal.II/base/parameter_handler.h>

#include <rift/base/number_text.h>
#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>
#include <rift/contact/contact_parameters.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    const char *const section    = "Contact";
    const char *const pairs_name = "Friction of pairs";

    /** More would need a shorter time step. */
    constexpr double largest_damping = .3;

    /** With less, bodies pass through each other. */
    constexpr double smallest_factor = 1e-3;

    bool
    is_pair(const ContactParameters::PairFriction &pair,
            const std::string                     &first,
            const std::string                     &second)
    {
      return (pair.first == first && pair.second == second) ||
             (pair.first == second && pair.second == first);
    }

    std::string
    text_of(const std::string_view part)
    {
      return std::string(trim(std::string(part)));
    }

    /** "granite - steel: 0.3" */
    ContactParameters::PairFriction
    read_pair(const std::string &text)
    {
      ContactParameters::PairFriction pair{};
      const std::size_t               colon = text.rfind(':');
      const std::size_t               dash  = text.find(" - ");
      if (colon != std::string::npos && dash < colon)
        {
          pair.first  = text_of(text.substr(0, dash));
          pair.second = text_of(text.substr(dash + 3, colon - dash - 3));
          const std::string number = text_of(text.substr(colon + 1));
          if (!pair.first.empty() && !pair.second.empty() &&
              from_text(number, pair.coefficient))
            return pair;
        }
      throw ParameterError(section,
                           pairs_name,
                           "\"" + text +
                             "\" is not of the form \"granite - steel: 0.3\"; "
                             "put commas between pairs.");
    }

    std::vector<ContactParameters::PairFriction>
    read_pairs(const std::string &text)
    {
      std::vector<ContactParameters::PairFriction> pairs;
      for (const std::string &part : split(text, ','))
        pairs.push_back(read_pair(part));
      return pairs;
    }

    void
    check_coefficient(const std::string &name, const double value)
    {
      if (!(value >= 0 && std::isfinite(value)))
        throw ParameterError(section,
                             name,
                             "a coefficient of friction of " + to_text(value) +
                               " cannot be; give zero or more.");
    }
  } // namespace

  void
  ContactParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    const ContactParameters defaults;
    prm.enter_subsection(section);
    prm.declare_entry("Contact",
                      "automatic",
                      Patterns::Selection("automatic|true|false"),
                      "Whether surfaces that meet collide and rub: the outer "
                      "surfaces of all bodies and the faces of cracks. Without "
                      "it they pass through each other. \"automatic\": where "
                      "something can break or there are several bodies.");
    declare_number(prm,
                   "Friction coefficient",
                   defaults.friction,
                   "Coefficient of friction between all materials but the "
                   "following pairs. Units: 1.");
    prm.declare_entry(pairs_name,
                      "",
                      Patterns::Anything(),
                      "Coefficients of friction between certain materials, as "
                      "in \"granite - steel: 0.3, steel - steel: 0.1\". "
                      "Units: 1.");
    declare_number(prm,
                   "Damping",
                   defaults.damping,
                   "Damping of approach and parting over the critical one of "
                   "the two cells that touch, at most " +
                     to_text(largest_damping) +
                     "; with 0 a collision is elastic. Units: 1.");
    declare_number(prm,
                   "Stiffness factor",
                   defaults.stiffness_factor,
                   "Room that the automatic time step leaves for contact: the "
                   "square of the largest frequency of a loose cell may grow "
                   "by three times this factor. The penalty of each cell is as "
                   "large as that allows. In the extrinsic model the larger "
                   "one of this factor and that of the cohesive elements "
                   "counts for both. Units: 1.");
    prm.leave_subsection();
  }

  ContactParameters
  ContactParameters::parse(dealii::ParameterHandler &prm)
  {
    ContactParameters result;
    prm.enter_subsection(section);
    const std::string mode  = prm.get("Contact");
    result.mode             = mode == "true"  ? Mode::on :
                              mode == "false" ? Mode::off :
                                                Mode::automatic;
    result.friction         = prm.get_double("Friction coefficient");
    result.pair_frictions   = read_pairs(prm.get(pairs_name));
    result.damping          = prm.get_double("Damping");
    result.stiffness_factor = prm.get_double("Stiffness factor");
    prm.leave_subsection();
    return result;
  }

  void
  ContactParameters::check() const
  {
    check_coefficient("Friction coefficient", friction);
    for (const PairFriction &pair : pair_frictions)
      check_coefficient(pairs_name, pair.coefficient);
    if (!(damping >= 0 && damping <= largest_damping))
      throw ParameterError(section,
                           "Damping",
                           "this must be between 0 and " +
                             to_text(largest_damping) + ".");
    if (!(stiffness_factor >= smallest_factor))
      throw ParameterError(section,
                           "Stiffness factor",
                           "this must be " + to_text(smallest_factor) +
                             " or more.");
  }

  void
  ContactParameters::check_pairs(
    const std::vector<std::string> &materials) const
  {
    for (auto pair = pair_frictions.begin(); pair != pair_frictions.end();
         ++pair)
      {
        for (const std::string &name : {pair->first, pair->second})
          if (std::count(materials.begin(), materials.end(), name) == 0)
            throw ParameterError(section,
                                 pairs_name,
                                 "there is no material \"" + name + "\"." +
                                   suggestion(name, materials));
        if (std::any_of(pair_frictions.begin(), pair, [&](const auto &other) {
              return is_pair(other, pair->first, pair->second);
            }))
          throw ParameterError(section,
                               pairs_name,
                               "\"" + pair->first + " - " + pair->second +
                                 "\" stands here twice.");
      }
  }

  std::vector<InertEntries>
  ContactParameters::inert_entries() const
  {
    if (mode != Mode::off)
      return {};
    return {
      {section,
       {"Friction coefficient", pairs_name, "Damping", "Stiffness factor"},
       {{section, "Contact"}},
       "without contact"}};
  }

  double
  ContactParameters::friction_of(const std::string &first,
                                 const std::string &second) const
  {
    const auto pair = std::find_if(
      pair_frictions.begin(),
      pair_frictions.end(),
      [&](const PairFriction &p) { return is_pair(p, first, second); });
    return pair != pair_frictions.end() ? pair->coefficient : friction;
  }
} // namespace rift
