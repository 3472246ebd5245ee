#ifndef rift_base_parameter_text_h
#define rift_base_parameter_text_h

#include <string>
#include <vector>

/**
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

  /** The text, printable and cut to what fits in a message. */
  std::string
  excerpt(const std::string &text);

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

  /** " Did you mean "X"?", or else " Known are X, Y and Z.", for messages. */
  std::string
  suggestion(const std::string              &name,
             const std::vector<std::string> &candidates);
} // namespace rift

#endif
