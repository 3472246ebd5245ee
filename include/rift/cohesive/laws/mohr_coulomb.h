#ifndef rift_cohesive_laws_mohr_coulomb_h
#define rift_cohesive_laws_mohr_coulomb_h

#include <rift/cohesive/laws/elastic_branch.h>
#include <rift/cohesive/laws/law_values.h>
#include <rift/cohesive/laws/mohr_coulomb_point.h>
#include <rift/cohesive/laws/softening.h>
#include <rift/material/face_strength.h>

namespace rift
{
  /**
   * Cohesive law: Mohr-Coulomb with tension cut-off, softening in modes I and
   * II and mixed, Coulomb friction in compression that fades to a residual one
   * (doc/theory.md, section 4).
   *
   * The elastic part of the jump, jump - offset, makes the traction along the
   * `Branch`, up to the envelope
   *   t_n <= f(D) T + e_n,   |t_s| <= f(D) C + e_s + mu(D) <-t_n>;
   * what would leave the envelope goes into the offset, irreversibly.
   * Unloading and reloading follow the branch, whose slope at the start is also
   * the penalty against overlap. The stiffness thus never changes where the
   * traction changes its sign, which is what injects energy in laws that unload
   * to the origin. Once D = 1 and the face is open, it closes where it was cut.
   *
   * The damage D = sqrt(opening^2 + slip^2) grows by the jump beyond the one at
   * which the envelope was reached, over that which separates the face fully.
   *
   * The excess e is what nodes transmitted above the strength when they were
   * parted (hold_traction()); it falls with the slope `excess_slope` times k.
   *
   * @tparam Branch StraightBranch in the extrinsic model, ParabolicBranch in
   *   the intrinsic one. `Number` is double or Simd.
   */
  template <typename Branch>
  class MohrCoulomb
  {
  public:
    /** What a Gauss point remembers. */
    template <typename Number>
    using Point = MohrCoulombPoint<Number>;

    /** What the points of a face have in common. */
    template <typename Number>
    using Constants = MohrCoulombConstants<Number>;

    /** The value of the entry Cohesive law, and what it does. */
    static constexpr const char *name = "faces";
    static constexpr const char *summary =
      "cracks follow the faces of cells, and the opening and sliding of a face "
      "have a Mohr-Coulomb envelope each, which softens with a common damage "
      "along the curve of Munjiza (eq. 14 of doc/theory.md)";

    /** The cohesive model that it serves. */
    static constexpr CohesiveModel model = Branch::model;

    /** @param stiffness slope of the elastic branch at its start, Pa/m. */
    static Constants<double>
    make_constants(const FaceStrength &strength, double stiffness);

    /** A point that has not opened. */
    static Point<double>
    make_point(const FaceStrength      &strength,
               const Constants<double> &constants);

    /**
     * Whether a face needs no more than its fracture energy. It does need more
     * where the separation that spends just that would be shorter than
     * shortest_separation in one of the modes: the mesh is too coarse for the
     * material.
     */
    static bool
    is_resolved(const FaceStrength      &strength,
                const Constants<double> &constants);

    /**
     * For straight branches: gives a point more traction than it had at its
     * last update. The force that held two nodes together until now passes to
     * the face, so that the start is continuous in time (doc/theory.md, section
     * 5). What is above the strength becomes excess.
     *
     * @param jump now, m; the body may have moved since the last update.
     */
    static InitialEnergy
    hold_traction(Point<double>           &point,
                  const FaceStrength      &strength,
                  const Constants<double> &constants,
                  const Vector3<double>   &jump,
                  const Vector3<double>   &more);

    /**
     * Traction of a point that has never left the envelope: to the last bit
     * that which update() gives it.
     *
     * @param[out] yields where the jump is beyond the envelope; the traction is
     *   then about that of the envelope.
     */
    template <typename Number, typename Mask>
    static Vector3<Number>
    intact_traction(const Constants<Number> &constants,
                    const Vector3<Number>   &jump,
                    Mask                    &yields);

    /** Elastic energy per area of a point that has never left the envelope,
     * J/m^2. */
    template <typename Number>
    static Number
    intact_energy(const Constants<Number> &constants,
                  const Vector3<Number>   &jump);

    /**
     * Moves a point to a new jump.
     *
     * `point.traction` then acts on the minus side: positive opening is pulled
     * back.
     *
     * @param jump opening and slips, m.
     */
    template <typename Number>
    Dissipation<Number>
    update(Point<Number>           &point,
           const Constants<Number> &constants,
           const Vector3<Number>   &jump) const;

