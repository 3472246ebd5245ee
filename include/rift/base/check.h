#ifndef rift_base_check_h
#define rift_base_check_h

#ifdef RIFT_CHECKED
#include <cstdio>
#include <cstdlib>
#endif

/**
 * States what holds at this place whatever the input is, as
 * `rift_check(i < n)`. In a checked build (CMake's RIFT_CHECKED) a condition
 * that is false prints itself, its file, line and function, and aborts: an
 * error of rift is then found where it happens, not by wrong results.
 *
 * In all other builds the condition is compiled but never evaluated, so that it
 * costs nothing; it must have no effects. What a scene, a mesh or a file may
 * get wrong throws an Error instead (base/exceptions.h), in every build. A
 * number that is not finite is such an error, of the scene: conditions on the
 * state of the body must pass it.
 *
 * A condition that is evaluated on all ranks may be collective.
 */
#ifdef RIFT_CHECKED
#define rift_check(condition)           \
  ((condition) ? static_cast<void>(0) : \
                 ::rift::fail_check(#condition, __FILE__, __LINE__, __func__))
#else
#define rift_check(condition) static_cast<void>(false && (condition))
#endif

#ifdef RIFT_CHECKED
namespace rift
{
  /** Reports a condition of rift_check() that is false, and aborts. */
  [[noreturn, gnu::cold]] inline void
  fail_check(const char *condition,
             const char *file,
             const int   line,
             const char *function)
  {
    std::fprintf(stderr,
                 "%s:%d: %s: rift_check(%s) failed. This is an error in rift, "
                 "not in the scene.\n",
                 file,
                 line,
                 function,
                 condition);
    std::abort();
  }
} // namespace rift
#endif

#endif
