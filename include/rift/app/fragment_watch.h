#ifndef rift_app_fragment_watch_h
#define rift_app_fragment_watch_h

#include <rift/app/body.h>
#include <rift/discretization/fragments.h>

namespace rift
{
  /**
   * Finds out when pieces of the body do what no rock does: move faster than
   * waves could have driven them, or pass through each other. Says so once.
   */
  class FragmentWatch
  {
  public:
    /** @param body must outlive this object.
     * @param has_contact whether contact keeps pieces apart. */
    FragmentWatch(const Body &body, bool has_contact);

    /** Warnings before the first step. Collective. */
    std::vector<std::string>
    warnings_at_start() const;

    /** New warnings about the pieces as they are now. Collective. */
    std::vector<std::string>
    look(const Fragments &fragments);

    /**
     * Largest speed that is expected of a fragment, m/s: a tenth of the speed
     * of P-waves, which takes strains of a tenth, plus twice the largest speed
     * at the start, which a light body gets from a heavy one.
     */
    double
    largest_speed() const
    {
      return speed_limit;
    }

  private:
    std::string
    warning_of_speed(const Fragments &fragments) const;

    std::string
    warning_of_interpenetration() const;

    const Body &body;
    const bool  has_contact;
    double      speed_limit;
    bool        has_warned_of_speed            = false;
    bool        has_warned_of_interpenetration = false;
  };
} // namespace rift

#endif
