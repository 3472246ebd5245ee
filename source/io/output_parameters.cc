#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/io/output_parameters.h>

#include <utility>

namespace rift
{
  namespace
  {
    const char *const section = "Output";

    // The words of `Field`, each with what it stands for.
    struct FieldWord
    {
      std::string            text;
      ProbeParameters::Field field;
      unsigned int           component;
    };

    std::vector<FieldWord>
    field_words()
    {
      using Field = ProbeParameters::Field;
      std::vector<FieldWord> result;
      const auto             add = [&](const std::string              &name,
                           const Field                     field,
                           const std::vector<std::string> &components) {
        for (unsigned int i = 0; i < components.size(); ++i)
          result.push_back({name + " " + components[i], field, i});
      };
      add("displacement", Field::displacement, {"x", "y", "z"});
      add("velocity", Field::velocity, {"x", "y", "z"});
      add("stress", Field::stress, {"xx", "yy", "zz", "yz", "xz", "xy"});
      result.push_back({"pressure", Field::pressure, 0});
      add("force", Field::force, {"x", "y", "z"});
      return result;
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
  }

  void
  ProbeParameters::declare(dealii::ParameterHandler &prm,
                           const std::string        &name)
  {
    namespace Patterns = dealii::Patterns;
    std::string words;
    for (const FieldWord &word : field_words())
      words += (words.empty() ? "" : "|") + word.text;
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
    for (const FieldWord &word : field_words())
      if (word.text == prm.get("Field"))
        {
          result.field     = word.field;
          result.component = word.component;
        }
    result.boundary = prm.get("Boundary");
    result.material = prm.get("Material");
    result.point    = get_vector(prm, "Point");
    prm.leave_subsection();
    if (result.field == ProbeParameters::Field::force)
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
    if (field == Field::force)
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
