#include <rift/io/log.h>

#include <unistd.h>

#include <ostream>

namespace rift
{
  namespace
  {
    /** Takes an ANSI terminal to the start of its line, and empties it. */
    constexpr const char *clear_line = "\r\033[K";
  } // namespace

  Log::Log(std::ostream *terminal, const bool interactive)
    : terminal(terminal)
    , interactive(terminal != nullptr && interactive)
  {
  }

  void
  Log::open(const std::string &path)
  {
    file = std::make_unique<OutputFile>(path);
    file->write(earlier_lines);
    earlier_lines.clear();
  }

  void
  Log::write(const std::string &line)
  {
    if (terminal != nullptr)
      {
        status("");
        *terminal << line << '\n' << std::flush;
      }
    if (file)
      file->write(line + '\n');
    else
      earlier_lines += line + '\n';
  }

  void
  Log::status(const std::string &text)
  {
    if (!interactive || (text.empty() && !status_is_shown))
      return;
    *terminal << clear_line << text << std::flush;
    status_is_shown = !text.empty();
  }

  bool
  Log::is_interactive() const
  {
    return interactive;
  }

  bool
  is_terminal()
  {
    return ::isatty(STDOUT_FILENO) == 1;
  }
} // namespace rift
