#ifndef rift_cohesive_laws_mohr_coulomb_h
#define rift_cohesive_laws_mohr_coulomb_h

#include <rift/base/simd.h>
#include <rift/cohesive/laws/softening.h>

namespace rift
{
  /** Strength of an interior face. */
  struct FaceStrength
  {
    /** Tensile strength and cohesion, Pa. */
    double tensile_strength, cohesion;

    double tan_friction_angle;

    /** Fracture energies of modes I and II, J/m^2. */
    double fracture_energy_1, fracture_energy_2;
  };

  /**
   * What a Gauss point of a cohesive face remembers. Vectors are in the frame
   * of the face: normal, first and second tangent.
   */
  template <typename Number>
  struct CohesivePoint
  {
    /** Jump at which the elastic branch has no traction, m. */
    Vector3<Number> offset;

    /** Traction at the last update, Pa. */
    Vector3<Number> traction;

    /** Irreversible opening and slip over what separates the face fully. */
    Number opening, slip;

    /** f(D): the share of the strength that is left, 1 to 0. */
    Number softening;

    /** Peak of the envelope in shear without friction, Pa. */
    Number cohesion;

    /** Traction above the strength that is still held, Pa: normal, shear. */
    Number normal_excess, shear_excess;

    /** One over the opening and the slip of full separation, 1/m. */
    Number inverse_opening, inverse_slip;
  };

  /** What all Gauss points of a face have in common. */
  template <typename Number>
  struct CohesiveConstants
  {
    /** Slope of the elastic branch, Pa/m. */
    Number stiffness;

    Number tensile_strength, tan_friction_angle;
  };

  /** Energy per area that one update has used up, J/m^2. */
  template <typename Number>
  struct Dissipation
  {
    Number fracture, friction;
  };

  /**
   * Extrinsic cohesive law: Mohr-Coulomb with tension cut-off, softening in
   * modes I and II and mixed, Coulomb friction in compression that does not
   * fade with damage (doc/theory.md, section 4).
   *
   * The traction is elastic, t = k (jump - offset), inside of the envelope
   *   t_n <= f(D) T + e_n,   |t_s| <= f(D) C + e_s + tan(phi) <-t_n>,
   *   D = sqrt(opening^2 + slip^2),
   * and the part of the jump that would leave the envelope goes into the
   * offset, irreversibly: unloading and reloading follow the slope k, which is
   * also the penalty against overlap. The stiffness thus never changes where
   * the traction changes its sign, which is what injects energy in laws that
   * unload to the origin. Once D = 1 the face closes where it was cut.
   *
   * The excess e is what nodes transmitted above the strength when they were
   * parted (hold_traction()); it falls with the slope `excess_slope` times k.
   *
   * `Number` is double or Simd.
   */
  class MohrCoulomb
  {
  public:
    /**
     * Least separation over the jump at which the elastic branch peaks; any
     * shorter and the softening would snap back.
     */
    static constexpr double shortest_separation = 4.5;

    /** Decline of the excess with the irreversible jump, over k. */
    static constexpr double excess_slope = 1. / 3.;

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

  private:
    /** Irreversible opening and slip of one update, m. */
    template <typename Number>
    struct Flow
    {
      Number opening, slip;

      /** Their derivatives by -f(D), m. */
      Number opening_rate, slip_rate;
    };

    /**
     * Irreversible jumps that bring a trial traction back to the envelope at a
     * given softening.
     */
    template <typename Number>
    static Flow<Number>
    flow_at(const CohesivePoint<Number>     &point,
            const CohesiveConstants<Number> &constants,
            const Number                    &softening,
            const Number                    &normal,
            const Number                    &shear,
            const Number                    &friction);

    /**
     * Finds the softening at which the irreversible jumps that it implies
     * give the damage that implies it, by Newton's method; the root is unique
     * thanks to shortest_separation.
     */
    template <typename Number>
    Flow<Number>
    soften(CohesivePoint<Number>           &point,
           const CohesiveConstants<Number> &constants,
           const Number                    &normal,
           const Number                    &shear,
           const Number                    &friction) const;

