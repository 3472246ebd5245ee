#include <deal.II/base/parameter_handler.h>

#include <rift/app/module_list.h>
#include <rift/app/parameter_reference.h>
#include <rift/app/parameters.h>
#include <rift/base/parameter_declarations.h>

#include <map>
#include <ostream>
#include <sstream>

namespace rift
{
  namespace
  {
    std::vector<ParameterDeclaration>
    declarations_of(const SectionNames &names)
    {
      dealii::ParameterHandler prm;
      declare_parameters(prm, names);
      return declarations(prm);
    }

    // What a subsection is for, by its first words.
    std::string
    purpose(const std::string &section)
    {
      const std::map<std::string, std::string> texts = {
        {"Mesh", "The body and its tetrahedra."},
        {"Material",
         "A material, one subsection for each physical volume of the mesh, "
         "whose name it has."},
        {"Boundary",
         "What acts on a physical surface of the mesh, whose name it has. A "
         "function of time is an expression in t, or the path of a table "
         "that ends with .csv, relative to the .prm; a table acts with its "
         "mean over each time step, an expression with its value in the "
         "middle. A load whose forces act along prescribed velocities alone "
         "is an error. A surface without subsection is free."},
        {"Fracture", "How cracks are computed."},
        {"Contact", "What happens where surfaces meet."},
        {"Time", "The time steps."},
        {"Output", "What is written, and where."},
        {"Checkpoint",
         "What a stopped run can go on from, with --restart: sets of "
         "files in the folder checkpoint of the output directory."},
        {"Probe",
         "A column of probes.csv, whose name it has: a field at a point or "
         "averaged over a boundary."}};
      for (const auto &module : module_parameters())
        if (module->section() == section)
          return module->purpose();
      return texts.at(section.substr(0, section.find(' ')));
    }

    // Values that make print_defaults() a scene: a bar of granite that is
    // struck at one end.
    std::string
    example_value(const ParameterDeclaration &entry)
    {
      const std::map<std::string, std::string> values = {
        {"/Title", "A bar of granite struck at one end"},
        {"Mesh/Shape", "box"},
        {"Mesh/Element size", "5e-3"},
        {"Mesh/Box size", "0.1, 0.02, 0.02"},
        {"Material rock/Density", "2641"},
        {"Material rock/Young's modulus", "40.6e9"},
        {"Material rock/Poisson's ratio", "0.2"},
        {"Boundary x_min/Pressure",
         "t < 10e-6 ? 1e6 * sin(pi * t / 10e-6) : 0"},
        {"Time/End time", "50e-6"},
        {"Output/Solution interval", "5e-6"},
        {"Probe end/Field", "velocity x"},
        {"Probe end/Boundary", "x_max"}};
      const auto value = values.find(entry.section + "/" + entry.name);
      return value == values.end() ? "" : value->second;
    }

    // Comment lines of at most 78 characters.
    void
    print_comment(std::ostream      &out,
                  const std::string &indent,
                  const std::string &text)
    {
      std::istringstream words(text);
      std::string        line, word;
      while (words >> word)
        {
          if (!line.empty() &&
              indent.size() + line.size() + word.size() + 3 > 78)
            {
              out << indent << "# " << line << '\n';
              line.clear();
            }
          line += (line.empty() ? "" : " ") + word;
        }
      out << indent << "# " << line << '\n';
    }

    // "Material rock" -> "Material NAME".
    std::string
    heading(const std::string &section)
    {
      for (const std::string &kind : section_kinds())
        if (section.compare(0, kind.size() + 1, kind + " ") == 0)
          return kind + " NAME";
      return section;
    }

    // A bar would end the column of a table.
    std::string
    cell(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        result += c == '|' ? "\\|" : std::string(1, c);
      return result;
    }
  } // namespace

  void
  print_defaults(std::ostream &out)
  {
    print_comment(out,
                  "",
                  "Every entry of a scene of rift. Entries behind a # are not "
                  "used by this scene, or show their default. The units are "
                  "those of the SI.");
    std::string section;
    for (const ParameterDeclaration &entry :
         declarations_of({{"rock"}, {"x_min"}, {"end"}}))
      {
        if (entry.section != section)
          {
            out << (section.empty() ? "" : "end\n") << '\n';
            print_comment(out, "", purpose(entry.section));
            out << "subsection " << entry.section << '\n';
            section = entry.section;
          }
        else
          out << '\n';
        const std::string indent = section.empty() ? "" : "  ";
        const std::string unit =
          entry.unit.empty() ? "" : " Unit: " + entry.unit + ".";
        const std::string choices =
          entry.choices.empty() ? "" : " Choices: " + entry.expected + ".";
        print_comment(out, indent, entry.documentation + unit + choices);
        const std::string example = example_value(entry);
        const std::string value =
          example.empty() ? entry.default_value : example;
        out << indent << (example.empty() ? "# " : "") << "set " << entry.name
            << (value.empty() ? " =" : " = ") << value << '\n';
      }
    out << "end\n";
  }

  void
  generate_reference(std::ostream &out)
  {
    out << "# Parameters of a scene\n\n"
           "This page is printed by `rift --reference`; `rift --defaults` "
           "prints a scene with every entry.\n\n"
           "A scene is a text file: `subsection NAME` ... `end`, `set NAME = "
           "VALUE`, `include FILE`; `#` starts a comment, a backslash at the "
           "end of a line continues it. All units are those of the SI. Paths "
           "are relative to the file in which they stand. An entry that would "
           "have no effect is refused.\n\n"
           "Any entry can be set on the command line: `--set "
           "\"Section/Name=value\"`, as in `--set \"Material "
           "granite/Density=2700\"`. A Material, Boundary or Probe must stand "
           "in the scene.\n\n"
           "## Top level\n";
    std::string section = "none yet";
    for (const ParameterDeclaration &entry :
         declarations_of({{"NAME"}, {"NAME"}, {"NAME"}}))
      {
        if (entry.section != section)
          {
            section = entry.section;
            if (!section.empty())
              out << "\n## " << heading(section) << "\n\n"
                  << purpose(section) << '\n';
            out << "\n| Entry | Default | Unit | Value | Meaning |\n"
                   "|---|---|---|---|---|\n";
          }
        out << "| " << entry.name << " | "
            << (entry.default_value.empty() ?
                  "" :
                  "`" + cell(entry.default_value) + "`")
            << " | " << entry.unit << " | " << cell(entry.expected) << " | "
            << cell(entry.documentation) << " |\n";
      }
  }
} // namespace rift
