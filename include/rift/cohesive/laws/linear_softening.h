#ifndef rift_cohesive_laws_linear_softening_h
#define rift_cohesive_laws_linear_softening_h

#include <rift/base/check.h>
#include <rift/cohesive/cohesive_model.h>
#include <rift/cohesive/laws/fields.h>
#include <rift/cohesive/laws/law_values.h>
#include <rift/material/face_strength.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  /** What a Gauss point under LinearSoftening remembers. */
  template <typename Number>
  struct LinearSofteningPoint
  {
    /** Jump without traction, m, and the traction at the last update, Pa. */
    Vector3<Number> offset, traction;

    /** The effective traction that can be held, and the irreversible effective
     * jump over which it falls to zero. */
    Number strength, separation;

    /** The damage D, and the part that sliding has in D^2. */
    Number damage, sliding;

    /** All members with their names; see PointField. */
    static constexpr auto
    fields()
    {
      using Point = LinearSofteningPoint;
      return std::make_tuple(field("offset", &Point::offset),
                             field("traction", &Point::traction),
                             field("strength", &Point::strength),
                             field("separation", &Point::separation),
                             field("damage", &Point::damage),
                             field("sliding", &Point::sliding));
    }
  };

  /** What the Gauss points of a face under LinearSoftening have in common. */
  template <typename Number>
  struct LinearSofteningConstants
  {
    /** Slope of the elastic branch, Pa/m. */
    Number stiffness;

    /** Pa. */
    Number tensile_strength, cohesion;

    /** Coefficients of friction of the intact and of the failed face. */
    Number tan_friction_angle, residual_friction;

    /** Effective jumps at the strength, that is elastic energy over fracture
     * energy, in opening and in sliding. */
    Number opening_compliance, sliding_compliance;

    /** All members with their names; see PointField. */
    static constexpr auto
    fields()
    {
      using Constants = LinearSofteningConstants;
      return std::make_tuple(
        field("stiffness", &Constants::stiffness),
        field("tensile strength", &Constants::tensile_strength),
        field("cohesion", &Constants::cohesion),
        field("tan friction angle", &Constants::tan_friction_angle),
        field("residual friction", &Constants::residual_friction),
        field("opening compliance", &Constants::opening_compliance),
        field("sliding compliance", &Constants::sliding_compliance));
    }

    /** Coefficient of friction at a damage. */
    Number
    friction_at(const Number &damage) const
    {
      return tan_friction_angle +
             damage * (residual_friction - tan_friction_angle);
    }
  };

  /**
   * Cohesive law: linear softening of one effective traction with one effective
   * jump, and Coulomb friction in compression, after Camacho and Ortiz and
   * Snozzi and Molinari (doc/theory.md, eqs. 14d to 14g).
   *
   * Tractions count in units of the strengths T and C, jumps in units of 2 G_I/T
   * and 2 G_II/C; the effective ones are the roots of the sums of the squares of
   * opening and sliding. The effective traction falls linearly with the
   * irreversible effective jump, which has the direction of the traction, from
   * (0, 1) to (1, 0). An elastic branch stands before it, along which the point
   * unloads. Friction carries shear besides the cohesion.
   *
   * `Number` is double or Simd.
   */
  class LinearSoftening
  {
  public:
    /** What a Gauss point remembers. */
    template <typename Number>
    using Point = LinearSofteningPoint<Number>;

    /** What the points of a face have in common. */
    template <typename Number>
    using Constants = LinearSofteningConstants<Number>;

    /** The value of the entry Cohesive law, the model that it serves, and what
     * it does. */
    static constexpr const char   *name  = "linear";
    static constexpr CohesiveModel model = CohesiveModel::extrinsic;
    static constexpr const char   *summary =
      "cracks follow faces as well, and opening and sliding make one effective "
      "jump, with which the traction softens along a line (eq. 14d of "
      "doc/theory.md)";

    /** The constants of one face. `stiffness` is the slope of the elastic branch, Pa/m. */
    static Constants<double>
    make_constants(const FaceStrength &strength, const double stiffness)
    {
      const auto compliance = [stiffness](const double of_strength,
                                          const double energy) {
        return .5 * of_strength * of_strength / (stiffness * energy);
      };
      return {stiffness,
              strength.tensile_strength,
              strength.cohesion,
              strength.tan_friction_angle,
              strength.residual_friction,
              compliance(strength.tensile_strength, strength.fracture_energy_1),
              compliance(strength.cohesion, strength.fracture_energy_2)};
    }

    /** A point that has not opened. */
    static Point<double>
    make_point(const FaceStrength &, const Constants<double> &constants)
    {
      Point<double> point{};
      point.strength = 1;
      set_separation(point, constants, 1);
      return point;
    }

    /** Whether the line falls no faster than the branch rises. */
    static bool
    is_resolved(const FaceStrength &, const Constants<double> &constants)
    {
      return shortest_separation(constants) <= 1;
    }

    /**
     * Gives a point more traction than it had at its last update. What is above
     * the strength becomes the strength; the energy that is still to be drawn
     * from the body stays the same.
     */
    static InitialEnergy
    hold_traction(Point<double>           &point,
                  const FaceStrength      &strength,
                  const Constants<double> &constants,
                  const Vector3<double>   &jump,
                  const Vector3<double>   &more)
    {
      const Demand<double> had(point.traction, point.damage, constants);
      const double         held    = elastic_energy(point, constants);
      const double         to_come = point.strength * point.separation -
                             had.fracture_part(strength, constants);
      // A failed point that is open keeps its place of closing as offset, which
      // is none of its elastic branch.
      if (point.damage >= 1 && point.traction[0] == 0)
        point.offset[0] = jump[0];
      point.offset -= (1 / constants.stiffness) * more;
      point.traction += more;

      const Demand<double> has(point.traction, point.damage, constants);
      point.strength = std::max(point.strength, has.effective);
      set_separation(point,
                     constants,
                     to_come + has.fracture_part(strength, constants));
      const double given =
        has.cohesive_energy(constants) - had.cohesive_energy(constants);
      return {given, elastic_energy(point, constants) - held - given};
    }

    /** Moves a point to a new jump, m; see MohrCoulomb::update(). */
    template <typename Number>
    Dissipation<Number>
    update(Point<Number>           &point,
           const Constants<Number> &constants,
           const Vector3<Number>   &jump) const
    {
      const Number          zero{};
      const Vector3<Number> former = point.traction;
      const Vector3<Number> trial = constants.stiffness * (jump - point.offset);
      const Demand<Number>  demand(trial, point.damage, constants);
      const auto            yields = demand.effective > point.strength;
      point.traction               = trial;
      if (!any(yields))
        return {zero, zero};

      const Point<Number>    elastic = point;
      const Cohesive<Number> left    = soften(point, demand, constants);
      const Number           friction =
        constants.friction_at(point.damage) * demand.pressure;
      const Number shear = (left.cohesion + friction) / nonzero(demand.shear);
      Vector3<Number> &t = point.traction;
      t                  = {{select(trial[0] > zero, left.tension, trial[0]),
                             shear * trial[1],
                             shear * trial[2]}};
      const Vector3<Number> flow = (1. / constants.stiffness) * (trial - t);
      point.offset += flow;
      // A failed point that is open will close where it was cut.
      const MaskOf<Number> has_parted = (point.damage >= 1.) &
                                        (point.strength <= zero) &
                                        (flow[0] > zero) & (jump[0] > zero);
      point.offset[0] = select(has_parted, zero, point.offset[0]);
      t[0]            = select(has_parted, zero, t[0]);

      // That a failed point leaves contact in the midst of a step is an error of
      // the time integration: it belongs to the residual.
      const Number opening = select(has_parted & (former[0] < zero),
                                    zero,
                                    .5 * (t[0] + former[0]) * flow[0]);
      const auto   sliding = dissipation_of_sliding(
        flow,
        (zero + .5) * (former + t),
        .5 * (elastic.strength + point.strength) * constants.cohesion,
        (trial[0] < zero) | (former[0] < zero));
      keep_unless(yields, elastic, point);
      return {select(yields, opening + sliding.fracture, zero),
              select(yields, sliding.friction, zero)};
    }

    /** Elastic energy per area at the last update, J/m^2. */
    template <typename Number>
    static Number
    elastic_energy(const Point<Number>     &point,
                   const Constants<Number> &constants)
    {
      return .5 * dot(point.traction, point.traction) / constants.stiffness;
    }

    /** The damage by opening and by sliding. */
    template <typename Number>
    static Damage<Number>
    damage(const Point<Number> &point)
    {
      return {sqrt(max(point.damage * point.damage - point.sliding, Number{})),
              sqrt(point.sliding)};
    }

    /** Where no strength is left but friction. */
    template <typename Number>
    static auto
    has_failed(const Point<Number> &point)
    {
      return point.damage >= 1.;
    }

  private:
    /** What a traction asks of the cohesive forces. */
    template <typename Number>
    struct Demand
    {
      Demand(const Vector3<Number>   &traction,
             const Number            &damage,
             const Constants<Number> &constants)
        : shear(sqrt(traction[1] * traction[1] + traction[2] * traction[2]))
        , tension(max(traction[0], Number{}))
        , pressure(max(-traction[0], Number{}))
        , cohesion(
            max(shear - constants.friction_at(damage) * pressure, Number{}))
        , opening(tension / constants.tensile_strength)
        , sliding(cohesion / constants.cohesion)
        , effective(sqrt(opening * opening + sliding * sliding))
      {
      }

      /** Elastic energy of what the cohesive forces carry, J/m^2. */
      Number
      cohesive_energy(const Constants<Number> &constants) const
      {
        return .5 * (tension * tension + cohesion * cohesion) /
               constants.stiffness;
      }

      /** That over the fracture energy of this mixture of modes. */
      Number
      fracture_part(const FaceStrength      &strength,
                    const Constants<Number> &constants) const
      {
        return cohesive_energy(constants) * effective * effective /
               nonzero(strength.fracture_energy_1 * opening * opening +
                       strength.fracture_energy_2 * sliding * sliding);
      }

      /** Pa; the cohesion is what friction leaves of the shear. */
      Number shear, tension, pressure, cohesion;

      /** In units of the strengths. */
      Number opening, sliding, effective;
    };

    /** Of a point of strength 1: its line falls as fast as the branch rises. */
    static double
    shortest_separation(const Constants<double> &constants)
    {
      return 2 * std::max(constants.opening_compliance,
                          constants.sliding_compliance);
    }

    /** Chooses the separation such that the line takes an energy, which is 1 for
     * the fracture energy. */
    static void
    set_separation(Point<double>           &point,
                   const Constants<double> &constants,
                   const double             energy)
    {
      point.separation =
        std::max(energy / nonzero(point.strength),
                 shortest_separation(constants) * point.strength);
    }

    /** What tension and cohesion carry, Pa. */
    template <typename Number>
    struct Cohesive
    {
      Number tension, cohesion;
    };

    /**
     * The flow of eq. (14f), with which a demand beyond the strength comes back
     * to the line. Newton's iteration comes near it from below, in one step in a
     * single mode, where the equation is linear.
     *
     * @param[out] separates where there is none: nothing is left.
     */
    template <typename Number>
    static Number
    flow_to_line(const Point<Number>     &point,
                 const Demand<Number>    &demand,
                 const Constants<Number> &constants,
                 MaskOf<Number>          &separates)
    {
      constexpr unsigned int n_iterations = 4;
      constexpr double       no_strength  = 1e-30;
      const Number strength   = max(point.strength, Number{} + no_strength);
      const Number line_slope = 1. / nonzero(point.separation);
      separates               = point.strength < no_strength;
      Number flow{};
      for (unsigned int i = 0; i < n_iterations; ++i)
        {
          const Number n = 1. / (1. + flow / constants.opening_compliance);
          const Number s = 1. / (1. + flow / constants.sliding_compliance);
          const Number opening = n * demand.opening;
          const Number sliding = s * demand.sliding;
          const Number square  = nonzero(opening * opening + sliding * sliding);
          const Number inverse = 1. / sqrt(square);
          const Number slope =
            inverse / square *
              (opening * opening * n / constants.opening_compliance +
               sliding * sliding * s / constants.sliding_compliance) -
            line_slope;
          separates = separates | (slope <= 0.);
          flow += max(1. / strength + flow * line_slope - inverse, Number{}) /
                  select(separates, Number{} + 1., slope);
        }
      return flow;
    }

    /** Takes a demand beyond the strength back to the line, which falls with the
     * irreversible jump. */
    template <typename Number>
    static Cohesive<Number>
    soften(Point<Number>           &point,
           const Demand<Number>    &demand,
           const Constants<Number> &constants)
    {
      const Number   zero{};
      MaskOf<Number> separates;
      const Number   flow = flow_to_line(point, demand, constants, separates);
      const Number   opening =
        demand.opening / (1. + flow / constants.opening_compliance);
      const Number sliding =
        demand.sliding / (1. + flow / constants.sliding_compliance);
      const Number effective =
        nonzero(sqrt(opening * opening + sliding * sliding));

      const Number left =
        select(separates,
               zero,
               1. / (1. + flow * point.strength / nonzero(point.separation)));
      rift_check(!any((left < 0.) | (left > 1.)));
      const Number damage = 1. - (1. - point.damage) * left;
      const Number mode   = sliding / effective;
      point.sliding +=
        mode * mode * (damage * damage - point.damage * point.damage);
      point.damage = damage;
      point.strength *= left;
      point.separation *= left;

      const Number back = min(point.strength / effective, zero + 1.);
      return {back * opening * constants.tensile_strength,
              back * sliding * constants.cohesion};
    }

    /**
     * Of what sliding takes, the cohesion has its own and friction the rest.
     *
     * @param mean traction, and what cohesion carries of that, Pa: by the
     *   trapezoidal rule, as the central differences do their work.
     */
    template <typename Number, typename Mask>
    static Dissipation<Number>
    dissipation_of_sliding(const Vector3<Number> &flow,
                           const Vector3<Number> &mean,
                           const Number          &cohesion,
                           const Mask            &is_pressed)
    {
      const Number zero{};
      const Number all  = mean[1] * flow[1] + mean[2] * flow[2];
      const Number slip = sqrt(flow[1] * flow[1] + flow[2] * flow[2]);
      const Number friction =
        select(is_pressed, all - min(cohesion * slip, max(all, zero)), zero);
      return {all - friction, friction};
    }

    /** A divisor that is not zero. */
    template <typename Number>
    static Number
    nonzero(const Number &a)
    {
      return max(a, Number{} + 1e-300);
    }
  };
} // namespace rift

#endif
