#include <rift/base/number_text.h>

#include <charconv>

namespace rift
{
  std::string
  to_text(const double value)
  {
    // The sign of a nan means nothing.
    if (value != value)
      return "nan";
    char       buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr;
    return std::string(buffer, end);
  }

  bool
  from_text(std::string_view text, double &value)
  {
    text = trim(text);
    // std::from_chars knows no plus sign.
    if (text.size() > 1 && text[0] == '+' && text[1] != '-')
      text.remove_prefix(1);

    double     number = 0;
    const auto end    = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    if (result.ec != std::errc() || result.ptr != end)
      return false;
    value = number;
    return true;
  }

  std::string_view
  trim(const std::string_view text)
  {
    constexpr const char *blanks = " \t\r\n";
    const auto            begin  = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos)
      return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
  }
} // namespace rift
