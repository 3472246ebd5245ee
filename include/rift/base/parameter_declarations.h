#ifndef rift_base_parameter_declarations_h
#define rift_base_parameter_declarations_h

#include <rift/base/parameter_file.h>

#include <array>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /** One declared entry of a ParameterHandler, in words for the user. */
  struct ParameterDeclaration
  {
    /** Subsection; empty at the top level. */
    std::string section;

    /** Of the entry: its name, value and default value. */
    std::string name;
    std::string value;
    std::string default_value;

    /** Meaning, without the unit. */
    std::string documentation;

    /** Unit, from the "Units: X." at the end of the documentation. */
    std::string unit;

    /** What may be written: "a number", "file, box or cylinder". */
    std::string expected;

    /** The words of a selection; empty for all other kinds of entries. */
    std::vector<std::string> choices;
  };

  /** All entries in the order of their declaration. */
  std::vector<ParameterDeclaration>
  declarations(const dealii::ParameterHandler &prm);

  /**
   * Sets the entries of a scene. `kinds` are the first words of subsections
   * that the user names (`Material` for `Material granite`).
   *
   * Throws InputError for subsections and entries that have not been declared,
   * with the nearest name that has, and for values that do not fit their
   * declaration; with file, line and what is expected.
   */
  void
  apply(const ParameterFile            &file,
        const std::vector<std::string> &kinds,
        dealii::ParameterHandler       &prm);

  /** The numbers of a list of the current subsection, of any length. */
  std::vector<double>
  get_numbers(const dealii::ParameterHandler &prm, const std::string &name);

  /** The three numbers of a list of the current subsection. */
  std::array<double, 3>
  get_vector(const dealii::ParameterHandler &prm, const std::string &name);

  /**
   * The text of a function of time in the current subsection: an expression, or
   * the path of a .csv table, from the folder that `file` tells.
   */
  std::string
  get_function(const dealii::ParameterHandler &prm,
               const std::string              &section,
               const std::string              &name,
               const ParameterFile            &file);

  /** Throws ParameterError if a function is a table that does not exist. */
  void
  check_function(const std::string &section,
                 const std::string &name,
                 const std::string &function);

  /**
   * Declares three numbers in the current subsection. The documentation ends
   * with "Units: X.".
   */
  void
  declare_vector(dealii::ParameterHandler    &prm,
                 const std::string           &name,
                 const std::array<double, 3> &default_value,
                 const std::string           &documentation);

  /** Declares a number in the current subsection, with all of its digits. */
  void
  declare_number(dealii::ParameterHandler &prm,
                 const std::string        &name,
                 double                    default_value,
                 const std::string        &documentation);
} // namespace rift

#endif
