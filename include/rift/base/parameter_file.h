#ifndef rift_base_parameter_file_h
#define rift_base_parameter_file_h

#include <rift/base/parameter_errors.h>

#include <string>
#include <vector>

namespace rift
{
  /** One `set NAME = VALUE` of a .prm, or one `--set` of the command line. */
  struct ParameterEntry
  {
    /** Path of subsections, joined by `/`; empty at the top level. */
    std::string section;

    /** Of the entry: its name and value. */
    std::string name;
    std::string value;

    /** Where it stands; an override stands in no file and has no line. */
    std::string  file;
    unsigned int line = 0;

    /** Whether it comes from the command line. */
    bool is_override = false;
  };

  /** One `subsection` of a .prm. */
  struct ParameterSection
  {
    /** Path of subsections, joined by `/`. */
    std::string path;

    /** Where it begins. */
    std::string  file;
    unsigned int line = 0;
  };

  /**
   * The text of a scene: its entries with their places, before anything is
   * known about which entries there are and what they mean.
   *
   * The syntax is that of deal.II's ParameterHandler: `subsection X` ... `end`,
   * `set NAME = VALUE`, `include FILE` (relative to the including file), `#`
   * starts a comment, and a backslash at the end of a line continues it.
   */
  class ParameterFile
  {
  public:
    /**
     * Reads a scene. Each of `overrides` is a text `Section/Name=value` and
     * takes the place of what the file says.
     *
     * Throws InputError for a file that cannot be read, a line that is none
     * of the above, a subsection without end or an end without subsection, an
     * entry set twice, and an override of another form.
     */
    explicit ParameterFile(const std::string              &path,
                           const std::vector<std::string> &overrides = {});

    /** Path of the scene as it was given. */
    const std::string &
    path() const;

    /** All entries in the order of the file, overrides in their place. */
    const std::vector<ParameterEntry> &
    entries() const;

    /** All subsections in the order of the file. */
    const std::vector<ParameterSection> &
    sections() const;

    /**
     * The names that the user has given to subsections of a kind, in the order
     * of the file: `granite` for `subsection Material granite` and the kind
     * `Material`. Throws InputError for a name that is used twice or has
     * characters that cannot stand in a CSV header or in an override.
     */
    std::vector<std::string>
    names_of(const std::string &kind) const;

    /** The entry of that name, or a null pointer if it has not been set. */
    const ParameterEntry *
    find(const std::string &section, const std::string &name) const;

    /**
     * The path that the value of an entry stands for: relative paths start
     * from the folder of the file in which the entry is set (for overrides:
     * that of the scene).
     */
    std::string
    resolve(const std::string &section,
            const std::string &name,
            const std::string &path) const;

    /** The message of an error with file, line and the text found there. */
    std::string
    describe(const ParameterError &error) const;

    /**
     * Throws ParameterError if an entry that has no effect has been set. What
     * the command line made inert is forgiven, so that a part of a model can
     * be switched off with `--set`.
     */
    void
    refuse_inert(const std::vector<InertEntries> &inert) const;

  private:
    std::string                   scene;
    std::vector<ParameterEntry>   all_entries;
    std::vector<ParameterSection> all_sections;

    void
    add_override(const std::string &text);
  };

  /** `FILE:LINE: SECTION/NAME = VALUE`, or the text of the override. */
  std::string
  place_of(const ParameterEntry &entry);
} // namespace rift

#endif
