#include <rift/base/number_text.h>
#include <rift/base/parameter_comparison.h>
#include <rift/base/parameter_text.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace rift
{
  namespace
  {
    // Subsections and name, joined by `/`, with the value.
    using Entries = std::vector<std::pair<std::string, std::string>>;

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
              std::string path;
              for (const std::string &section : sections)
                path += section + "/";
              path += trim(line.substr(4, equals - 4));
              result.emplace_back(path, trim(line.substr(equals + 1)));
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
    const std::map<std::string, std::string> our_values(ours.begin(),
                                                        ours.end()),
      their_values(theirs.begin(), theirs.end());

    std::vector<std::string> result;
    for (const auto &[path, value] : ours)
      {
        const auto other = their_values.find(path);
        if (is_listed(path, may_differ))
          continue;
        if (other == their_values.end())
          result.push_back(spaced(path) + " is " + value +
                           " here and not set in the checkpoint");
        else if (other->second != value)
          result.push_back(spaced(path) + " is " + value + " here and " +
                           other->second + " in the checkpoint");
      }
    for (const auto &[path, value] : theirs)
      if (our_values.count(path) == 0 && !is_listed(path, may_differ))
        result.push_back(spaced(path) + " is not set here and " + value +
                         " in the checkpoint");
    return result;
  }
} // namespace rift
