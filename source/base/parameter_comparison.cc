#include <rift/base/number_text.h>
#include <rift/base/parameter_comparison.h>
#include <rift/base/parameter_text.h>

#include <algorithm>
#include <sstream>

namespace rift
{
  namespace
  {
    /** An entry of a .prm; its path is the subsections and the name, joined by
     * `/`. */
    struct Entry
    {
      std::string path, section, value;
    };

    using Entries = std::vector<Entry>;

    Entries
    entries_of(const std::string &text)
    {
      Entries                  result;
      std::vector<std::string> sections;
      std::istringstream       lines(text);
      for (std::string raw; std::getline(lines, raw);)
        {
          const std::string line(trim(raw));
          const auto        equals = line.find('=');
          if (line.compare(0, 11, "subsection ") == 0)
            sections.emplace_back(trim(line.substr(11)));
          else if (line == "end" && !sections.empty())
            sections.pop_back();
          else if (line.compare(0, 4, "set ") == 0 &&
                   equals != std::string::npos)
            {
              std::string section;
              for (const std::string &one : sections)
                section += one + "/";
              result.push_back(
                {section + std::string(trim(line.substr(4, equals - 4))),
                 section,
                 std::string(trim(line.substr(equals + 1)))});
            }
        }
      return result;
    }

    // "Section / Name", as in other messages about parameters.
    std::string
    spaced(const std::string &path)
    {
      std::string result;
      for (const char c : path)
        result += c == '/' ? std::string(" / ") : std::string(1, c);
      return result;
    }

    /** The entry of this path; null if there is none. */
    const Entry *
    find(const Entries &entries, const std::string &path)
    {
      const auto entry =
        std::find_if(entries.begin(), entries.end(), [&](const Entry &e) {
          return e.path == path;
        });
      return entry == entries.end() ? nullptr : &*entry;
    }

    bool
    has_section(const Entries &entries, const std::string &section)
    {
      return section.empty() ||
             std::any_of(entries.begin(), entries.end(), [&](const Entry &e) {
               return e.section == section;
             });
    }

    std::string
    section_text(const Entry &entry)
    {
      return "The subsection \"" +
             spaced(entry.section.substr(0, entry.section.size() - 1)) + "\"";
    }

    bool
    is_listed(const std::string &path, const std::vector<std::string> &list)
    {
      return std::any_of(list.begin(), list.end(), [&](const auto &listed) {
        return path == listed ||
               path.compare(0, listed.size() + 1, listed + "/") == 0;
      });
    }
  } // namespace

  std::vector<std::string>
  parameter_differences(const std::string              &here,
                        const std::string              &in_checkpoint,
                        const std::vector<std::string> &may_differ)
  {
    const Entries ours = entries_of(here), theirs = entries_of(in_checkpoint);

    std::vector<std::string> result;
    const auto               add = [&](const std::string &sentence) {
      // Of a subsection that is missing each entry says the same.
      if (std::find(result.begin(), result.end(), sentence) == result.end())
        result.push_back(sentence);
    };
    for (const Entry &entry : ours)
      {
        const Entry *other = find(theirs, entry.path);
        if (is_listed(entry.path, may_differ))
          continue;
        if (!has_section(theirs, entry.section))
          add(section_text(entry) + " is here, but not in the checkpoint");
        else if (other == nullptr)
          add(spaced(entry.path) + " is " + entry.value +
              " here and not set in the checkpoint");
        else if (other->value != entry.value)
          add(spaced(entry.path) + " is " + entry.value + " here and " +
              other->value + " in the checkpoint");
      }
    for (const Entry &entry : theirs)
      {
        if (is_listed(entry.path, may_differ))
          continue;
        if (!has_section(ours, entry.section))
          add(section_text(entry) + " is not here, but in the checkpoint");
        else if (find(ours, entry.path) == nullptr)
          add(spaced(entry.path) + " is not set here and " + entry.value +
              " in the checkpoint");
      }
    return result;
  }
} // namespace rift
