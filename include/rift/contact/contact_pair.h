#ifndef rift_contact_contact_pair_h
#define rift_contact_contact_pair_h

#include <rift/contact/overlap.h>

namespace rift
{
  /** Where the corners of a cell are, m, and their velocities, m/s. */
  struct CellMotion
  {
    /** Of the four corners. */
    Tetrahedron                    positions;
    std::array<Vector3<double>, 4> velocities;
  };

  /** What two cells that touch depend on. */
  struct ContactConstants
  {
    /** Penalty, Pa: what one unit of potential is worth. */
    double penalty;

    /** Coefficient of friction. */
    double friction;

    /** Damping of the approach over the critical one, and the reduced mass of
     * the two cells, kg, for which that is meant. */
    double damping, mass;
  };

  /** What a pair of cells remembers. All is zero as long as they are apart. */
  struct ContactMemory
  {
    /**
     * Potential, m^3, up to which the overlap has no force: what there was of
     * it when the pair came into being, or the least since.
     */
    double initial_potential = 0;

    /** Elongation, m, and stiffness, N/m, of the spring of friction. */
    Vector3<double> slip{};
    double          stiffness = 0;

    /** Force of the damper, N: positive where it parts the cells. */
    double damping_force = 0;
  };

  /** What a pair does in a step. */
  struct ContactForces
  {
    /** Whether they overlap; all else is zero if not, but for losses. */
    bool touches = false;

    /** Whether so deep that the potential will soon fall again: the mean of
     * least coordinates over the overlap is above `largest_mean_potential`, or
     * more than `largest_volume_fraction` of a cell is inside of the other. Not
     * of pairs that were born with an overlap. */
    bool is_too_deep = false;

    /** Forces on the corners of both cells, N. */
    std::array<Vector3<double>, 4> on_a{}, on_b{};

    /** Elastic energies of overlap and spring now, J. */
    double energy = 0;

    /** Energies that friction and damping have used up since the step before,
     * J. */
    double friction_loss = 0, damping_loss = 0;
  };

  /** Of faces that lie flat upon each other, the depth over the height. The
   * potential is largest at a quarter. */
  constexpr double largest_mean_potential = .15;

  /** Of a cell so deep inside of a larger one that it may be pushed along where
   * the potential of that one is zero. */
  constexpr double largest_volume_fraction = .9;

  /** Stiffness of the spring of friction over that of the overlap (Xiang,
   * Latham & Farsi 2016). */
  constexpr double friction_stiffness_ratio = 2. / 7;

  /**
   * Contact of two tetrahedra (doc/theory.md, section 8).
   *
   * Overlap costs the energy p (sqrt(Phi) - sqrt(Phi_0))^2, eq. 26: of an
   * overlap from the outside, Phi_0 = 0, this is Munjiza's potential contact,
   * and a pair that comes into being with an overlap starts with neither energy
   * nor force. The forces are the derivatives of this energy.
   *
   * Friction is a spring between the points of the two cells at the centroid of
   * the overlap, whose force is not larger than the coefficient times that of
   * the overlap (Coulomb). Its stiffness is `friction_stiffness_ratio` times that
   * of the overlap.
   *
   * Damping resists the approach of the two cells and their parting, at most
   * with what makes the overlap free of force: it never pulls.
   *
   * @param time_step since the memory was updated last, s; 0 at the start.
   */
  ContactForces
  pair_forces(const CellMotion       &a,
              const CellMotion       &b,
              const ContactConstants &constants,
              double                  time_step,
              ContactMemory          &memory);
} // namespace rift

#endif
