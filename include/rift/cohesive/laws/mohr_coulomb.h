#ifndef rift_cohesive_laws_mohr_coulomb_h
#define rift_cohesive_laws_mohr_coulomb_h

#include <rift/base/simd.h>
#include <rift/cohesive/laws/elastic_branch.h>
#include <rift/cohesive/laws/softening.h>

#include <algorithm>

namespace rift
{
  /** Strength of an interior face. */
  struct FaceStrength
  {
    /** Tensile strength and cohesion, Pa. */
    double tensile_strength, cohesion;

    /** Coefficients of internal friction, while the face is intact and once it
     * has failed. */
    double tan_friction_angle, residual_friction;

    /** Fracture energies of modes I and II, J/m^2. */
    double fracture_energy_1, fracture_energy_2;

    /** With a share of the strength and of all friction, but the whole fracture
     * energies. */
    FaceStrength
    times(const double share) const
    {
      return {share * tensile_strength,
              share * cohesion,
              share * tan_friction_angle,
              share * residual_friction,
              fracture_energy_1,
              fracture_energy_2};
    }

    /** Part of the strength of eq. (11) that a plane bears, for its normal
     * stress (tension positive) and its shear stress, Pa. */
    double
    share_of(const double normal, const double shear) const
    {
      return std::max(normal / tensile_strength,
                      shear /
                        (cohesion - std::min(normal, 0.) * tan_friction_angle));
    }
  };

  /**
   * What a Gauss point of a cohesive face remembers. Vectors are in the frame
   * of the face: normal, first and second tangent.
   */
  template <typename Number>
  struct CohesivePoint
  {
    /** Irreversible jump: at which the elastic branch has no traction, m. */
    Vector3<Number> offset;

    /** Traction at the last update, Pa. */
    Vector3<Number> traction;

    /** Opening and slip beyond the envelope, over what separates the face
     * fully. */
    Number opening, slip;

    /** f(D): the share of the strength that is left, 1 to 0. */
    Number softening;

    /** Peak of the envelope in shear without friction, Pa. */
    Number cohesion;

    /** Traction above the strength that is still held, Pa: normal, shear. */
    Number normal_excess, shear_excess;

    /** One over the opening and the slip of full separation, 1/m. */
    Number inverse_opening, inverse_slip;

    /** What of the elastic energy per area a point under pressure had from the
     * start and has not drawn from the body yet, J/m^2; see repay(). */
    Number debt;

    /** Elastic energies per area that a point had from the start and that are
     * no debt, of opening and of sliding, J/m^2. Fracture uses them up. */
    Number given_opening, given_sliding;
  };

  /** What all Gauss points of a face have in common. */
  template <typename Number>
  struct CohesiveConstants
  {
    /** Slope k of the elastic branch at its start, Pa/m. */
    Number stiffness;

    Number tensile_strength, tan_friction_angle, residual_friction;

    /** Coefficient of friction of a point with this share f(D) of its strength
     * (doc/theory.md, eq. 14a). */
    Number
    friction_at(const Number &softening) const
    {
      return residual_friction +
             softening * (tan_friction_angle - residual_friction);
    }
  };

  /** Energy per area that one update has used up, J/m^2. */
  template <typename Number>
  struct Dissipation
  {
    Number fracture, friction;
  };

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
    static constexpr double part_of_fracture = Branch::part_of_fracture;

    /**
     * Traction of a point that has never left the envelope: to the last bit
     * that which update() gives it.
     *
     * @param[out] yields where the jump is beyond the envelope; the traction is
     *   then about that of the envelope.
     */
    template <typename Number, typename Mask>
    static Vector3<Number>
    intact_traction(const CohesiveConstants<Number> &constants,
                    const Number                    &cohesion,
                    const Vector3<Number>           &jump,
                    Mask                            &yields);

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
    update(CohesivePoint<Number>           &point,
           const CohesiveConstants<Number> &constants,
           const Vector3<Number>           &jump) const;

    /** Elastic energy per area at the last update, J/m^2. */
    template <typename Number>
    static Number
    elastic_energy(const CohesivePoint<Number>     &point,
                   const CohesiveConstants<Number> &constants);

  private:
    /** What an elastic jump would carry on a straight and endless branch,
     * Pa. */
    template <typename Number>
    struct Trial
    {
      Trial(const CohesiveConstants<Number> &constants,
            const Vector3<Number>           &elastic_jump)
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
    peaks_of(const CohesivePoint<Number>     &point,
             const CohesiveConstants<Number> &constants);

    /** By how much a trial is beyond the reach of the branch, Pa. */
    template <typename Number>
    struct Beyond
    {
      Number normal, shear;
    };

    template <typename Number>
    static Beyond<Number>
    beyond(const Trial<Number> &trial, const Peaks<Number> &peaks);

