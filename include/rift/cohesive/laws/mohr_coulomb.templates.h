#ifndef rift_cohesive_laws_mohr_coulomb_templates_h
#define rift_cohesive_laws_mohr_coulomb_templates_h

#include <rift/base/check.h>
#include <rift/cohesive/laws/mohr_coulomb.h>

// The functions of MohrCoulomb that exist for all types of numbers.
namespace rift
{
  template <typename Branch>
  template <typename Number>
  typename MohrCoulomb<Branch>::template Peaks<Number>
  MohrCoulomb<Branch>::peaks_of(const Point<Number>     &point,
                                const Constants<Number> &constants)
  {
    return {point.softening * constants.tensile_strength + point.normal_excess,
            point.softening * constants.cohesion + point.shear_excess,
            constants.friction_at(point.softening)};
  }

  template <typename Branch>
  template <typename Number>
  typename MohrCoulomb<Branch>::template Overstress<Number>
  MohrCoulomb<Branch>::overstress(const TrialTraction<Number> &trial,
                                  const Peaks<Number>         &peaks)
  {
    const Number zero{};
    return {max(trial.normal - Branch::peak_ratio * peaks.normal, zero),
            max(trial.shear - (Branch::peak_ratio * peaks.shear +
                               peaks.friction * trial.pressure),
                zero)};
  }

