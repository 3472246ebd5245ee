#ifndef rift_base_parameter_text_h
#define rift_base_parameter_text_h

#include <cstddef>
#include <string>
#include <vector>

/**
 * @file
 *
 * Small work on the words of a .prm and of messages about it.
 */
namespace rift
{
  /** Four significant digits, for messages. */
  std::string
  short_text(double number);

  /** Without white space at both ends and with single blanks inside. */
  std::string
  simplified(const std::string &text);

  /**
   * Where the first byte stands that does not belong to a character of UTF-8;
   * npos if all is well.
   */
  std::size_t
  find_invalid_utf8(const std::string &text);

  /** The text, printable UTF-8 and cut to what fits in a message. */
  std::string
  excerpt(const std::string &text);

  /**
   * What is wrong with a name for a Material, Boundary or Probe, for messages:
   * it is no UTF-8, or has a character with a meaning in a scene, on the command
   * line or in the header of a table. Empty if it is good.
   */
  std::string
  name_problem(const std::string &name);

  /** The parts between separators, simplified; none of an empty text. */
  std::vector<std::string>
  split(const std::string &text, char separator);

  /** Whether `text` ends with `ending`, as in `pulse.csv` and `.csv`. */
  bool
  ends_with(const std::string &text, const std::string &ending);

  /** "a", "a or b", "a, b or c", with the last word joined by `last`. */
  std::string
  enumeration(const std::vector<std::string> &words,
              const std::string              &last = "or");

  /**
   * The one of `candidates` that a user who wrote `name` has probably meant:
   * the smallest number of letters to insert, delete or replace, small and
   * capital letters being the same. Empty if none is similar.
   */
  std::string
  nearest_name(const std::string              &name,
               const std::vector<std::string> &candidates);

  /**
   * For messages: " Did you mean "X"?", or else " Known are X, Y and Z.", or
   * `if_none` after a blank where there are no candidates.
   */
  std::string
  suggestion(const std::string              &name,
             const std::vector<std::string> &candidates,
             const std::string              &if_none = "There are none.");
} // namespace rift

#endif