    /** Traction of a trial within the reach of the branch. */
    template <typename Number>
    static Vector3<Number>
    elastic_traction(const Trial<Number> &trial, const Peaks<Number> &peaks);

    /** Elastic energy per area of a trial times k, Pa^2. */
    template <typename Number>
    static Number
    trial_energy(const Number &trial, const Number &peak);

    /** The trial of a traction, not below zero. */
    template <typename Number>
    static Number
    trial_of(const Number &traction, const Number &peak);

    /**
     * Straight branches: draws a part of the debt from the body. The pressure
     * of a compressed point falls by as much elastic energy, at the same jump,
     * and the body closes the face a little more (doc/theory.md, eq. 19a).
     */
    template <typename Number>
    static void
    repay(CohesivePoint<Number>           &point,
          const CohesiveConstants<Number> &constants,
          const Vector3<Number>           &jump);

    /** Has damage and excess follow jumps beyond the envelope, m. */
    template <typename Number>
    void
    soften(CohesivePoint<Number>           &point,
           const CohesiveConstants<Number> &constants,
           const Number                    &opening,
           const Number                    &slip) const;

    /** Takes back what has changed where the mask is not set. */
    template <typename Mask, typename Number>
    static void
    keep_unless(const Mask                  &mask,
                const CohesivePoint<Number> &old,
                CohesivePoint<Number>       &point);

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

  /** Part of the debt of a compressed point that is repaid in a step, and the
   * largest part by which its pressure changes for that. */
  constexpr double repayment = .1;

  /**
   * Least separation over the jump strength / k. Any shorter, and a face would
   * separate within a few steps.
   */
  constexpr double shortest_separation = 1;

  /** What the points of a face have in common, for a slope in Pa/m. */
  CohesiveConstants<double>
  make_constants(const FaceStrength &strength, double stiffness);

  // Below, `part_of_fracture` is that of the branch.

  /**
   * Whether a face needs more than its fracture energy in one of the modes,
   * since a separation that spent just that would be shorter than
   * shortest_separation: the mesh is too coarse for the material.
   */
  bool
  is_separation_too_short(const FaceStrength &strength,
                          double              stiffness,
                          double              part_of_fracture);

  /** A point that has not opened. */
  CohesivePoint<double>
  make_cohesive_point(const FaceStrength &strength,
                      double              stiffness,
                      double              part_of_fracture);

  /**
   * For straight branches: gives a point more traction than it had at its last
   * update. The force that held two nodes together until now passes to the
   * face, so that the start is continuous in time (doc/theory.md, section 5).
   * What is above the strength becomes excess. Of the elastic energy, what the
   * pressure lets the body repay becomes debt. Separations are adapted so that
   * the energy drawn from the body remains the fracture energy.
   *
   * @param jump now, m; the body may have moved since the last update.
   * @return the elastic energy per area that comes with the traction besides
   *   the debt, J/m^2: that of tension, and under little pressure that of the
   *   shear which the cohesion carries. Fracture will use it up.
   */
  double
  hold_traction(CohesivePoint<double> &point,
                const Vector3<double> &jump,
                const Vector3<double> &more,
                const FaceStrength    &strength,
                double                 stiffness);

  template <typename Branch>
  template <typename Number>
  typename MohrCoulomb<Branch>::template Peaks<Number>
  MohrCoulomb<Branch>::peaks_of(const CohesivePoint<Number>     &point,
                                const CohesiveConstants<Number> &constants)
  {
    return {point.softening * constants.tensile_strength + point.normal_excess,
            point.softening * point.cohesion + point.shear_excess,
            constants.friction_at(point.softening)};
  }

  template <typename Branch>
  template <typename Number>
  typename MohrCoulomb<Branch>::template Beyond<Number>
  MohrCoulomb<Branch>::beyond(const Trial<Number> &trial,
                              const Peaks<Number> &peaks)
  {
    const Number zero{};
    return {max(trial.normal - Branch::reach * peaks.normal, zero),
            max(trial.shear - (Branch::reach * peaks.shear +
                               peaks.friction * trial.pressure),
                zero)};
  }

  template <typename Branch>
  template <typename Number>
  Vector3<Number>
  MohrCoulomb<Branch>::elastic_traction(const Trial<Number> &trial,
                                        const Peaks<Number> &peaks)
  {
    Vector3<Number> t = trial.vector;
    if constexpr (!Branch::is_straight)
      {
        const Number opening =
          max(trial.normal, Number{}) / nonzero(peaks.normal);
        const Number share = Branch::secant(trial.shear / nonzero(peaks.shear));
        t[0]               = t[0] * Branch::secant(opening);
        t[1]               = t[1] * share;
        t[2]               = t[2] * share;
      }
    return t;
  }

