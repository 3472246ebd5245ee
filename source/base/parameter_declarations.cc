#include <deal.II/base/parameter_handler.h>

#include <rift/base/number_text.h>
#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace rift
{
  namespace
  {
    using dealii::ParameterHandler;
    namespace Patterns = dealii::Patterns;

    // The choices of deal.II's "[Selection a|b|c ]".
    std::vector<std::string>
    choices_of(const std::string &pattern)
    {
      const std::string start = "[Selection ";
      if (pattern == "[Bool]")
        return {"true", "false"};
      if (pattern.compare(0, start.size(), start) != 0)
        return {};
      std::istringstream words(
        pattern.substr(start.size(), pattern.size() - start.size() - 1));
      std::vector<std::string> result;
      for (std::string word; std::getline(words, word, '|');)
        result.push_back(simplified(word));
      return result;
    }

    // What deal.II's description of a pattern means to a user.
    std::string
    in_words(const std::string &pattern)
    {
      const auto starts_with = [&](const std::string &start) {
        return pattern.compare(0, start.size(), start) == 0;
      };
      if (starts_with("[Double"))
        return "a number";
      if (starts_with("[Integer"))
        {
          // "[Integer range 0...9 (inclusive)]"
          const std::size_t begin = pattern.find("range ") + 6;
          const std::size_t dots  = pattern.find("...", begin);
          return "a whole number from " + pattern.substr(begin, dots - begin) +
                 " to " +
                 pattern.substr(dots + 3, pattern.find(' ', dots) - (dots + 3));
        }
      if (starts_with("[List"))
        {
          const std::size_t length = pattern.rfind("of length ") + 10;
          if (pattern.compare(length, 5, "1...3") == 0)
            return "one number, or three with commas between them";
          return pattern.substr(length, pattern.find("...", length) - length) +
                 " numbers with commas between them";
        }
      const std::vector<std::string> choices = choices_of(pattern);
      return choices.empty() ? "text" : enumeration(choices);
    }

    ParameterDeclaration
    declaration(const std::string            &section,
                const std::string            &name,
                const nlohmann::ordered_json &entry)
    {
      ParameterDeclaration result;
      result.section                  = section;
      result.name                     = name;
      result.value                    = entry["value"];
      result.default_value            = entry["default_value"];
      const std::string documentation = entry["documentation"];
      const std::string pattern       = entry["pattern_description"];
      const std::size_t unit          = documentation.rfind(" Units: ");
      result.documentation            = documentation.substr(0, unit);
      if (unit != std::string::npos)
        result.unit =
          documentation.substr(unit + 8, documentation.size() - unit - 9);
      result.expected = in_words(pattern);
      result.choices  = choices_of(pattern);
      return result;
    }

    // "Material granite" -> "Material NAME", for the kind "Material".
    std::string
    generic(const std::string &section, const std::vector<std::string> &kinds)
    {
      for (const std::string &kind : kinds)
        if (section.compare(0, kind.size() + 1, kind + " ") == 0)
          return kind + " NAME";
      return section;
    }

    // Names without repetition, in their order.
    void
    add_once(std::vector<std::string> &names, const std::string &name)
    {
      if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
    }

    // The end of a message about a subsection that does not exist.
    std::string
    about_section(const std::string                       &section,
                  const std::vector<std::string>          &kinds,
                  const std::vector<ParameterDeclaration> &declared)
    {
      for (const std::string &kind : kinds)
        if (section == kind)
          return "unknown subsection \"" + section +
                 "\": it needs a name, as in \"" + kind + " NAME\".";
      const std::size_t slash = section.find('/');
      if (slash != std::string::npos)
        return "subsection \"" + section.substr(slash + 1) +
               "\" stands inside \"" + section.substr(0, slash) +
               "\", where there are none. Is an \"end\" missing before it?";

      // Named subsections are compared in full and by their first word.
      std::vector<std::string> full, known = {};
      for (const ParameterDeclaration &entry : declared)
        if (!entry.section.empty())
          {
            add_once(full, entry.section);
            add_once(known, generic(entry.section, kinds));
          }
      for (const std::string &kind : kinds)
        add_once(known, kind + " NAME");
      const std::string nearest = nearest_name(section, full);
      const std::string first   = section.substr(0, section.find(' '));
      const std::string kind    = nearest_name(first, kinds);
      const std::string start   = "unknown subsection \"" + section + "\".";
      if (!nearest.empty())
        return start + " Did you mean \"" + nearest + "\"?";
      if (kind == first)
        {
          // Only the command line can name what is not in the scene.
          std::vector<std::string> same_kind;
          for (const std::string &other : full)
            if (generic(other, kinds) == generic(section, kinds))
              same_kind.push_back("\"" + other + "\"");
          return start + " The scene has " +
                 (same_kind.empty() ? "no " + kind + " at all" :
                                      enumeration(same_kind, "and")) +
                 ".";
        }
      if (!kind.empty() && first != section)
        return start + " Did you mean \"" + kind +
               section.substr(first.size()) + "\"?";
      return start + " Known are " + enumeration(known, "and") + ".";
    }

    // The end of a message about an entry that does not exist.
    std::string
    about_name(const ParameterEntry                    &entry,
               const std::vector<std::string>          &kinds,
               const std::vector<ParameterDeclaration> &declared)
    {
      std::vector<std::string> here, elsewhere;
      for (const ParameterDeclaration &other : declared)
        if (other.section == entry.section)
          here.push_back(other.name);
        else if (other.name == entry.name)
          add_once(elsewhere,
                   other.section.empty() ?
                     "the top level" :
                     "subsection " + generic(other.section, kinds));
      const std::string unknown = "unknown parameter \"" + entry.name + "\".";
      if (entry.is_override && entry.section.empty())
        for (const ParameterDeclaration &other : declared)
          if (other.section + " " + other.name == entry.name)
            return unknown + " Write Section/Name=value; did you mean \"" +
                   other.section + "/" + other.name + "\"?";
      return elsewhere.empty() ?
               unknown + suggestion(entry.name, here) :
               unknown + " It belongs in " + enumeration(elsewhere) + ".";
    }

    void
    set(const ParameterEntry       &entry,
        const ParameterDeclaration &declared,
        ParameterHandler           &prm)
    {
      if (!entry.section.empty())
        prm.enter_subsection(entry.section);
      try
        {
          prm.set(entry.name, entry.value);
        }
      catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
        {
          const std::string nearest =
            nearest_name(entry.value, declared.choices);
          throw InputError(
            place_of(entry) + ": this should be " + declared.expected + "." +
            (nearest.empty() ? "" : " Did you mean \"" + nearest + "\"?"));
        }
      if (!entry.section.empty())
        prm.leave_subsection();
    }
  } // namespace

  std::vector<ParameterDeclaration>
  declarations(const ParameterHandler &prm)
  {
    // Printing is the only access to the declarations that deal.II offers.
    std::ostringstream text;
    prm.print_parameters(text,
                         ParameterHandler::JSON |
                           ParameterHandler::KeepDeclarationOrder);
    const auto tree = nlohmann::ordered_json::parse(text.str());
    std::vector<ParameterDeclaration> result;
    for (const auto &[name, node] : tree.items())
      if (node.contains("pattern"))
        result.push_back(declaration("", name, node));
      else
        for (const auto &[entry_name, entry] : node.items())
          result.push_back(declaration(name, entry_name, entry));
    return result;
  }

  namespace
  {
    /** The patterns accept numbers that have no place in a double. */
    void
    check_range(const ParameterEntry &entry)
    {
      for (const std::string &text :
           dealii::Utilities::split_string_list(entry.value))
        {
          char *end = nullptr;
          errno     = 0;
          std::strtod(text.c_str(), &end);
          if (errno == ERANGE && *end == '\0')
            throw InputError(place_of(entry) +
                             ": this number is too small or too large for any "
                             "computation.");
        }
    }
  } // namespace

  void
  apply(const ParameterFile            &file,
        const std::vector<std::string> &kinds,
        ParameterHandler               &prm)
  {
    const std::vector<ParameterDeclaration> declared = declarations(prm);
    const auto has_section = [&](const std::string &section) {
      return section.empty() ||
             std::any_of(declared.begin(), declared.end(), [&](const auto &d) {
               return d.section == section;
             });
    };
    for (const ParameterSection &section : file.sections())
      if (!has_section(section.path))
        throw InputError(section.file + ":" + std::to_string(section.line) +
                         ": " + about_section(section.path, kinds, declared));
    for (const ParameterEntry &entry : file.entries())
      {
        if (!has_section(entry.section))
          throw InputError(place_of(entry) + ": " +
                           about_section(entry.section, kinds, declared));
        const auto match =
          std::find_if(declared.begin(), declared.end(), [&](const auto &d) {
            return d.section == entry.section && d.name == entry.name;
          });
        if (match == declared.end())
          throw InputError(place_of(entry) + ": " +
                           about_name(entry, kinds, declared));
        check_range(entry);
        set(entry, *match, prm);
      }
  }

  std::vector<double>
  get_numbers(const ParameterHandler &prm, const std::string &name)
  {
    return dealii::Utilities::string_to_double(
      dealii::Utilities::split_string_list(prm.get(name)));
  }

  std::string
  get_function(const dealii::ParameterHandler &prm,
               const std::string              &section,
               const std::string              &name,
               const ParameterFile            &file)
  {
    const std::string text = prm.get(name);
    return ends_with(text, ".csv") ? file.resolve(section, name, text) : text;
  }

  void
  check_function(const std::string &section,
                 const std::string &name,
                 const std::string &function)
  {
    if (ends_with(function, ".csv") &&
        !std::filesystem::is_regular_file(function))
      throw ParameterError(section,
                           name,
                           "there is no file \"" + function +
                             "\". Paths are relative to the .prm.");
  }

  std::array<double, 3>
  get_vector(const ParameterHandler &prm, const std::string &name)
  {
    const std::vector<double> numbers = get_numbers(prm, name);
    return {{numbers.at(0), numbers.at(1), numbers.at(2)}};
  }

  void
  declare_vector(ParameterHandler            &prm,
                 const std::string           &name,
                 const std::array<double, 3> &default_value,
                 const std::string           &documentation)
  {
    prm.declare_entry(name,
                      to_text(default_value[0]) + ", " +
                        to_text(default_value[1]) + ", " +
                        to_text(default_value[2]),
                      Patterns::List(Patterns::Double(), 3, 3),
                      documentation);
  }

  void
  declare_number(ParameterHandler  &prm,
                 const std::string &name,
                 const double       default_value,
                 const std::string &documentation)
  {
    prm.declare_entry(name,
                      to_text(default_value),
                      Patterns::Double(),
                      documentation);
  }
} // namespace rift
