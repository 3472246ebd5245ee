#ifndef rift_contact_contact_parameters_h
#define rift_contact_contact_parameters_h

#include <rift/base/parameter_errors.h>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /** Contact: subsection `Contact` of the .prm. */
  struct ContactParameters
  {
    /** When there is contact. */
    enum class Mode
    {
      automatic,
      on,
      off
    };

    /** The entry Contact. */
    Mode mode = Mode::automatic;

    /**
     * Whether there is contact.
     *
     * @param can_break whether faces may open.
     * @param n_bodies number of bodies of the mesh that nothing connects.
     */
    bool
    is_active(const bool can_break, const std::int64_t n_bodies) const
    {
      return mode == Mode::on ||
             (mode == Mode::automatic && (can_break || n_bodies > 1));
    }

    /** Coefficient of friction between all materials... */
    double friction = .6;

    /** ... but these. */
    struct PairFriction
    {
      /** Names of two materials, and the coefficient of friction between
       * them. */
      std::string first, second;
      double      coefficient;
    };

    /** The pairs of materials that the scene names. */
    std::vector<PairFriction> pair_frictions;

    /** Damping of approach and parting over the critical one; 0: none. */
    double damping = 0;

    /**
     * Room that the time step leaves for contact: the square of the largest
     * frequency of a loose cell may grow by three times this factor. Penalties
     * are as large as that allows.
     */
    double stiffness_factor = .25;

    /** Declares the entries of subsection Contact. */
    static void
    declare(dealii::ParameterHandler &prm);

    /** Reads subsection Contact. */
    static ContactParameters
    parse(dealii::ParameterHandler &prm);

    /** Throws ParameterError for a negative friction, for damping outside of
     * [0, 0.3] and for a factor below 0.001. */
    void
    check() const;

    /** That the pairs name materials that there are, each pair once. */
    void
    check_pairs(const std::vector<std::string> &materials) const;

    /** What has no effect without contact. */
    std::vector<InertEntries>
    inert_entries() const;

    /** Of two materials. */
    double
    friction_of(const std::string &first, const std::string &second) const;
  };
} // namespace rift

#endif
