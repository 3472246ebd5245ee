#ifndef rift_base_warning_h
#define rift_base_warning_h

#include <string>

namespace rift
{
  /** A sentence about something that may be found again and again, with other
   * numbers: of one subject the user is to hear once. */
  struct Warning
  {
    /** How the sentence begins, without numbers that change. */
    std::string subject;

    /** How it goes on. */
    std::string statement;
  };
} // namespace rift

#endif