  template <typename Branch>
  template <typename Number>
  Vector3<Number>
  MohrCoulomb<Branch>::elastic_traction(const TrialTraction<Number> &trial,
                                        const Peaks<Number>         &peaks)
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
                      peak * Branch::trial_ratio(share));
      }
  }

  template <typename Branch>
  template <typename Number, typename Mask>
  Vector3<Number>
  MohrCoulomb<Branch>::intact_traction(const Constants<Number> &constants,
                                       const Vector3<Number>   &jump,
                                       Mask                    &yields)
  {
    const TrialTraction<Number> trial(constants, jump);
    const Peaks<Number>         peaks = {constants.tensile_strength,
                                         constants.cohesion,
                                         constants.friction_at(Number{} + 1.)};
    const Overstress<Number>    over  = overstress(trial, peaks);
    yields = (over.normal > Number{}) | (over.shear > Number{});
    return elastic_traction(trial, peaks);
  }

  template <typename Branch>
  template <typename Number>
  Number
  MohrCoulomb<Branch>::intact_energy(const Constants<Number> &constants,
                                     const Vector3<Number>   &jump)
  {
    Point<Number>  point{};
    MaskOf<Number> yields;
    point.softening = Number{} + 1.;
    point.traction  = intact_traction(constants, jump, yields);
    return elastic_energy(point, constants);
  }

  template <typename Branch>
  template <typename Number>
  Number
  MohrCoulomb<Branch>::elastic_energy(const Point<Number>     &point,
                                      const Constants<Number> &constants)
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
  MohrCoulomb<Branch>::update(Point<Number>           &point,
                              const Constants<Number> &constants,
                              const Vector3<Number>   &jump) const
  {
    const Number                zero{};
    Vector3<Number>             former = point.traction;
    const TrialTraction<Number> trial(constants, jump - point.offset);
    const Peaks<Number>         before = peaks_of(point, constants);
    const Overstress<Number>    over   = overstress(trial, before);
    const auto yields = (over.normal > zero) | (over.shear > zero);
    point.traction    = elastic_traction(trial, before);
    if (!any(yields))
      return {zero, zero};

    if constexpr (!Branch::is_straight)
      former = former_traction(point, former, before, trial.pressure);
    const Point<Number> elastic    = point;
    const Number        compliance = 1. / constants.stiffness;
    soften(point, constants, compliance * over.normal, compliance * over.shear);
    const Flow<Number>  flow = flow_to_envelope(point, constants, trial, jump);
    Dissipation<Number> dissipation =
      dissipation_of(flow, point, former, before, trial, constants);

    // To the last bit, a point must not feel that a neighbour in its batch
    // yields: on another number of ranks it has other neighbours.
    keep_unless(yields, elastic, point);
    dissipation.fracture = select(yields, dissipation.fracture, zero);
    dissipation.friction = select(yields, dissipation.friction, zero);
    return dissipation;
  }

  template <typename Branch>
  template <typename Number>
  Vector3<Number>
  MohrCoulomb<Branch>::former_traction(const Point<Number>   &point,
                                       const Vector3<Number> &former,
                                       const Peaks<Number>   &peaks,
                                       const Number          &pressure)
  {
    const Number shear = sqrt(point.traction[1] * point.traction[1] +
                              point.traction[2] * point.traction[2]);
    const Number share =
      min((peaks.shear + peaks.friction * pressure) / nonzero(shear),
          Number{} + 1.);
    const Vector3<Number> peak = {{min(point.traction[0], peaks.normal),
                                   share * point.traction[1],
                                   share * point.traction[2]}};
    Vector3<Number>       result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] =
        select(point.opening + point.slip > Number{}, former[d], peak[d]);
    return result;
  }

  template <typename Branch>
  template <typename Number>
  typename MohrCoulomb<Branch>::template Flow<Number>
  MohrCoulomb<Branch>::flow_to_envelope(Point<Number>               &point,
                                        const Constants<Number>     &constants,
                                        const TrialTraction<Number> &trial,
                                        const Vector3<Number>       &jump)
  {
    // The branch ends at the peaks that are left; the rest is irreversible.
    const Number             zero{};
    const Number             compliance = 1. / constants.stiffness;
    const Peaks<Number>      peaks      = peaks_of(point, constants);
    const Overstress<Number> over       = overstress(trial, peaks);
    const Number             opening    = compliance * over.normal;
    const Number             slip       = compliance * over.shear;
    const Number             slip_share = slip / nonzero(trial.shear);
    Vector3<Number>          flow       = {{opening, zero, zero}};
    for (unsigned int d = 1; d < dim; ++d)
      flow[d] = slip_share * trial.vector[d];
    point.offset += flow;
    const TrialTraction<Number> rest(constants, jump - point.offset);
    point.traction = elastic_traction(rest, peaks);

    const MaskOf<Number> has_parted = (point.softening <= zero) &
                                      (point.normal_excess <= zero) &
                                      (opening > zero) & (jump[0] > zero);
    point.offset[0]   = select(has_parted, zero, point.offset[0]);
    point.traction[0] = select(has_parted, zero, point.traction[0]);
    return {flow, opening, slip, peaks, rest, has_parted};
  }

  template <typename Branch>
  template <typename Number>
  Dissipation<Number>
  MohrCoulomb<Branch>::dissipation_of(const Flow<Number>          &flow,
                                      const Point<Number>         &point,
                                      const Vector3<Number>       &former,
                                      const Peaks<Number>         &before,
                                      const TrialTraction<Number> &trial,
                                      const Constants<Number>     &constants)
  {
    // Of what sliding takes, the cohesion has its own and friction the rest.
    // That a failed point leaves contact in the midst of a step is an error of
    // the time integration, not fracture: it belongs to the residual.
    const Number                 zero{};
    const Vector3<Number>       &t     = point.traction;
    const Peaks<Number>         &after = flow.peaks;
    const TrialTraction<Number> &rest  = flow.rest;
    const Number of_opening = select(flow.has_parted & (former[0] < zero),
                                     zero,
                                     .5 * (t[0] + former[0]) * flow.opening);
    const Number sliding    = .5 * ((t[1] + former[1]) * flow.jump[1] +
                                 (t[2] + former[2]) * flow.jump[2]);
    const Number of_cohesion =
      min(.5 * (before.shear + after.shear) * flow.slip, max(sliding, zero));
    Dissipation<Number> dissipation;
    dissipation.friction = select((trial.normal < zero) | (former[0] < zero),
                                  sliding - of_cohesion,
                                  zero);
    dissipation.fracture = of_opening + sliding - dissipation.friction;
    if constexpr (!Branch::is_straight)
      {
        const Number compliance = 1. / constants.stiffness;
        const auto   released   = [&](const Number &shear) {
          return compliance * (trial_energy(shear, before.shear) -
                               trial_energy(shear, after.shear));
        };
        const Number of_cohesive_shear =
          released(min(rest.shear, Branch::peak_ratio * after.shear));
        dissipation.fracture +=
          compliance * (trial_energy(rest.normal, before.normal) -
                        trial_energy(rest.normal, after.normal)) +
          of_cohesive_shear;
        dissipation.friction += released(rest.shear) - of_cohesive_shear;
      }
    return dissipation;
  }

  template <typename Branch>
  template <typename Number>
  void
  MohrCoulomb<Branch>::soften(Point<Number>           &point,
                              const Constants<Number> &constants,
                              const Number            &opening,
                              const Number            &slip) const
  {
    const Number zero{}, one = zero + 1.;
    rift_check(!any((opening < zero) | (slip < zero)));
    const auto alive = point.softening > zero;
    point.opening += select(alive, opening * constants.inverse_opening, zero);
    point.slip += select(alive, slip * constants.inverse_slip, zero);
    const Number damage_squared =
      point.opening * point.opening + point.slip * point.slip;
    const Number share =
      min(softening(sqrt(min(damage_squared, one))), point.softening);
    rift_check(!any(share < zero));
    point.softening     = select(damage_squared >= one, zero, share);
    const Number fall   = excess_slope * constants.stiffness;
    point.normal_excess = max(point.normal_excess - fall * opening, zero);
    point.shear_excess  = max(point.shear_excess - fall * slip, zero);
  }
} // namespace rift

#endif
