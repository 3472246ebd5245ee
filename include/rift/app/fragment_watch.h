#ifndef rift_app_fragment_watch_h
#define rift_app_fragment_watch_h

#include <rift/app/body.h>
#include <rift/base/warning.h>
#include <rift/discretization/fragments.h>

namespace rift
{
  /**
   * Looks for pieces of the body that are improbably fast or overlap each
   * other.
   */
  class FragmentWatch
  {
  public:
    /**
     * @param body must outlive this object.
     * @param has_contact whether contact keeps pieces apart.
     * @param loads_follow whether no load acts on what has left its place.
     */
    FragmentWatch(const Body &body, bool has_contact, bool loads_follow);

    /** About separate bodies, before the first step. Collective. */
    std::vector<Warning>
    warnings_at_start() const;

    /** About the pieces as they are now. Collective. */
    std::vector<Warning>
    look(const Fragments &fragments) const;

  private:
    std::vector<Warning>
    warnings_of_speed(const Fragments &fragments) const;

    std::vector<Warning>
    warnings_of_overlap() const;

    const Body &body;
    const bool  has_contact, loads_follow;

    /**
     * Largest speed that is expected of a fragment, m/s: a tenth of the largest
     * speed of P-waves along the axes, which takes strains of a tenth, plus
     * twice the largest initial speed, which a light body gets from a heavy
     * one. A rule of thumb: velocities that are prescribed later do not count.
     */
    const double largest_speed;
  };
} // namespace rift

#endif
