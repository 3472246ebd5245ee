// Preloaded under valgrind, which always rounds to the nearest number: a check
// of CGAL's that rounding can be set, when libdeal.ii is loaded, would end the
// program. rift does not use CGAL.
namespace CGAL
{
  void
  assertion_fail(const char *, const char *, int, const char *)
  {
  }
} // namespace CGAL