    /** Takes back what has changed where the mask is not set. */
    template <typename Mask, typename Number>
    static void
    keep_unless(const Mask                  &mask,
                const CohesivePoint<Number> &old,
                CohesivePoint<Number>       &point);

    Softening softening;
  };

  /** What the points of a face have in common, for a slope in Pa/m. */
  CohesiveConstants<double>
  make_constants(const FaceStrength &strength, double stiffness);

  /**
   * Whether a face needs more than its fracture energy in one of the modes,
   * since a separation that spent just that would be shorter than
   * MohrCoulomb::shortest_separation: the mesh is too coarse for the material.
   */
  bool
  is_separation_too_short(const FaceStrength &strength, double stiffness);

  /** A point that has not opened. */
  CohesivePoint<double>
  make_cohesive_point(const FaceStrength &strength, double stiffness);

  /**
   * Gives a point more traction than it had at its last update: the force that
   * held two nodes together until now passes to the face, so that the start is
   * continuous in time (doc/theory.md, section 5). What is above the strength
   * becomes excess. Separations are adapted so that the energy drawn from the
   * body remains the fracture energy.
   *
   * @param jump now, m; the body may have moved since the last update.
   * @return energy per area in the elastic branch that comes with the
   *   traction, J/m^2.
   */
  double
  hold_traction(CohesivePoint<double> &point,
                const Vector3<double> &jump,
                const Vector3<double> &more,
                const FaceStrength    &strength,
                double                 stiffness);

  template <typename Number>
  Dissipation<Number>
  MohrCoulomb::update(CohesivePoint<Number>           &point,
                      const CohesiveConstants<Number> &constants,
                      const Vector3<Number>           &jump) const
  {
    const Number          zero{};
    const Vector3<Number> former = point.traction;
    Vector3<Number>      &t      = point.traction;
    t                            = constants.stiffness * (jump - point.offset);
    const Number normal          = t[0];
    const Number friction = constants.tan_friction_angle * max(-normal, zero);
    const Number shear    = sqrt(t[1] * t[1] + t[2] * t[2]);
    const Number former_cohesion =
      point.softening * point.cohesion + point.shear_excess;
    const auto yields = (normal > point.softening * constants.tensile_strength +
                                    point.normal_excess) |
                        (shear > former_cohesion + friction);
    if (!any(yields))
      return {zero, zero};

    const CohesivePoint<Number> elastic = point;
    const auto flow = soften(point, constants, normal, shear, friction);

    const Number    slip_share = flow.slip / max(shear, zero + 1e-300);
    Vector3<Number> flow_jump  = {{flow.opening, zero, zero}};
    for (unsigned int d = 1; d < 3; ++d)
      flow_jump[d] = slip_share * t[d];
    for (unsigned int d = 0; d < 3; ++d)
      {
        point.offset[d] = point.offset[d] + flow_jump[d];
        t[d]            = t[d] - constants.stiffness * flow_jump[d];
      }

    // A failed point that is open will close where it was cut.
    const auto open = (point.softening <= zero) &
                      (point.normal_excess <= zero) & (flow.opening > zero) &
                      (jump[0] > zero);
    point.offset[0] = select(open, zero, point.offset[0]);
    t[0]            = select(open, zero, t[0]);

    // By the trapezoidal rule, as the central differences do their work: what
    // is left of that work is exactly the change of the elastic energy. Of what
    // sliding takes, the cohesion has its own and friction the rest. That a
    // failed point leaves contact in the midst of a step is an error of the
    // time integration, not fracture: it belongs to the residual.
    const Number opening = select(open & (former[0] < zero),
                                  zero,
                                  .5 * (t[0] + former[0]) * flow.opening);
    const Number sliding = .5 * ((t[1] + former[1]) * flow_jump[1] +
                                 (t[2] + former[2]) * flow_jump[2]);
    const Number cohesion =
      former_cohesion + point.softening * point.cohesion + point.shear_excess;
    const Number of_cohesion =
      min(.5 * cohesion * flow.slip, max(sliding, zero));
    Dissipation<Number> dissipation;
    dissipation.friction =
      select((normal < zero) | (former[0] < zero), sliding - of_cohesion, zero);
    dissipation.fracture = opening + sliding - dissipation.friction;

    // To the last bit, a point must not feel that a neighbour in its batch
    // yields: on another number of ranks it has other neighbours.
    keep_unless(yields, elastic, point);
    dissipation.fracture = select(yields, dissipation.fracture, zero);
    dissipation.friction = select(yields, dissipation.friction, zero);
    return dissipation;
  }

