#include <deal.II/base/parameter_handler.h>

#include <rift/base/number_text.h>
#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>
#include <rift/material/elasticity.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    using dealii::ParameterHandler;
    namespace Patterns = dealii::Patterns;

    std::string
    section_of(const std::string &name)
    {
      return "Material " + name;
    }

    const std::array<std::pair<std::string, CrackScheme>, 4> scheme_words = {
      {{"differential", CrackScheme::differential},
       {"differential in order", CrackScheme::differential_in_order},
       {"dilute", CrackScheme::dilute},
       {"self-consistent", CrackScheme::self_consistent}}};

    std::string
    scheme_selection()
    {
      std::string words;
      for (const auto &word : scheme_words)
        words += (words.empty() ? "" : "|") + word.first;
      return words;
    }

    /** "0 1 0: 0.06" or "random: 0.2" */
    CrackGroup
    read_crack_group(const std::string &text, const std::string &section)
    {
      const std::size_t colon = std::min(text.find(':'), text.size());
      const auto        words = split(simplified(text.substr(0, colon)), ' ');
      CrackGroup        group{};
      bool              is_good =
        colon < text.size() &&
        from_text(simplified(text.substr(colon + 1)), group.density);
      if (words.size() == 3)
        {
          group.normal.emplace();
          for (unsigned int d = 0; d < 3; ++d)
            is_good = is_good && from_text(words[d], (*group.normal)[d]);
        }
      else
        is_good = is_good && words.size() == 1 && words[0] == "random";
      if (!is_good)
        throw ParameterError(section,
                             "Crack groups",
                             "\"" + text +
                               "\" is not of the form \"0 1 0: 0.06\" or "
                               "\"random: 0.2\"; put commas between groups.");
      return group;
    }

    std::optional<double>
    read_residual_friction(const std::string &text, const std::string &section)
    {
      double angle;
      if (text.empty())
        return {};
      if (!from_text(text, angle))
        throw ParameterError(section,
                             "Residual friction angle",
                             "this must be a number in degrees, or nothing.");
      return angle * M_PI / 180;
    }

    /** An entry that is the same in all directions, or not. */
    void
    declare_directional(ParameterHandler       &prm,
                        const std::string      &name,
                        const DirectionalValue &default_value,
                        const std::string      &documentation)
    {
      prm.declare_entry(name,
                        to_text(default_value.smallest()),
                        Patterns::List(Patterns::Double(), 1, 3),
                        documentation);
    }

    DirectionalValue
    read_directional(const ParameterHandler &prm,
                     const std::string      &section,
                     const std::string      &name)
    {
      const std::vector<double> numbers = get_numbers(prm, name);
      if (numbers.size() == 2)
        throw ParameterError(section,
                             name,
                             "these are two numbers. Give one for all "
                             "directions, or three: for planes across the "
                             "material axes 1, 2 and 3.");
      if (numbers.size() == 1)
        return numbers[0];
      return {numbers.at(0), numbers.at(1), numbers.at(2)};
    }

    void
    declare_elasticity(ParameterHandler &prm)
    {
      const MaterialParameters defaults;
      std::string              names, meanings;
      for_each_elastic_law([&](const auto &law) {
        names += (names.empty() ? "" : "|") + std::string(law.name);
        meanings += (meanings.empty() ? "" : ", ") + std::string(law.meaning);
      });
      prm.declare_entry("Elasticity",
                        defaults.elasticity,
                        Patterns::Selection(names),
                        "The elastic law: " + meanings + ".");
      declare_number(prm,
                     "Young's modulus",
                     defaults.youngs_modulus,
                     "Young's modulus of an isotropic material, or of one "
                     "without its microcracks. Must be set. "
                     "Units: Pa.");
      declare_number(prm,
                     "Poisson's ratio",
                     defaults.poissons_ratio,
                     "Poisson's ratio of the same. Units: 1.");
      std::string zeros = "0";
      for (unsigned int i = 1; i < 21; ++i)
        zeros += ", 0";
      prm.declare_entry("Stiffness",
                        zeros,
                        Patterns::List(Patterns::Double(), 21, 21),
                        "Upper triangle, row by row, of the stiffness of an "
                        "anisotropic material in Voigt's order 11, 22, 33, "
                        "23, 13, 12, in the material axes. Units: Pa.");
      prm.declare_entry("Crack groups",
                        "",
                        Patterns::Anything(),
                        "Microcracks: normal in material axes and density "
                        "(number per volume times the mean cube of the radii) "
                        "of each group, as in \"0 1 0: 0.06, random: 0.2\". "
                        "Units: 1.");
      prm.declare_entry("Crack scheme",
                        scheme_words[0].first,
                        Patterns::Selection(scheme_selection()),
                        "How microcracks feel each other: they are added "
                        "little by little, all groups together or in their "
                        "order, or each is as if alone in the intact material, "
                        "or in the cracked one.");
      declare_vector(prm,
                     "Axis 1",
                     defaults.axis_1,
                     "Material axis 1 in the coordinates of the mesh, of any "
                     "length. Units: 1.");
      declare_vector(prm,
                     "Axis 2",
                     defaults.axis_2,
                     "Material axis 2; what it has along axis 1 is taken "
                     "away. Axis 3 is their vector product. Units: 1.");
      for_each_elastic_law([&](const auto &law) {
        for (const ElasticConstant &constant : law.constants())
          declare_number(prm, constant.name, 0, constant.documentation);
      });
    }

    /** "on an isotropic material" */
    std::string
    on_material(const std::string &elasticity)
    {
      const bool is_vowel =
        std::string("aeiou").find(elasticity[0]) != std::string::npos;
      return std::string("on ") + (is_vowel ? "an " : "a ") + elasticity +
             " material";
    }

    /** The entries of elastic laws that this one does not use. */
    std::vector<std::string>
    entries_of_other_laws(const std::string &elasticity)
    {
      std::vector<std::string> used, others;
      const auto               entries_of = [](const auto &law) {
        std::vector<std::string> names = law.entries();
        for (const ElasticConstant &constant : law.constants())
          names.push_back(constant.name);
        return names;
      };
      for_each_elastic_law([&](const auto &law) {
        if (elasticity == law.name)
          used = entries_of(law);
      });
      for_each_elastic_law([&](const auto &law) {
        for (const std::string &entry : entries_of(law))
          if (std::count(used.begin(), used.end(), entry) +
                std::count(others.begin(), others.end(), entry) ==
              0)
            others.push_back(entry);
      });
      return others;
    }

    void
    declare_strength(ParameterHandler &prm)
    {
      const MaterialParameters defaults;
      prm.declare_entry("Breakable",
                        "true",
                        Patterns::Bool(),
                        "Whether cracks may run inside this material.");
      declare_directional(prm,
                          "Tensile strength",
                          defaults.tensile_strength,
                          "A crack starts at this normal stress. One number, "
                          "or three: for planes across the material axes 1, 2 "
                          "and 3. Units: Pa.");
      declare_directional(prm,
                          "Cohesion",
                          defaults.cohesion,
                          "A crack starts at this shear stress, where there is "
                          "no normal stress. One number or three, as above. "
                          "Units: Pa.");
      declare_number(prm,
                     "Friction angle",
                     defaults.friction_angle,
                     "Angle of internal friction: its tangent times the "
                     "compressive stress adds to the cohesion. Units: "
                     "degrees.");
      prm.declare_entry("Residual friction angle",
                        "",
                        Patterns::Anything(),
                        "Angle to which friction falls while a face loses its "
                        "strength. Without it friction stays. Units: degrees.");
      declare_directional(prm,
                          "Fracture energy I",
                          defaults.fracture_energy_1,
                          "Energy per area of crack, of opening. One number or "
                          "three, as above. Units: J/m^2.");
      declare_directional(prm,
                          "Fracture energy II",
                          defaults.fracture_energy_2,
                          "Energy per area of crack, of sliding. One number or "
                          "three, as above. Units: J/m^2.");
      declare_number(prm,
                     "Weibull modulus",
                     defaults.weibull_modulus,
                     "Modulus of the scatter of tensile strength and cohesion "
                     "from face to face or, with the cohesive law bonds, from "
                     "place to place; the larger, the less scatter. 0: no "
                     "scatter. Units: 1.");
      declare_number(prm,
                     "Correlation length",
                     defaults.correlation_length,
                     "Distance over which the scatter of strength loses its "
                     "memory: its correlation falls to 1/e. Must be set with a "
                     "Weibull modulus and the cohesive law bonds. Units: m.");
    }
  } // namespace

  void
  MaterialParameters::declare(ParameterHandler &prm, const std::string &name)
  {
    const MaterialParameters defaults;
    prm.enter_subsection(section_of(name));
    declare_number(prm,
                   "Density",
                   defaults.density,
                   "Mass density. Must be set. Units: kg/m^3.");
    declare_elasticity(prm);
    declare_number(prm,
                   "Viscosity",
                   defaults.viscosity,
                   "Factor of the rate of deformation in the viscous stress; "
                   "0: no damping. Units: Pa s.");
    declare_vector(prm,
                   "Initial velocity",
                   defaults.initial_velocity,
                   "Velocity at the start along x, y, z. Units: m/s.");
    for (const std::string axis : {"x", "y", "z"})
      prm.declare_entry("Velocity " + axis,
                        "",
                        Patterns::Anything(),
                        "Rigid material: function of time, the velocity of its "
                        "bodies along " +
                          axis +
                          ", which then do not turn. Without it they are free "
                          "along " +
                          axis + ". Units: m/s.");
    declare_strength(prm);
    prm.leave_subsection();
  }

  MaterialParameters
  MaterialParameters::parse(ParameterHandler    &prm,
                            const std::string   &name,
                            const ParameterFile &scene)
  {
    MaterialParameters result;
    result.name = name;
    prm.enter_subsection(section_of(name));
    result.density    = prm.get_double("Density");
    result.elasticity = prm.get("Elasticity");
    for_each_elastic_law([&](const auto &law) {
      for (const ElasticConstant &constant : law.constants())
        result.elastic_constants[constant.name] = prm.get_double(constant.name);
    });
    for (const std::string &group : split(prm.get("Crack groups"), ','))
      result.crack_groups.push_back(read_crack_group(group, section_of(name)));
    for (const auto &[word, scheme] : scheme_words)
      if (word == prm.get("Crack scheme"))
        result.crack_scheme = scheme;
    result.youngs_modulus = prm.get_double("Young's modulus");
    result.poissons_ratio = prm.get_double("Poisson's ratio");
    const auto stiffness  = get_numbers(prm, "Stiffness");
    for (unsigned int i = 0; i < result.stiffness.size(); ++i)
      result.stiffness[i] = stiffness.at(i);
    result.axis_1           = get_vector(prm, "Axis 1");
    result.axis_2           = get_vector(prm, "Axis 2");
    result.viscosity        = prm.get_double("Viscosity");
    result.initial_velocity = get_vector(prm, "Initial velocity");
    result.breakable        = prm.get_bool("Breakable") && !result.is_rigid();
    for (unsigned int d = 0; d < 3; ++d)
      result.velocity[d] = get_function(prm,
                                        section_of(name),
                                        std::string("Velocity ") + "xyz"[d],
                                        scene);
    const auto directional = [&](const std::string &entry) {
      return read_directional(prm, section_of(name), entry);
    };
    result.tensile_strength = directional("Tensile strength");
    result.cohesion         = directional("Cohesion");
    result.friction_angle   = prm.get_double("Friction angle") * M_PI / 180;
    result.residual_friction_angle =
      read_residual_friction(prm.get("Residual friction angle"),
                             section_of(name));
    result.fracture_energy_1  = directional("Fracture energy I");
    result.fracture_energy_2  = directional("Fracture energy II");
    result.weibull_modulus    = prm.get_double("Weibull modulus");
    result.correlation_length = prm.get_double("Correlation length");
    prm.leave_subsection();
    return result;
  }

  std::vector<InertEntries>
  MaterialParameters::inert_entries() const
  {
    const std::string         section = section_of(name);
    std::vector<InertEntries> result;
    const auto                add = [&](const std::vector<std::string> &names,
                         const std::string              &cause,
                         const std::string              &reason) {
      result.push_back({section, names, {{section, cause}}, reason});
    };
    const std::vector<std::string> strength = {"Tensile strength",
                                               "Cohesion",
                                               "Friction angle",
                                               "Residual friction angle",
                                               "Fracture energy I",
                                               "Fracture energy II",
                                               "Weibull modulus",
                                               "Correlation length"};
    const std::string              reason   = on_material(elasticity);
    auto                           others   = entries_of_other_laws(elasticity);
    // Strengths may need axes where elasticity does not.
    const auto axes =
      std::remove_if(others.begin(),
                     others.end(),
                     [](const std::string &entry) {
                       return entry == "Axis 1" || entry == "Axis 2";
                     });
    const bool needs_no_axes = axes != others.end();
    others.erase(axes, others.end());
    add(others, "Elasticity", reason);
    if (needs_no_axes && is_rigid())
      add({"Axis 1", "Axis 2"}, "Elasticity", reason);
    else if (needs_no_axes && !(breakable && has_directional_strength()))
      result.push_back({section,
                        {"Axis 1", "Axis 2"},
                        {{section, "Elasticity"},
                         {section, "Breakable"},
                         {section, "Tensile strength"},
                         {section, "Cohesion"},
                         {section, "Fracture energy I"},
                         {section, "Fracture energy II"}},
                        reason + " whose strengths do not depend on the "
                                 "direction"});
    if (is_rigid())
      {
        add(strength, "Elasticity", reason);
        add({"Viscosity", "Breakable"}, "Elasticity", reason);
      }
    else
      add({"Velocity x", "Velocity y", "Velocity z"},
          "Elasticity",
          "on a material that is not rigid");
    if (!breakable && !is_rigid())
      add(strength, "Breakable", "on an unbreakable material");
    return result;
  }
} // namespace rift
