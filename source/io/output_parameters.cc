#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>
#include <rift/io/output_parameters.h>
#include <rift/io/solution_fields.h>

#include <algorithm>
#include <utility>

namespace rift
{
  namespace
  {
    const char *const section = "Output";

    /** What a Probe can ask for, with the words for it: "velocity x". */
    std::vector<std::pair<std::string, ProbeParameters::Component>>
    probe_components()
    {
      std::vector<std::pair<std::string, ProbeParameters::Component>> result;
      for (const Field &field : known_fields())
        for (std::size_t i = 0; i < field.components.size() &&
                                field.location != FieldLocation::cohesive_face;
             ++i)
          result.emplace_back(
            simplified(field.name + " " + field.components[i]),
            ProbeParameters::Component{field.name,
                                       field.unit,
                                       field.location,
                                       i});
      return result;
    }

    /** Names of the fields that solid.pvd and fracture.pvd can have. */
    std::vector<std::string>
    names_of_output_fields(const FieldUse use)
    {
      std::vector<std::string> names;
      for (const Field &field : known_output_fields())
        if (field.use == use && field.location != FieldLocation::material)
          names.push_back(field.name);
      return names;
    }

    std::vector<std::string>
    names_of_output_fields()
    {
      auto       names = names_of_output_fields(FieldUse::by_default);
      const auto more  = names_of_output_fields(FieldUse::on_request);
      names.insert(names.end(), more.begin(), more.end());
      return names;
    }
  } // namespace

  void
  OutputParameters::declare(dealii::ParameterHandler &prm)
  {
    const OutputParameters defaults;
    prm.enter_subsection(section);
    prm.declare_entry("Directory",
                      defaults.directory,
                      dealii::Patterns::Anything(),
                      "Where the results go, relative to the folder in which "
                      "rift is started.");
    declare_number(prm,
                   "Solution interval",
                   defaults.solution_interval,
                   "Time between two states in solid.pvd and fracture.pvd; "
                   "0: none are written. Units: s.");
    declare_number(prm,
                   "History interval",
                   defaults.history_interval,
                   "Time between two rows of probes.csv and energy.csv; 0: a "
                   "row for each time step. Units: s.");
    prm.declare_entry(
      "Fields",
      "default",
      dealii::Patterns::Anything(),
      "What is in solid.pvd and fracture.pvd: names with commas between them. "
      "\"default\" stands for " +
        enumeration(names_of_output_fields(FieldUse::by_default), "and") +
        ", \"all\" for these and " +
        enumeration(names_of_output_fields(FieldUse::on_request), "and") + ".");
    prm.declare_entry("Overwrite",
                      "false",
                      dealii::Patterns::Bool(),
                      "Whether results of an older run may be replaced.");
    prm.declare_entry("Ranks per file",
                      std::to_string(defaults.ranks_per_file),
                      dealii::Patterns::Integer(1),
                      "On more ranks than this a state is divided into several "
                      "files, each written by so many ranks together.");
    prm.leave_subsection();
  }

  OutputParameters
  OutputParameters::parse(dealii::ParameterHandler &prm)
  {
    OutputParameters result;
    prm.enter_subsection(section);
    result.directory         = prm.get("Directory");
    result.solution_interval = prm.get_double("Solution interval");
    result.history_interval  = prm.get_double("History interval");
    result.fields.words      = split(prm.get("Fields"), ',');
    result.overwrite         = prm.get_bool("Overwrite");
    result.ranks_per_file = static_cast<int>(prm.get_integer("Ranks per file"));
    prm.leave_subsection();
    return result;
  }

  void
  OutputParameters::check() const
  {
    if (directory.empty())
      throw ParameterError(section, "Directory", "a folder is needed.");
    for (const auto &[name, value] :
         {std::make_pair("Solution interval", solution_interval),
          std::make_pair("History interval", history_interval)})
      if (!(value >= 0))
        throw ParameterError(section,
                             name,
                             "this cannot be negative. Units: s.");
    std::vector<std::string> names = names_of_output_fields();
    names.insert(names.end(), {"default", "all"});
    if (fields.words.empty())
      throw ParameterError(section,
                           "Fields",
                           "at least one field is needed, or \"default\".");
    for (const std::string &word : fields.words)
      if (std::count(names.begin(), names.end(), word) == 0)
        throw ParameterError(section,
                             "Fields",
                             "there is no field \"" + word + "\"." +
                               suggestion(word, names));
  }

  void
  ProbeParameters::declare(dealii::ParameterHandler &prm,
                           const std::string        &name)
  {
    namespace Patterns = dealii::Patterns;
    std::string words;
    for (const auto &[text, component] : probe_components())
      words += (words.empty() ? "" : "|") + text;
    prm.enter_subsection("Probe " + name);
    prm.declare_entry("Field",
                      "velocity x",
                      Patterns::Selection(words),
                      "What is written to the column NAME of probes.csv. "
                      "Stress is positive in tension, pressure in "
                      "compression. Force is what contact, loads and gravity "
                      "do to rigid bodies, not what drives them.");
    prm.declare_entry("Boundary",
                      "",
                      Patterns::Anything(),
                      "The average over this boundary is taken.");
    prm.declare_entry("Material",
                      "",
                      Patterns::Anything(),
                      "Rigid material, the force on whose bodies is taken. For "
                      "forces alone.");
    declare_vector(prm,
                   "Point",
                   ProbeParameters().point,
                   "Place of the probe in the undeformed body, where there is "
                   "no Boundary. Units: m.");
    prm.leave_subsection();
  }

  ProbeParameters
  ProbeParameters::parse(dealii::ParameterHandler &prm,
                         const std::string        &name,
                         const ParameterFile      &scene)
  {
    const std::string probe = "Probe " + name;
    ProbeParameters   result;
    result.name = name;
    prm.enter_subsection(probe);
    for (const auto &[text, component] : probe_components())
      if (text == prm.get("Field"))
        result.field = component;
    result.boundary = prm.get("Boundary");
    result.material = prm.get("Material");
    result.point    = get_vector(prm, "Point");
    prm.leave_subsection();
    if (result.field.location == FieldLocation::material)
      {
        if (result.material.empty())
          throw ParameterError(probe,
                               "Material",
                               "a force needs the rigid material on which it "
                               "acts.");
      }
    else if (result.boundary.empty() && scene.find(probe, "Point") == nullptr)
      throw ParameterError(probe,
                           "Point",
                           "a probe needs a Boundary or a Point.");
    return result;
  }

  std::vector<InertEntries>
  ProbeParameters::inert_entries() const
  {
    const std::string probe = "Probe " + name;
    if (field.location == FieldLocation::material)
      return {{probe,
               {"Boundary", "Point"},
               {{probe, "Field"}},
               "on the force on a material"}};
    const InertEntries no_force{probe,
                                {"Material"},
                                {{probe, "Field"}},
                                "on anything but forces"};
    if (boundary.empty())
      return {no_force};
    return {{probe,
             {"Point"},
             {{probe, "Boundary"}},
             "on the average over a boundary"},
            no_force};
  }
} // namespace rift
