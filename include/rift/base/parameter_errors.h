#ifndef rift_base_parameter_errors_h
#define rift_base_parameter_errors_h

#include <rift/base/exceptions.h>

#include <string>
#include <utility>
#include <vector>

namespace rift
{
  /**
   * A value of the scene that cannot be meant. Thrown by the `parse` and
   * `check` functions of the parameter structures, which know the subsection
   * and the name of the entry but not where it has been set; read_parameters()
   * completes the message with file, line and text (ParameterFile::describe()).
   */
  class ParameterError : public InputError
  {
  public:
    /** `problem` says what is wrong and what to do, without a location. */
    ParameterError(const std::string &section,
                   const std::string &name,
                   const std::string &problem)
      : InputError(section + "/" + name + ": " + problem)
      , section(section)
      , name(name)
      , problem(problem)
    {
    }

    /** Subsection, as in `Material granite`. */
    const std::string section;

    /** Entry of the subsection. */
    const std::string name;

    /** What is wrong with the value, a clause. */
    const std::string problem;
  };

  /**
   * Entries that have no effect because of the value of others. They must not
   * be set in a scene, and are left out where its values are written.
   */
  struct InertEntries
  {
    /** Subsection in which the entries are. */
    std::string section;

    /** Names of the entries without effect. */
    std::vector<std::string> names;

    /** Subsection and name of the entries that decide about it. */
    std::vector<std::pair<std::string, std::string>> causes;

    /** For the message: "has no effect ", followed by this. */
    std::string reason;
  };
} // namespace rift

#endif