    /** Elastic energy per area at the last update, J/m^2. */
    template <typename Number>
    static Number
    elastic_energy(const Point<Number>     &point,
                   const Constants<Number> &constants);

    /** The damage by opening and by sliding. */
    template <typename Number>
    static Damage<Number>
    damage(const Point<Number> &point)
    {
      return {point.opening, point.slip};
    }

    /** Where no strength is left but friction. */
    template <typename Number>
    static auto
    has_failed(const Point<Number> &point)
    {
      return point.softening <= Number{};
    }

  private:
    /** What an elastic jump would carry on a straight and endless branch,
     * Pa. */
    template <typename Number>
    struct TrialTraction
    {
      TrialTraction(const Constants<Number> &constants,
                    const Vector3<Number>   &elastic_jump)
        : vector(constants.stiffness * elastic_jump)
        , normal(vector[0])
        , shear(sqrt(vector[1] * vector[1] + vector[2] * vector[2]))
        , pressure(max(-normal, Number{}))
      {
      }

      Vector3<Number> vector;
      Number          normal, shear, pressure;
    };

    /** The strength that is left, Pa, in shear without friction: the peaks of
     * the branch. And the coefficient of friction. */
    template <typename Number>
    struct Peaks
    {
      Number normal, shear, friction;
    };

    template <typename Number>
    static Peaks<Number>
    peaks_of(const Point<Number> &point, const Constants<Number> &constants);

    /** By how much a trial is beyond the peak of the branch, Pa. */
    template <typename Number>
    struct Overstress
    {
      Number normal, shear;
    };

    template <typename Number>
    static Overstress<Number>
    overstress(const TrialTraction<Number> &trial, const Peaks<Number> &peaks);

    /** Traction of a trial within the peak of the branch. */
    template <typename Number>
    static Vector3<Number>
    elastic_traction(const TrialTraction<Number> &trial,
                     const Peaks<Number>         &peaks);

    /** Elastic energy per area of a trial times k, Pa^2. */
    template <typename Number>
    static Number
    trial_energy(const Number &trial, const Number &peak);

    /** The trial of a traction, not below zero. */
    template <typename Number>
    static Number
    trial_of(const Number &traction, const Number &peak);

    /** Has damage and excess follow jumps beyond the envelope, m. */
    template <typename Number>
    void
    soften(Point<Number>           &point,
           const Constants<Number> &constants,
           const Number            &opening,
           const Number            &slip) const;

    /**
     * The traction before an update, Pa, as its work is counted: points on a
     * rising branch that had not left the envelope have not been followed and
     * come from its peak.
     */
    template <typename Number>
    static Vector3<Number>
    former_traction(const Point<Number>   &point,
                    const Vector3<Number> &former,
                    const Peaks<Number>   &peaks,
                    const Number          &pressure);

    /** What a step beyond the envelope has come to. */
    template <typename Number>
    struct Flow
    {
      /** The irreversible jump and its sizes, m. */
      Vector3<Number> jump;
      Number          opening, slip;

      /** The peaks that are left and the trial that is. */
      Peaks<Number>         peaks;
      TrialTraction<Number> rest;

      /** Whether a failed point has opened and will close where it was cut. */
      MaskOf<Number> has_parted;
    };

    /** Moves a point whose damage is known to the envelope that is left. */
    template <typename Number>
    static Flow<Number>
    flow_to_envelope(Point<Number>               &point,
                     const Constants<Number>     &constants,
                     const TrialTraction<Number> &trial,
                     const Vector3<Number>       &jump);

    /**
     * By the trapezoidal rule, as the central differences do their work, and
     * what a branch releases as its peak falls: what is left of that work is
     * the change of the elastic energy (on a straight branch exactly).
     *
     * @param former traction, Pa; now it is that of the point.
     * @param before peaks, Pa.
     */
    template <typename Number>
    static Dissipation<Number>
    dissipation_of(const Flow<Number>          &flow,
                   const Point<Number>         &point,
                   const Vector3<Number>       &former,
                   const Peaks<Number>         &before,
                   const TrialTraction<Number> &trial,
                   const Constants<Number>     &constants);

    /** A divisor that is not zero. */
    template <typename Number>
    static Number
    nonzero(const Number &a)
    {
      return max(a, Number{} + 1e-300);
    }

    Softening softening;
  };

  /** Decline of the excess with the jump, over the slope of the branch. */
  constexpr double excess_slope = .5;

  /**
   * Least separation over the jump strength / k. Any shorter, and a face would
   * separate within a few steps.
   */
  constexpr double shortest_separation = 1;
} // namespace rift

#include <rift/cohesive/laws/mohr_coulomb.templates.h>

#endif
