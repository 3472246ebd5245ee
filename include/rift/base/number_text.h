#ifndef rift_base_number_text_h
#define rift_base_number_text_h

#include <string>
#include <string_view>

/**
 * @file
 *
 * Numbers as text, the same in every locale.
 */
namespace rift
{
  /**
   * The shortest decimal text from which from_text() gives back the same
   * number, bit for bit: `0.1`, `1e-06`, `nan`.
   */
  std::string
  to_text(double value);

  /**
   * Reads a decimal number that must fill `text`, blanks around it aside.
   * Returns false, and leaves `value` alone, for anything else. `inf` and
   * `nan` are numbers here; one too large for a double is not.
   */
  bool
  from_text(std::string_view text, double &value);

  /** `text` without the blanks, tabs and line ends around it. */
  std::string_view
  trim(std::string_view text);
} // namespace rift

#endif