  template <typename Branch>
  template <typename Number>
  Number
  MohrCoulomb<Branch>::trial_energy(const Number &trial, const Number &peak)
  {
    Number factor = Number{} + .5;
    if constexpr (!Branch::is_straight)
      factor = Branch::energy(max(trial, Number{}) / nonzero(peak));
    return trial * trial * factor;
  }

  template <typename Branch>
  template <typename Number>
  Number
  MohrCoulomb<Branch>::trial_of(const Number &traction, const Number &peak)
  {
    if constexpr (Branch::is_straight)
      return traction;
    else
      {
        const Number share = min(traction / nonzero(peak), Number{} + 1.);
        return select(traction > peak,
                      traction + peak,
                      peak * Branch::ratio_of(share));
      }
  }

  template <typename Branch>
  template <typename Number, typename Mask>
  Vector3<Number>
  MohrCoulomb<Branch>::intact_traction(
    const CohesiveConstants<Number> &constants,
    const Number                    &cohesion,
    const Vector3<Number>           &jump,
    Mask                            &yields)
  {
    const Trial<Number>  trial(constants, jump);
    const Peaks<Number>  peaks = {constants.tensile_strength,
                                  cohesion,
                                  constants.friction_at(Number{} + 1.)};
    const Beyond<Number> over  = beyond(trial, peaks);
    yields = (over.normal > Number{}) | (over.shear > Number{});
    return elastic_traction(trial, peaks);
  }

  template <typename Branch>
  template <typename Number>
  Number
  MohrCoulomb<Branch>::elastic_energy(
    const CohesivePoint<Number>     &point,
    const CohesiveConstants<Number> &constants)
  {
    const Number           zero{};
    const Vector3<Number> &t     = point.traction;
    const Peaks<Number>    peaks = peaks_of(point, constants);
    const Number           shear = sqrt(t[1] * t[1] + t[2] * t[2]);
    const Number           normal =
      select(t[0] > zero, trial_of(max(t[0], zero), peaks.normal), t[0]);
    return (trial_energy(normal, peaks.normal) +
            trial_energy(trial_of(shear, peaks.shear), peaks.shear)) /
           constants.stiffness;
  }

  template <typename Branch>
  template <typename Number>
  Dissipation<Number>
  MohrCoulomb<Branch>::update(CohesivePoint<Number>           &point,
                              const CohesiveConstants<Number> &constants,
                              const Vector3<Number>           &jump) const
  {
    const Number    zero{};
    Vector3<Number> former = point.traction;
    if constexpr (Branch::is_straight)
      repay(point, constants, jump);
    const Trial<Number>  trial(constants, jump - point.offset);
    const Peaks<Number>  before = peaks_of(point, constants);
    const Beyond<Number> over   = beyond(trial, before);
    const auto           yields = (over.normal > zero) | (over.shear > zero);
    point.traction              = elastic_traction(trial, before);
    if (!any(yields))
      return {zero, zero};
    // Intact points have not been followed: they come from the peak.
    if constexpr (!Branch::is_straight)
      {
        const Number shear = sqrt(point.traction[1] * point.traction[1] +
                                  point.traction[2] * point.traction[2]);
        const Number share = min(
          (before.shear + before.friction * trial.pressure) / nonzero(shear),
          zero + 1.);
        const Vector3<Number> peak = {{min(point.traction[0], before.normal),
                                       share * point.traction[1],
                                       share * point.traction[2]}};
        for (unsigned int d = 0; d < dim; ++d)
          former[d] =
            select(point.opening + point.slip > zero, former[d], peak[d]);
      }

    const CohesivePoint<Number> elastic    = point;
    const Number                compliance = 1. / constants.stiffness;
    soften(point, constants, compliance * over.normal, compliance * over.shear);

    // The branch ends at the peaks that are left; the rest is irreversible.
    const Peaks<Number>  after      = peaks_of(point, constants);
    const Beyond<Number> over_after = beyond(trial, after);
    const Number         opening    = compliance * over_after.normal;
    const Number         slip       = compliance * over_after.shear;
    const Number         slip_share = slip / nonzero(trial.shear);
    Vector3<Number>      flow       = {{opening, zero, zero}};
    for (unsigned int d = 1; d < dim; ++d)
      flow[d] = slip_share * trial.vector[d];
    point.offset += flow;
    const Trial<Number> rest(constants, jump - point.offset);
    Vector3<Number>    &t = point.traction;
    t                     = elastic_traction(rest, after);

    // A failed point that is open will close where it was cut.
    const auto open = (point.softening <= zero) &
                      (point.normal_excess <= zero) & (opening > zero) &
                      (jump[0] > zero);
    point.offset[0] = select(open, zero, point.offset[0]);
    t[0]            = select(open, zero, t[0]);

    // By the trapezoidal rule, as the central differences do their work, and
    // what a branch releases as its peak falls: what is left of that work is
    // the change of the elastic energy (on a straight branch exactly). Of what
    // sliding takes, the cohesion has its own and friction the rest. That a
    // failed point leaves contact in the midst of a step is an error of the
    // time integration, not fracture: it belongs to the residual.
    const Number of_opening = select(open & (former[0] < zero),
                                     zero,
                                     .5 * (t[0] + former[0]) * opening);
    const Number sliding =
      .5 * ((t[1] + former[1]) * flow[1] + (t[2] + former[2]) * flow[2]);
    const Number of_cohesion =
      min(.5 * (before.shear + after.shear) * slip, max(sliding, zero));
    Dissipation<Number> dissipation;
    dissipation.friction = select((trial.normal < zero) | (former[0] < zero),
                                  sliding - of_cohesion,
                                  zero);
    dissipation.fracture = of_opening + sliding - dissipation.friction;
    if constexpr (!Branch::is_straight)
      {
        const auto released = [&](const Number &shear) {
          return compliance * (trial_energy(shear, before.shear) -
                               trial_energy(shear, after.shear));
        };
        const Number of_cohesion =
          released(min(rest.shear, Branch::reach * after.shear));
        dissipation.fracture +=
          compliance * (trial_energy(rest.normal, before.normal) -
                        trial_energy(rest.normal, after.normal)) +
          of_cohesion;
        dissipation.friction += released(rest.shear) - of_cohesion;
      }

    // To the last bit, a point must not feel that a neighbour in its batch
    // yields: on another number of ranks it has other neighbours.
    keep_unless(yields, elastic, point);
    dissipation.fracture = select(yields, dissipation.fracture, zero);
    dissipation.friction = select(yields, dissipation.friction, zero);
    return dissipation;
  }