  template <typename Mask, typename Number>
  void
  MohrCoulomb::keep_unless(const Mask                  &mask,
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

  template <typename Number>
  MohrCoulomb::Flow<Number>
  MohrCoulomb::flow_at(const CohesivePoint<Number>     &point,
                       const CohesiveConstants<Number> &constants,
                       const Number                    &softening,
                       const Number                    &normal,
                       const Number                    &shear,
                       const Number                    &friction)
  {
    const Number     zero{};
    const Number     compliance = 1. / constants.stiffness;
    constexpr double steepening = 1 / (1 - excess_slope);

    // While some excess is left it falls with the flow; the smaller flow is
    // that of the two cases that holds.
    const auto flow = [&](const Number &over, const Number &excess) {
      const Number with_excess = steepening * compliance * (over - excess);
      const Number without     = compliance * over;
      return min(with_excess, without);
    };
    const Number over_normal = normal - softening * constants.tensile_strength;
    const Number over_shear  = shear - softening * point.cohesion - friction;
    Flow<Number> result;
    result.opening  = max(flow(over_normal, point.normal_excess), zero);
    result.slip     = max(flow(over_shear, point.shear_excess), zero);
    const auto rate = [&](const Number &jump, const Number &over) {
      return select(
               jump > zero,
               select(jump < compliance * over, zero + steepening, zero + 1.),
               zero) *
             compliance;
    };
    result.opening_rate =
      rate(result.opening, over_normal) * constants.tensile_strength;
    result.slip_rate = rate(result.slip, over_shear) * point.cohesion;
    return result;
  }

  template <typename Number>
  MohrCoulomb::Flow<Number>
  MohrCoulomb::soften(CohesivePoint<Number>           &point,
                      const CohesiveConstants<Number> &constants,
                      const Number                    &normal,
                      const Number                    &shear,
                      const Number                    &friction) const
  {
    const Number zero{}, one = zero + 1.;

    Number share = point.softening;
    for (unsigned int iteration = 0; iteration < 3; ++iteration)
      {
        const auto flow =
          flow_at(point, constants, share, normal, shear, friction);
        const Number opening =
          point.opening + flow.opening * point.inverse_opening;
        const Number slip   = point.slip + flow.slip * point.inverse_slip;
        const Number damage = sqrt(opening * opening + slip * slip);
        const Number inside = min(damage, one);
        const Number damage_rate =
          (opening * flow.opening_rate * point.inverse_opening +
           slip * flow.slip_rate * point.inverse_slip) /
          max(damage, zero + 1e-300);
        const auto   f        = softening(inside);
        const Number residual = share - f.value;
        const Number gain = select(damage < one, -f.slope * damage_rate, zero);
        share             = share - residual / (1. - gain);
        share             = max(min(share, point.softening), zero);
      }

    const auto flow = flow_at(point, constants, share, normal, shear, friction);
    const auto alive = point.softening > zero;
    point.opening    = select(alive,
                           point.opening + flow.opening * point.inverse_opening,
                           point.opening);
    point.slip =
      select(alive, point.slip + flow.slip * point.inverse_slip, point.slip);
    const Number damage_squared =
      point.opening * point.opening + point.slip * point.slip;
    point.softening     = select(damage_squared >= one, zero, share);
    const Number fall   = excess_slope * constants.stiffness;
    point.normal_excess = max(point.normal_excess - fall * flow.opening, zero);
    point.shear_excess  = max(point.shear_excess - fall * flow.slip, zero);
    return flow;
  }
} // namespace rift

#endif
