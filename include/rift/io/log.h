#ifndef rift_io_log_h
#define rift_io_log_h

#include <rift/base/output_file.h>
#include <rift/base/warning.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace rift
{
  /**
   * What rift tells its user: lines that go to the terminal and to log.txt.
   * Rank 0 has the log that speaks; the others make one without a terminal
   * and open no file.
   */
  class Log
  {
  public:
    /**
     * @param terminal    where lines are shown, such as std::cout; nullptr:
     *   nowhere, for a quiet run and for ranks other than 0.
     * @param interactive whether the terminal can rewrite its last line, as
     *   is_terminal() says.
     */
    explicit Log(std::ostream *terminal, bool interactive = false);

    /**
     * From now on lines also go to the file `path`, which begins with those
     * written before: a run can speak before it has an output directory.
     *
     * @throws DiskError if the file cannot be written.
     */
    void
    open(const std::string &path);

    /** open(), but goes on behind what is in the file: after a restart. */
    void
    reopen(const std::string &path);

    /**
     * Writes a line; `line` may itself hold several, and needs no line end.
     * It is in the file when the call returns, or the log has_failed():
     * nothing is thrown here, where the other ranks would not learn of it.
     */
    void
    write(const std::string &line);

    /** Writes a line that begins with WARNING. */
    void
    warn(const std::string &text);

    /** warn(), unless a warning with this subject has been given, also before a
     * restart. */
    void
    warn_once(const Warning &warning);

    /** The texts of all warnings so far, each once; after reopen() those in the
     * file, too. */
    const std::vector<std::string> &
    warnings() const
    {
      return all_warnings;
    }

    /** Whether a line could not be written to the file. */
    bool
    has_failed() const
    {
      return !failure.empty();
    }

    /** @throws DiskError if the log has failed. */
    void
    check() const;

    /**
     * Shows `text` in the last line of an interactive terminal, until the
     * next call of status() or write(). Does not go to the file.
     */
    void
    status(const std::string &text);

    /** Whether it writes to a terminal, which can show a bar. */
    bool
    is_interactive() const;

  private:
    void
    take(std::unique_ptr<OutputFile> new_file);

    void
    remember_warning(const std::string &text);

    std::ostream *const         terminal;
    const bool                  interactive;
    bool                        status_is_shown = false;
    std::string                 earlier_lines, failure;
    std::vector<std::string>    all_warnings;
    std::unique_ptr<OutputFile> file;
  };

  /** Whether the standard output is a terminal and not a file or a pipe. */
  bool
  is_terminal();
} // namespace rift

#endif
