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

    /** Irreversible opening and slip over what separates the face fully. */
    Number opening, slip;

    /** f(D): the share of the strength that is left, 1 to 0. */
    Number softening;

    /** Peak of the envelope in tension and in shear without friction, Pa. */
    Number tensile_strength, cohesion;

    /** One over the opening and the slip of full separation, 1/m. */
    Number inverse_opening, inverse_slip;
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
   *   t_n <= f(D) T,   |t_s| <= f(D) C + tan(phi) <-t_n>,
   *   D = sqrt(opening^2 + slip^2),
   * and the part of the jump that would leave the envelope goes into the
   * offset, irreversibly: unloading and reloading follow the slope k, which is
   * also the penalty against overlap. The stiffness thus never changes where
   * the traction changes its sign, which is what injects energy in laws that
   * unload to the origin. Once D = 1 the face closes where it was cut.
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
    static constexpr double shortest_separation = 3;

    /**
     * Moves a point to a new jump.
     *
     * @param jump opening and slips, m.
     * @param stiffness k, Pa/m.
     * @param[out] traction on the minus side, Pa; positive opening is pulled
     *   back.
     */
    template <typename Number>
    Dissipation<Number>
    update(CohesivePoint<Number> &point,
           const Vector3<Number> &jump,
           const Number          &stiffness,
           const Number          &tan_friction,
           Vector3<Number>       &traction) const;

  private:
    /** Irreversible opening and slip of one update, m. */
    template <typename Number>
    struct Flow
    {
      Number opening, slip;
    };

    /**
     * Finds the softening at which the irreversible jumps that it implies
     * give the damage that implies it, by Newton's method; the root is unique
     * thanks to shortest_separation.
     */
    template <typename Number>
    Flow<Number>
    soften(CohesivePoint<Number> &point,
           const Number          &normal,
           const Number          &shear,
           const Number          &friction,
           const Number          &stiffness) const;

    Softening softening;
  };

  /** A point that has not opened, with an elastic branch of slope `stiffness`,
   * Pa/m. */
  CohesivePoint<double>
  make_cohesive_point(const FaceStrength &strength, double stiffness);

  /** Traction of a point at the jump to which it was last updated, Pa. */
  template <typename Number>
  inline Vector3<Number>
  traction_at(const CohesivePoint<Number> &point,
              const Vector3<Number>       &jump,
              const Number                &stiffness)
  {
    Vector3<Number> t = stiffness * (jump - point.offset);
    t[0]              = min(t[0], point.softening * point.tensile_strength);
    return t;
  }

  /**
   * Gives a point, at the jump to which it was last updated, more traction:
   * the force that held two nodes together until now passes to the face, so
   * that the start is continuous in time (doc/theory.md, section 5). Strengths
   * are raised where the traction is above them, and separations adapted so
   * that the energy drawn from the body remains the fracture energy.
   *
   * A point with less than a tenth of its strength left is not raised: there
   * the traction is cut at the envelope.
   *
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
  MohrCoulomb::update(CohesivePoint<Number> &point,
                      const Vector3<Number> &jump,
                      const Number          &stiffness,
                      const Number          &tan_friction,
                      Vector3<Number>       &traction) const
  {
    const Number zero{};
    traction              = stiffness * (jump - point.offset);
    const Number normal   = traction[0];
    const Number friction = tan_friction * max(-normal, zero);
    const Number shear =
      sqrt(traction[1] * traction[1] + traction[2] * traction[2]);
    const Number old_softening = point.softening;
    if (!any((normal > old_softening * point.tensile_strength) |
             (shear > old_softening * point.cohesion + friction)))
      return {zero, zero};

    const auto flow = soften(point, normal, shear, friction, stiffness);

    // Mean of the envelope before and after: the work of the trapezoidal rule
    // that the central differences do.
    const Number        mean = .5 * (old_softening + point.softening);
    Dissipation<Number> dissipation;
    dissipation.fracture = mean * (point.tensile_strength * flow.opening +
                                   point.cohesion * flow.slip);
    dissipation.friction = friction * flow.slip;

    const Number slip_share = flow.slip / max(shear, zero + 1e-300);
    point.offset[0]         = point.offset[0] + flow.opening;
    for (unsigned int d = 1; d < 3; ++d)
      {
        point.offset[d] = point.offset[d] + slip_share * traction[d];
        traction[d]     = traction[d] - stiffness * slip_share * traction[d];
      }
    traction[0] = normal - stiffness * flow.opening;

    // A failed point that is open will close where it was cut.
    const auto open =
      (point.softening <= zero) & (flow.opening > zero) & (jump[0] > zero);
    point.offset[0] = select(open, zero, point.offset[0]);
    traction[0]     = select(open, zero, traction[0]);
    return dissipation;
  }

  template <typename Number>
  MohrCoulomb::Flow<Number>
  MohrCoulomb::soften(CohesivePoint<Number> &point,
                      const Number          &normal,
                      const Number          &shear,
                      const Number          &friction,
                      const Number          &stiffness) const
  {
    const Number zero{}, one = zero + 1.;
    const Number compliance    = 1. / stiffness;
    const Number opening_slope = point.tensile_strength * compliance;
    const Number slip_slope    = point.cohesion * compliance;

    const auto flow_at = [&](const Number &share) {
      return Flow<Number>{
        compliance * max(normal - share * point.tensile_strength, zero),
        compliance * max(shear - share * point.cohesion - friction, zero)};
    };

    Number share = point.softening;
    for (unsigned int iteration = 0; iteration < 3; ++iteration)
      {
        const auto   flow = flow_at(share);
        const Number opening =
          point.opening + flow.opening * point.inverse_opening;
        const Number slip   = point.slip + flow.slip * point.inverse_slip;
        const Number damage = sqrt(opening * opening + slip * slip);
        const Number inside = min(damage, one);
        const Number slope =
          -(opening * select(flow.opening > zero,
                             opening_slope * point.inverse_opening,
                             zero) +
            slip *
              select(flow.slip > zero, slip_slope * point.inverse_slip, zero)) /
          max(damage, zero + 1e-300);
        const Number residual = share - softening.value(inside);
        const Number gain =
          select(damage < one, softening.slope(inside) * slope, zero);
        share = share - residual / (1. - gain);
        share = max(min(share, point.softening), zero);
      }

    const auto flow  = flow_at(share);
    const auto alive = point.softening > zero;
    point.opening    = select(alive,
                           point.opening + flow.opening * point.inverse_opening,
                           point.opening);
    point.slip =
      select(alive, point.slip + flow.slip * point.inverse_slip, point.slip);
    const Number damage_squared =
      point.opening * point.opening + point.slip * point.slip;
    point.softening = select(damage_squared >= one, zero, share);
    return flow;
  }
} // namespace rift

#endif
