#include <rift/base/parameter_text.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <numeric>
#include <sstream>

namespace rift
{
  namespace
  {
    std::string
    lower_case(std::string text)
    {
      for (char &c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return text;
    }

    // Levenshtein's distance, row by row.
    std::size_t
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 1; i <= a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i;
          for (std::size_t j = 1; j <= b.size(); ++j)
            {
              const std::size_t replaced =
                diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
              diagonal = row[j];
              row[j]   = std::min({row[j] + 1, row[j - 1] + 1, replaced});
            }
        }
      return row.back();
    }

    /**
     * How many bytes the character of UTF-8 at `i` has, 0 if there is none: as
     * the first byte says, if the others continue it, and if it is neither
     * longer than need be, half of a pair of UTF-16, nor beyond Unicode.
     */
    std::size_t
    utf8_length(const std::string &text, const std::size_t i)
    {
      const auto byte = [&](const std::size_t j) {
        return static_cast<unsigned char>(j < text.size() ? text[j] : 0);
      };
      const unsigned int first  = byte(i);
      const std::size_t  length = first < 0x80                  ? 1 :
                                  first >= 0xc2 && first < 0xe0 ? 2 :
                                  first >= 0xe0 && first < 0xf0 ? 3 :
                                  first >= 0xf0 && first < 0xf5 ? 4 :
                                                                  0;
      for (std::size_t j = 1; j < length; ++j)
        if ((byte(i + j) & 0xc0) != 0x80)
          return 0;
      const unsigned int second = byte(i + 1);
      if ((first == 0xe0 && second < 0xa0) ||
          (first == 0xed && second > 0x9f) ||
          (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
        return 0;
      return length;
    }

    bool
    is_printable(const std::string &text, const std::size_t i)
    {
      return utf8_length(text, i) > 0 &&
             !std::iscntrl(static_cast<unsigned char>(text[i]));
    }
  } // namespace

  std::string
  short_text(const double number)
  {
    char buffer[40];
    std::snprintf(buffer, sizeof(buffer), "%.4g", number);
    return buffer;
  }

  std::string
  simplified(const std::string &text)
  {
    std::istringstream words(text);
    std::string        word, result;
    while (words >> word)
      result += (result.empty() ? "" : " ") + word;
    return result;
  }

  std::size_t
  find_invalid_utf8(const std::string &text)
  {
    for (std::size_t i = 0; i < text.size();)
      {
        const std::size_t length = utf8_length(text, i);
        if (length == 0)
          return i;
        i += length;
      }
    return std::string::npos;
  }

  std::string
  excerpt(const std::string &text)
  {
    constexpr std::size_t longest = 60;
    std::string           result;
    std::size_t           i = 0;
    while (i < text.size())
      {
        const std::size_t length =
          std::max<std::size_t>(utf8_length(text, i), 1);
        if (i + length > longest)
          return result + "...";
        result += is_printable(text, i) ? text.substr(i, length) : "?";
        i += length;
      }
    return result;
  }

  std::string
  name_problem(const std::string &name)
  {
    constexpr const char *forbidden = "/#,;\"'[]{}()=\\";
    if (find_invalid_utf8(name) != std::string::npos)
      return "a name must be UTF-8";
    if (name.find_first_of(forbidden) != std::string::npos)
      return "a name cannot have any of / # , ; \" ' [ ] { } ( ) = \\ in it";
    return "";
  }

  std::vector<std::string>
  split(const std::string &text, const char separator)
  {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin < text.size();)
      {
        const std::size_t end =
          std::min(text.find(separator, begin), text.size());
        parts.push_back(simplified(text.substr(begin, end - begin)));
        begin = end + 1;
      }
    return parts;
  }

  bool
  ends_with(const std::string &text, const std::string &ending)
  {
    return text.size() >= ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) ==
             0;
  }

  std::string
  enumeration(const std::vector<std::string> &words, const std::string &last)
  {
    std::string result;
    for (std::size_t i = 0; i < words.size(); ++i)
      result +=
        (i == 0 ? "" : (i + 1 == words.size() ? " " + last + " " : ", ")) +
        words[i];
    return result;
  }

  std::string
  nearest_name(const std::string              &name,
               const std::vector<std::string> &candidates)
  {
    const std::string wanted = lower_case(name);
    std::string       nearest;
    std::size_t       smallest = std::string::npos;
    for (const std::string &candidate : candidates)
      {
        const std::string known = lower_case(candidate);
        // An abbreviation is near however much has been left out.
        const bool part =
          wanted.size() >= 3 && known.find(wanted) != std::string::npos;
        const std::size_t distance = part ? 1 : edit_distance(wanted, known);
        const std::size_t largest =
          std::max<std::size_t>(2, std::min(wanted.size(), known.size()) / 3);
        if (distance < smallest && distance <= largest &&
            distance < std::max(wanted.size(), known.size()))
          {
            smallest = distance;
            nearest  = candidate;
          }
      }
    return nearest;
  }

  std::string
  suggestion(const std::string              &name,
             const std::vector<std::string> &candidates,
             const std::string              &if_none)
  {
    if (candidates.empty())
      return " " + if_none;
    const std::string nearest = nearest_name(name, candidates);
    if (!nearest.empty())
      return " Did you mean \"" + nearest + "\"?";
    return " Known are " + enumeration(candidates, "and") + ".";
  }
} // namespace rift
