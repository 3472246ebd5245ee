#include <deal.II/base/parameter_handler.h>

#include <rift/app/module_list.h>
#include <rift/app/parameters.h>
#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace rift
{
  namespace
  {
    // All that has no effect with the values of this scene.
    std::vector<InertEntries>
    inert_entries(const Parameters &parameters)
    {
      std::vector<InertEntries> result = parameters.mesh.inert_entries();
      const auto add = [&](const std::vector<InertEntries> &more) {
        result.insert(result.end(), more.begin(), more.end());
      };
      add(parameters.cohesive.inert_entries());
      add(parameters.contact.inert_entries());
      add(parameters.time.inert_entries());
      for (const auto &module : parameters.modules)
        add(module->inert_entries());
      for (const ProbeParameters &probe : parameters.probes)
        add(probe.inert_entries());
      for (const BoundaryParameters &boundary : parameters.boundaries)
        {
          add(boundary.inert_entries());
          if (parameters.cohesive.model == CohesiveParameters::Model::none)
            result.push_back({"Boundary " + boundary.name,
                              {"Acts while in place"},
                              {{"Fracture", "Cohesive model"}},
                              "where nothing breaks"});
        }

      InertEntries seed{"Fracture", {"Seed"}, {}, "without a Weibull modulus"};
      bool         has_scatter = false;
      for (const MaterialParameters &material : parameters.materials)
        {
          add(material.inert_entries());
          has_scatter = has_scatter || material.weibull_modulus != 0;
          const std::string section = "Material " + material.name;
          if (parameters.cohesive.chosen_law() != CohesiveParameters::bonds)
            result.push_back({section,
                              {"Correlation length"},
                              {{"Fracture", "Cohesive law"}},
                              "with a cohesive law other than \"bonds\", where "
                              "strengths scatter from face to face"});
          else if (material.weibull_modulus == 0)
            result.push_back({section,
                              {"Correlation length"},
                              {{section, "Weibull modulus"}},
                              "without a Weibull modulus"});
          seed.causes.emplace_back(section, "Weibull modulus");
        }
      if (!has_scatter &&
          parameters.cohesive.model != CohesiveParameters::Model::none)
        result.push_back(seed);
      return result;
    }

    void
    check_rigid(const Parameters &parameters)
    {
      const auto &materials = parameters.materials;
      const auto  rigid =
        std::find_if(materials.begin(), materials.end(), [](const auto &m) {
          return m.is_rigid();
        });
      if (rigid == materials.end())
        return;
      const std::string section = "Material " + rigid->name;
      if (parameters.contact.mode == ContactParameters::Mode::off)
        throw ParameterError(section,
                             "Elasticity",
                             "a rigid material acts on others by contact "
                             "alone. Remove \"Contact = false\" from "
                             "subsection Contact.");
      if (std::all_of(materials.begin(), materials.end(), [](const auto &m) {
            return m.is_rigid();
          }))
        throw ParameterError(section,
                             "Elasticity",
                             "there is nothing but rigid material. At least "
                             "one must be elastic: it sets the time step and "
                             "the stiffness of contact.");
    }

    void
    check_probes(const Parameters &parameters)
    {
      std::vector<std::string> rigid;
      for (const MaterialParameters &material : parameters.materials)
        if (material.is_rigid())
          rigid.push_back(material.name);
      for (const ProbeParameters &probe : parameters.probes)
        if (probe.field.location == FieldLocation::material &&
            std::count(rigid.begin(), rigid.end(), probe.material) == 0)
          throw ParameterError(
            "Probe " + probe.name,
            "Material",
            "there is no rigid material \"" + probe.material + "\"." +
              suggestion(probe.material,
                         rigid,
                         "No material of this scene is rigid."));
    }

    void
    check_bonds(const Parameters &parameters)
    {
      for (const MaterialParameters &material : parameters.materials)
        if (material.breakable && material.weibull_modulus > 0 &&
            material.correlation_length == 0)
          throw ParameterError("Material " + material.name,
                               "Correlation length",
                               "with a Weibull modulus, the cohesive law "
                               "\"bonds\" needs the distance over which "
                               "strengths are alike. Set it, in metres, or "
                               "remove \"Weibull modulus\", or take the law "
                               "\"faces\", with which strengths scatter from "
                               "face to face.");
    }

    // What can only be seen by looking at more than one subsection.
    void
    check_together(const Parameters &parameters, const ParameterFile &scene)
    {
      const auto &materials = parameters.materials;
      if (materials.empty())
        throw InputError(scene.path() +
                         ": there is no material. Write a subsection "
                         "\"Material NAME\" for each physical volume of the "
                         "mesh.");
      if (parameters.mesh.shape != MeshParameters::Shape::file)
        for (const MaterialParameters &material : materials)
          if (material.name != parameters.mesh.material)
            throw ParameterError("Mesh",
                                 "Material",
                                 "\"" + parameters.mesh.material +
                                   "\" is the only material of a built-in "
                                   "shape, but there is a subsection "
                                   "\"Material " +
                                   material.name +
                                   "\". Make the names the same.");
      check_rigid(parameters);
      check_probes(parameters);
      if (parameters.cohesive.model != CohesiveParameters::Model::none)
        {
          if (std::none_of(materials.begin(),
                           materials.end(),
                           [](const auto &m) { return m.breakable; }))
            throw ParameterError("Fracture",
                                 "Cohesive model",
                                 "no material is breakable. Set Breakable = "
                                 "true in one, or Cohesive model = none.");
          for (const MaterialParameters &material : materials)
            material.check_breakable();
          if (parameters.cohesive.chosen_law() == CohesiveParameters::bonds)
            check_bonds(parameters);
        }
      std::vector<std::string> names;
      for (const MaterialParameters &material : materials)
        names.push_back(material.name);
      parameters.contact.check_pairs(names);
    }

    void
    check(const Parameters &parameters, const ParameterFile &scene)
    {
      scene.refuse_inert(inert_entries(parameters));
      parameters.mesh.check();
      for (const MaterialParameters &material : parameters.materials)
        material.check();
      for (const BoundaryParameters &boundary : parameters.boundaries)
        boundary.check();
      parameters.cohesive.check();
      parameters.contact.check();
      parameters.time.check();
      for (const auto &module : parameters.modules)
        module->check();
      parameters.output.check();
      parameters.checkpoint.check();
      check_together(parameters, scene);
    }

    Parameters
    parse(dealii::ParameterHandler &prm,
          const SectionNames       &names,
          const ParameterFile      &scene)
    {
      Parameters result;
      result.title = prm.get("Title");
      result.mesh  = MeshParameters::parse(prm, scene);
      for (const std::string &name : names.materials)
        result.materials.push_back(MaterialParameters::parse(prm, name, scene));
      for (const std::string &name : names.boundaries)
        result.boundaries.push_back(
          BoundaryParameters::parse(prm, name, scene));
      for (auto &module : module_parameters())
        {
          prm.enter_subsection(module->section());
          module->parse(prm);
          prm.leave_subsection();
          result.modules.push_back(std::move(module));
        }
      result.cohesive   = CohesiveParameters::parse(prm);
      result.contact    = ContactParameters::parse(prm);
      result.time       = TimeParameters::parse(prm);
      result.output     = OutputParameters::parse(prm);
      result.checkpoint = CheckpointParameters::parse(prm);
      for (const std::string &name : names.probes)
        result.probes.push_back(ProbeParameters::parse(prm, name, scene));
      return result;
    }

    // The value of an entry for a .prm in any folder.
    std::string
    absolute_value(const ParameterDeclaration &entry,
                   const ParameterFile        &scene)
    {
      const bool is_mesh    = entry.section == "Mesh" && entry.name == "File";
      const bool has_tables = entry.section.compare(0, 9, "Boundary ") == 0 ||
                              entry.section.compare(0, 9, "Material ") == 0;
      const bool is_table = has_tables && ends_with(entry.value, ".csv");
      return is_mesh || is_table ?
               std::filesystem::absolute(
                 scene.resolve(entry.section, entry.name, entry.value))
                 .lexically_normal()
                 .string() :
               entry.value;
    }

    // See used_parameters().
    std::string
    used_text(const dealii::ParameterHandler  &prm,
              const std::vector<InertEntries> &inert,
              const ParameterFile             &scene)
    {
      const auto is_inert = [&](const ParameterDeclaration &entry) {
        return std::any_of(inert.begin(), inert.end(), [&](const auto &group) {
          return group.section == entry.section &&
                 std::count(group.names.begin(),
                            group.names.end(),
                            entry.name) > 0;
        });
      };
      std::ostringstream out;
      std::string        section;
      for (const ParameterDeclaration &entry : declarations(prm))
        {
          if (entry.section != section)
            {
              out << (section.empty() ? "" : "end\n") << "\nsubsection "
                  << entry.section << '\n';
              section = entry.section;
            }
          if (!entry.value.empty() && !is_inert(entry))
            out << (section.empty() ? "" : "  ") << "set " << entry.name
                << " = " << absolute_value(entry, scene) << '\n';
        }
      out << "end\n";
      return out.str();
    }
  } // namespace

  std::vector<std::string>
  section_kinds()
  {
    return {"Material", "Boundary", "Probe"};
  }

  void
  declare_parameters(dealii::ParameterHandler &prm, const SectionNames &names)
  {
    prm.declare_entry("Title",
                      "",
                      dealii::Patterns::Anything(),
                      "A line about the scene, for the log.");
    MeshParameters::declare(prm);
    for (const std::string &name : names.materials)
      MaterialParameters::declare(prm, name);
    for (const std::string &name : names.boundaries)
      BoundaryParameters::declare(prm, name);
    for (const auto &module : module_parameters())
      {
        prm.enter_subsection(module->section());
        module->declare(prm);
        prm.leave_subsection();
      }
    CohesiveParameters::declare(prm);
    ContactParameters::declare(prm);
    TimeParameters::declare(prm);
    OutputParameters::declare(prm);
    CheckpointParameters::declare(prm);
    for (const std::string &name : names.probes)
      ProbeParameters::declare(prm, name);
  }

  Parameters
  read_parameters(const std::string              &prm_file,
                  const std::vector<std::string> &overrides)
  {
    const ParameterFile      scene(prm_file, overrides);
    const SectionNames       names{scene.names_of("Material"),
                             scene.names_of("Boundary"),
                             scene.names_of("Probe")};
    dealii::ParameterHandler prm;
    declare_parameters(prm, names);
    apply(scene, section_kinds(), prm);
    try
      {
        Parameters result = parse(prm, names, scene);
        check(result, scene);
        result.used_text = used_text(prm, inert_entries(result), scene);
        return result;
      }
    catch (const ParameterError &error)
      {
        throw InputError(scene.describe(error));
      }
  }

  std::string
  used_parameters(const Parameters &parameters)
  {
    return parameters.used_text;
  }

  std::vector<std::string>
  warnings(const Parameters &parameters)
  {
    std::vector<std::string> result;
    for (const MaterialParameters &material : parameters.materials)
      {
        for (const std::string &warning : material.warnings())
          result.push_back(warning);
        if (parameters.cohesive.model == CohesiveParameters::Model::none &&
            material.breakable && material.tensile_strength.largest() > 0)
          result.push_back("Material " + material.name +
                           " has strengths, but nothing breaks without a "
                           "\"Cohesive model\" in subsection Fracture.");
      }
    const TimeParameters &time = parameters.time;
    for (const auto &[name, interval] :
         {std::make_pair("Solution interval",
                         parameters.output.solution_interval),
          std::make_pair("History interval",
                         parameters.output.history_interval)})
      if (interval > time.end_time)
        result.push_back(std::string("Output/") + name +
                         " is longer than the run. Are both times in "
                         "seconds?");
    return result;
  }

  void
  print_summary(std::ostream &out, const Parameters &parameters)
  {
    const auto names = [](const auto &list) {
      std::string result;
      for (const auto &entry : list)
        result += (result.empty() ? "" : ", ") + entry.name;
      return result.empty() ? std::string("none") : result;
    };
    const MeshParameters    &mesh    = parameters.mesh;
    const ContactParameters &contact = parameters.contact;
    const bool               can_break =
      parameters.cohesive.model != CohesiveParameters::Model::none;
    if (!parameters.title.empty())
      out << "title:      " << parameters.title << '\n';
    out << "mesh:       "
        << (mesh.shape == MeshParameters::Shape::file ? mesh.file :
            mesh.shape == MeshParameters::Shape::box  ? "built-in box" :
                                                        "built-in cylinder")
        << '\n'
        << "materials:  " << names(parameters.materials) << '\n'
        << "boundaries: " << names(parameters.boundaries) << '\n'
        << "probes:     " << names(parameters.probes) << '\n'
        << "fracture:   " << to_string(parameters.cohesive.model)
        << (parameters.cohesive.model == CohesiveParameters::Model::none ?
              "" :
              ", " + parameters.cohesive.chosen_law())
        << '\n'
        << "contact:    "
        << (contact.is_active(can_break, 1) ? "yes" :
            contact.is_active(can_break, 2) ? "if there are several bodies" :
                                              "no")
        << '\n'
        << "end time:   " << short_text(parameters.time.end_time) << " s\n"
        << "output:     " << parameters.output.directory << '\n';
  }
} // namespace rift
