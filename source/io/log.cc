#include <rift/base/exceptions.h>
#include <rift/io/log.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <ostream>

namespace rift
{
  namespace
  {
    /** Takes an ANSI terminal to the start of its line, and empties it. */
    constexpr const char *clear_line = "\r\033[K";

    const std::string warning_mark = "WARNING: ";
  } // namespace

  Log::Log(std::ostream *terminal, const bool interactive)
    : terminal(terminal)
    , interactive(terminal != nullptr && interactive)
  {
  }

  void
  Log::open(const std::string &path)
  {
    take(std::make_unique<OutputFile>(path));
  }

  void
  Log::reopen(const std::string &path)
  {
    std::ifstream earlier(path);
    for (std::string line; std::getline(earlier, line);)
      if (line.compare(0, warning_mark.size(), warning_mark) == 0)
        remember_warning(line.substr(warning_mark.size()));
    std::error_code error;
    const auto      size = std::filesystem::file_size(path, error);
    take(error ? std::make_unique<OutputFile>(path) :
                 std::make_unique<OutputFile>(path, size));
  }

  void
  Log::take(std::unique_ptr<OutputFile> new_file)
  {
    file = std::move(new_file);
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
    if (!file)
      {
        earlier_lines += line + '\n';
        return;
      }
    try
      {
        file->write(line + '\n');
      }
    catch (const DiskError &error)
      {
        failure = error.what();
      }
  }

  void
  Log::warn(const std::string &text)
  {
    remember_warning(text);
    write(warning_mark + text);
  }

  void
  Log::warn_once(const Warning &warning)
  {
    const std::string &subject = warning.subject;
    if (std::none_of(all_warnings.begin(),
                     all_warnings.end(),
                     [&](const std::string &text) {
                       return text.compare(0, subject.size(), subject) == 0;
                     }))
      warn(subject + warning.statement);
  }

  void
  Log::remember_warning(const std::string &text)
  {
    if (std::find(all_warnings.begin(), all_warnings.end(), text) ==
        all_warnings.end())
      all_warnings.push_back(text);
  }

  void
  Log::check() const
  {
    if (has_failed())
      throw DiskError(failure);
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