  template <typename Branch>
  template <typename Number>
  void
  MohrCoulomb<Branch>::repay(CohesivePoint<Number>           &point,
                             const CohesiveConstants<Number> &constants,
                             const Vector3<Number>           &jump)
  {
    const Number zero{};
    const Number pressure =
      max(constants.stiffness * (point.offset[0] - jump[0]), zero);
    // What has been paid too much comes back.
    const auto pays = (point.debt * point.debt > zero) & (pressure > zero);
    if (!any(pays))
      return;
    const Number repaid = sqrt(max(
      pressure * pressure - (2 * repayment) * constants.stiffness * point.debt,
      zero));
    const Number rest =
      min(max(repaid, (1 - repayment) * pressure), (1 + repayment) * pressure);
    // By the trapezoidal rule, as the central differences do their work.
    const Number closing = (pressure - rest) / constants.stiffness;
    const Number paid    = .5 * (rest - point.traction[0]) * closing;
    point.offset[0] = select(pays, point.offset[0] - closing, point.offset[0]);
    point.debt      = select(pays, point.debt - paid, point.debt);
  }

  template <typename Branch>
  template <typename Mask, typename Number>
  void
  MohrCoulomb<Branch>::keep_unless(const Mask                  &mask,
                                   const CohesivePoint<Number> &old,
                                   CohesivePoint<Number>       &point)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        point.offset[d]   = select(mask, point.offset[d], old.offset[d]);
        point.traction[d] = select(mask, point.traction[d], old.traction[d]);
      }
    point.opening       = select(mask, point.opening, old.opening);
    point.slip          = select(mask, point.slip, old.slip);
    point.softening     = select(mask, point.softening, old.softening);
    point.normal_excess = select(mask, point.normal_excess, old.normal_excess);
    point.shear_excess  = select(mask, point.shear_excess, old.shear_excess);
  }

  template <typename Branch>
  template <typename Number>
  void
  MohrCoulomb<Branch>::soften(CohesivePoint<Number>           &point,
                              const CohesiveConstants<Number> &constants,
                              const Number                    &opening,
                              const Number                    &slip) const
  {
    const Number zero{}, one = zero + 1.;
    const auto   alive = point.softening > zero;
    point.opening += select(alive, opening * point.inverse_opening, zero);
    point.slip += select(alive, slip * point.inverse_slip, zero);
    const Number damage_squared =
      point.opening * point.opening + point.slip * point.slip;
    const Number share =
      min(softening(sqrt(min(damage_squared, one))), point.softening);
    point.softening     = select(damage_squared >= one, zero, share);
    const Number fall   = excess_slope * constants.stiffness;
    point.normal_excess = max(point.normal_excess - fall * opening, zero);
    point.shear_excess  = max(point.shear_excess - fall * slip, zero);
  }
} // namespace rift

#endif
