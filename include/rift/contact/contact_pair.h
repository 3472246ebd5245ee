#ifndef rift_contact_contact_pair_h
#define rift_contact_contact_pair_h

#include <rift/contact/overlap_batch.h>

namespace rift
{
  /** What two cells that touch depend on. */
  struct ContactConstants
  {
    /** Penalty, Pa: what one unit of potential is worth at most. */
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
     * it when the pair started, or the least since.
     */
    double initial_potential = 0;

    /** Elongation, m, and stiffness, N/m, of the spring of friction. */
    Vector3<double> slip{};
    double          stiffness = 0;

    /** Force of the damper, N: positive where it parts the cells. */
    double damping_force = 0;

    /** The penalty, Pa, and the energy of the overlap, J, in the last step:
     * zero without a force. */
    double penalty = 0, energy = 0;
  };

  /** Two cells that may overlap, and what they remember. */
  struct ContactPair
  {
    /** A and B. */
    CellPair cells;

    /** Set by the owner of the pair. */
    ContactConstants constants;

    /** Updated in each step. */
    ContactMemory memory;
  };

  static_assert(sizeof(ContactPair) == 13 * 8,
                "pairs are many: two indices, four constants, eight numbers");

  /** What a pair does in a step. */
  struct PairForces
  {
    /** Forces on the corners of both cells, N. */
    NodalVector on_a[4], on_b[4];

    /** Elastic energies of overlap and spring now, J. */
    double energy;

    /** Energies that friction and damping have used up since the step before,
     * J. */
    double friction_loss, damping_loss;

    /** Whether they have a volume in common; all else is zero if not, but for
     * losses. */
    bool overlaps;

    /** Whether the overlap or the spring has energy. */
    bool touches;

    /** Whether so deep that the cells behind will soon be reached: the mean of
     * least coordinates over the overlap is above `deep_mean_potential`. */
    bool is_deep;

    /** Whether so deep that the force of the pair no longer grows: that mean is
     * above `largest_mean_potential`, or more than `largest_volume_fraction` of
     * a cell is inside of the other. Not of pairs with an initial overlap. */
    bool is_too_deep;
  };

  /** Of faces that lie flat upon each other, the depth over the height. */
  constexpr double deep_mean_potential    = .05;
  constexpr double largest_mean_potential = .15;

  /** Of a cell so deep inside of a larger one that it may be pushed along where
   * the potential of that one is zero. */
  constexpr double largest_volume_fraction = .9;

  /** Stiffness of the spring of friction over that of the overlap (Xiang,
   * Latham & Farsi 2016). */
  constexpr double friction_stiffness_ratio = 2. / 7;

  /**
   * Contact of pairs of tetrahedra (doc/theory.md, section 8).
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
   * A pair with a force has the least of its penalties since it has one; what
   * falls with the penalty counts as damped (eq. 27c).
   *
   * Damping resists the approach of the two cells and their parting, at most
   * with what makes the overlap free of force: it never pulls.
   *
   * Eight pairs are computed at once. A pair has the same bits in any company.
   */
  class PairKernel
  {
  public:
    /** Largest number of pairs of a call. */
    static constexpr unsigned int chunk_size = OverlapBatch::chunk_size;

    /**
     * @param cells that the pairs are of.
     * @param[in,out] pairs of which the memories are updated.
     * @param n of pairs, at most `chunk_size`.
     * @param time_step since the memories were updated last, s; 0 at the start.
     * @param[out] forces of each pair.
     */
    void
    compute(const PackedMotion *cells,
            ContactPair        *pairs,
            unsigned int        n,
            double              time_step,
            PairForces         *forces);

  private:
    OverlapBatch overlaps;
  };
} // namespace rift

#endif
