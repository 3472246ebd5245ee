#include <rift/base/check.h>
#include <rift/contact/contact_pair.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** Constants and memories of eight pairs, lane by lane; those of
     * ContactConstants and ContactMemory. */
    struct PairBatch
    {
      PairBatch(const ContactPair *pairs, const unsigned int n)
      {
        for (unsigned int lane = 0; lane < batch_size; ++lane)
          {
            // Lanes without a pair do as the last one.
            const ContactPair &pair = pairs[std::min(lane, n - 1)];
            a[lane]                 = pair.cells.a;
            b[lane]                 = pair.cells.b;
            penalty[lane]           = pair.constants.penalty;
            friction[lane]          = pair.constants.friction;
            damping[lane]           = pair.constants.damping;
            mass[lane]              = pair.constants.mass;
            initial_potential[lane] = pair.memory.initial_potential;
            for (unsigned int d = 0; d < 3; ++d)
              slip[d][lane] = pair.memory.slip[d];
            stiffness[lane]     = pair.memory.stiffness;
            damping_force[lane] = pair.memory.damping_force;
            old_penalty[lane]   = pair.memory.penalty;
            old_energy[lane]    = pair.memory.energy;
          }
      }

      void
      write_memory(ContactPair *pairs, const unsigned int n) const
      {
        for (unsigned int lane = 0; lane < n; ++lane)
          pairs[lane].memory = {initial_potential[lane],
                                {{slip[0][lane], slip[1][lane], slip[2][lane]}},
                                stiffness[lane],
                                damping_force[lane],
                                old_penalty[lane],
                                old_energy[lane]};
      }

      Simd
      spring_energy() const
      {
        return .5 * stiffness * dot(slip, slip);
      }

      std::array<std::uint32_t, batch_size> a, b;

      Simd          penalty, friction, damping, mass;
      Simd          initial_potential, stiffness, damping_force;
      Simd          old_penalty, old_energy;
      Vector3<Simd> slip;
    };

    /** PairForces of eight pairs, lane by lane. */
    struct ForceBatch
    {
      void
      write(PairForces *forces, const unsigned int n) const
      {
        for (unsigned int c = 0; c < 4; ++c)
          {
            const auto a = transpose_to_rows(on_a[c]),
                       b = transpose_to_rows(on_b[c]);
            for (unsigned int lane = 0; lane < n; ++lane)
              {
                forces[lane].on_a[c].row() = a[lane];
                forces[lane].on_b[c].row() = b[lane];
              }
          }
        for (unsigned int lane = 0; lane < n; ++lane)
          {
            forces[lane].energy        = energy[lane];
            forces[lane].friction_loss = friction_loss[lane];
            forces[lane].damping_loss  = damping_loss[lane];
            forces[lane].overlaps      = overlaps[lane] != 0;
            forces[lane].touches       = energy[lane] > 0;
            forces[lane].is_deep       = is_deep[lane] != 0;
            forces[lane].is_too_deep   = is_too_deep[lane] != 0;
          }
      }

      std::array<Vector3<Simd>, 4> on_a, on_b;
      Simd                         energy, friction_loss, damping_loss;
      SimdMask                     overlaps, is_deep, is_too_deep;
    };

    Vector3<Simd>
    select(const SimdMask      &mask,
           const Vector3<Simd> &if_true,
           const Vector3<Simd> &if_false)
    {
      return {{rift::select(mask, if_true[0], if_false[0]),
               rift::select(mask, if_true[1], if_false[1]),
               rift::select(mask, if_true[2], if_false[2])}};
    }

    Simd
    norm(const Vector3<Simd> &a)
    {
      return rift::sqrt(dot(a, a));
    }

    /** The part of a vector across a normal. */
    Vector3<Simd>
    across(const Vector3<Simd> &vector, const Vector3<Simd> &normal)
    {
      return vector - dot(vector, normal) * normal;
    }

    /** Turns the slip into the plane of the contact as it is now. */
    Vector3<Simd>
    turned(const Vector3<Simd> &slip, const Vector3<Simd> &normal)
    {
      const Vector3<Simd> in_plane = across(slip, normal);
      const Simd          length   = norm(in_plane);
      return select(length > 0, (norm(slip) / length) * in_plane, in_plane);
    }

    /** Whether the weights of points among corners sum to 1, but for rounding.
     */
    bool
    sum_to_one(const std::array<Simd, 4> &weights, const SimdMask &overlaps)
    {
      const Simd error = weights[0] + weights[1] + weights[2] + weights[3] - 1;
      return !any(overlaps & ((error > 1e-9) | (error < -1e-9)));
    }

    /**
     * Whether the forces on both cells cancel. Their rounding is that of the
     * coordinates, so that it grows as the overlap becomes shallow. What is not
     * a number passes.
     */
    bool
    cancel(const ForceBatch &forces, const Simd &volume_fraction)
    {
      Vector3<Simd> sum{};
      Simd          scale{};
      for (unsigned int c = 0; c < 4; ++c)
        {
          sum += forces.on_a[c] + forces.on_b[c];
          scale += norm(forces.on_a[c]) + norm(forces.on_b[c]);
        }
      return !any(norm(sum) * volume_fraction > 1e-14 * scale);
    }

    /** The speed of A against B at the centroid of the overlap, m/s. */
    Vector3<Simd>
    sliding_velocity(const PackedMotion *cells,
                     const PairBatch    &pairs,
                     const OverlapOctet &common)
    {
      Vector3<Simd> of_a{}, of_b{};
      for (unsigned int c = 0; c < 4; ++c)
        {
          of_a +=
            common.weights_a[c] * gather_row(cells, pairs.a.data(), 4 + c);
          of_b +=
            common.weights_b[c] * gather_row(cells, pairs.b.data(), 4 + c);
        }
      return of_a - of_b;
    }

    /**
     * Takes in that the penalty has changed, which rises only where there was
     * no force.
     *
     * @return of the elastic energy, what is lost with a penalty that falls, J:
     *   that of the step before must be known, and that of now is result.energy
     *   (eq. 27c).
     */
    Simd
    soften(PairBatch &pairs, const ForceBatch &result)
    {
      const Simd ratio = pairs.penalty / pairs.old_penalty;
      const Simd loss  = .5 * (1 - ratio) * pairs.old_energy +
                        .5 * (1 / ratio - 1) * result.energy;
      const SimdMask is_softer =
        (pairs.old_energy > 0) & (pairs.penalty < pairs.old_penalty);
      pairs.old_penalty = pairs.penalty;
      pairs.old_energy  = result.energy;
      return rift::select(is_softer, loss, Simd{});
    }

    /**
     * Sets the elastic forces, energy and depth (eq. 26).
     *
     * @return derivative of the energy by the potential, Pa.
     */
    Simd
    press(const OverlapOctet &common, PairBatch &pairs, ForceBatch &result)
    {
      const Simd initial      = min(common.potential, pairs.initial_potential);
      pairs.initial_potential = initial;
      pairs.penalty           = rift::select(pairs.old_energy > 0,
                                   min(pairs.penalty, pairs.old_penalty),
                                   pairs.penalty);
      const Simd root         = rift::sqrt(common.potential);
      const Simd excess       = root - rift::sqrt(initial);
      const Simd slope        = pairs.penalty * excess / root;
      rift_check(!any(result.overlaps &
                      ((common.potential < 0) | (initial < 0) | (slope < 0))));
      result.energy  = pairs.penalty * excess * excess;
      result.is_deep = common.potential > deep_mean_potential * common.volume;
      result.is_too_deep =
        (initial == 0) &
        ((common.potential > largest_mean_potential * common.volume) |
         (common.volume_fraction > largest_volume_fraction));
      for (unsigned int c = 0; c < 4; ++c)
        {
          result.on_a[c] = -slope * common.gradient_a[c];
          result.on_b[c] = -slope * common.gradient_b[c];
        }
      return slope;
    }

    /**
     * Moves the damper, which never pulls by more than the elastic force
     * pushes.
     *
     * @param speed of A against B along the force on A, m/s.
     * @return its force, N.
     */
    Simd
    damp(const Simd  &stiffness,
         const Simd  &elastic,
         const Simd  &speed,
         const double time_step,
         PairBatch   &pairs,
         ForceBatch  &result)
    {
      // In this order what is not a number remains so.
      const Simd force =
        max(-elastic,
            -2 * pairs.damping * rift::sqrt(stiffness * pairs.mass) * speed);
      result.damping_loss =
        -.5 * (pairs.damping_force + force) * speed * time_step;
      pairs.damping_force = force;
      return force;
    }

    /**
     * Moves the spring of friction.
     *
     * @param normal_force N.
     * @param shift of A against B in the plane since the step before, m.
     * @return energy that has been used up, J: by the trapezoidal rule, as the
     *   central differences count the work of the spring.
     */
    Simd
    slide(const Vector3<Simd> &normal,
          const Simd          &normal_force,
          const Simd          &stiffness,
          const Vector3<Simd> &shift,
          PairBatch           &pairs)
    {
      pairs.slip                    = turned(pairs.slip, normal);
      const Vector3<Simd> old_force = pairs.stiffness * pairs.slip;
      const Simd          before    = pairs.spring_energy();
      // A spring that becomes stiffer keeps its force, one that becomes softer
      // its elongation: neither makes energy.
      pairs.slip      = select(stiffness > pairs.stiffness,
                          (pairs.stiffness / stiffness) * pairs.slip,
                          pairs.slip);
      pairs.stiffness = stiffness;
      pairs.slip += shift;
      const Simd length  = norm(pairs.slip);
      const Simd longest = pairs.friction * normal_force / pairs.stiffness;
      pairs.slip =
        select(length > longest, (longest / length) * pairs.slip, pairs.slip);
      const Vector3<Simd> force = pairs.stiffness * pairs.slip;
      return .5 * dot(old_force + force, shift) -
             (pairs.spring_energy() - before);
    }

    /**
     * Corrects what has been computed for all alike. Pairs that do not overlap
     * have no forces and forget; those without an elastic force have neither
     * damper nor spring, those without friction no spring.
     *
     * @param before memories before the step.
     */
    void
    settle(const PairBatch &before,
           const SimdMask  &is_pressed,
           PairBatch       &pairs,
           ForceBatch      &result)
    {
      const Simd          zero{};
      const Vector3<Simd> none{};
      const SimdMask     &overlaps = result.overlaps,
                     rubs          = is_pressed & (pairs.friction > 0);
      pairs.initial_potential =
        rift::select(overlaps, pairs.initial_potential, zero);
      pairs.damping_force = rift::select(is_pressed, pairs.damping_force, zero);
      pairs.slip =
        select(rubs, pairs.slip, select(is_pressed, before.slip, none));
      pairs.stiffness =
        rift::select(rubs,
                     pairs.stiffness,
                     rift::select(overlaps, before.stiffness, zero));
      pairs.old_penalty = rift::select(is_pressed, pairs.old_penalty, zero);
      pairs.old_energy  = rift::select(is_pressed, pairs.old_energy, zero);
      result.friction_loss =
        rift::select(rubs,
                     result.friction_loss,
                     rift::select(is_pressed, zero, before.spring_energy()));
      result.damping_loss = rift::select(is_pressed, result.damping_loss, zero);
      result.energy       = rift::select(rubs,
                                   result.energy + pairs.spring_energy(),
                                   rift::select(overlaps, result.energy, zero));
      result.is_deep &= overlaps;
      result.is_too_deep &= overlaps;
      for (unsigned int c = 0; c < 4; ++c)
        {
          result.on_a[c] = select(overlaps, result.on_a[c], none);
          result.on_b[c] = select(overlaps, result.on_b[c], none);
        }
    }

    /** The law of eight pairs, of which some may not overlap. */
    ForceBatch
    apply_law(const PackedMotion *cells,
              const OverlapOctet &common,
              const double        time_step,
              PairBatch          &pairs)
    {
      const PairBatch before = pairs;
      ForceBatch      result;
      result.overlaps = common.volume > 0;
      rift_check(sum_to_one(common.weights_a, result.overlaps) &&
                 sum_to_one(common.weights_b, result.overlaps));
      const Simd    slope          = press(common, pairs, result);
      const Simd    softening_loss = soften(pairs, result);
      Vector3<Simd> force{};
      for (const Vector3<Simd> &f : result.on_a)
        force += f;
      const Simd          elastic    = norm(force);
      const SimdMask      is_pressed = result.overlaps & ~(elastic == 0);
      const Vector3<Simd> normal     = (1 / elastic) * force;
      const Vector3<Simd> velocity   = sliding_velocity(cells, pairs, common);
      // Of faces that lie flat upon each other the potential is half of the
      // stiffness times the square of the depth, over the penalty.
      const Simd stiffness = elastic * elastic / (2 * slope * common.potential);

      const Simd damping_force = damp(stiffness,
                                      elastic,
                                      dot(velocity, normal),
                                      time_step,
                                      pairs,
                                      result);
      result.damping_loss += softening_loss;
      result.friction_loss =
        slide(normal,
              elastic + damping_force,
              friction_stiffness_ratio * stiffness,
              broadcast(time_step) * across(velocity, normal),
              pairs);
      const Vector3<Simd> damper = damping_force * normal;
      const Vector3<Simd> added  = select(is_pressed & (pairs.friction > 0),
                                         damper - pairs.stiffness * pairs.slip,
                                         select(is_pressed, damper, {}));
      for (unsigned int c = 0; c < 4; ++c)
        {
          result.on_a[c] += common.weights_a[c] * added;
          result.on_b[c] -= common.weights_b[c] * added;
        }
      settle(before, is_pressed, pairs, result);
      rift_check(
        !any(is_pressed & (pairs.friction > 0) &
             (pairs.stiffness * norm(pairs.slip) >
              (1 + 1e-12) * pairs.friction * (elastic + damping_force))));
      rift_check(cancel(result, common.volume_fraction));
      return result;
    }
  } // namespace

  void
  PairKernel::compute(const PackedMotion *cells,
                      ContactPair        *pairs,
                      const unsigned int  n,
                      const double        time_step,
                      PairForces         *forces)
  {
    rift_check(n <= chunk_size);
    std::array<CellPair, chunk_size> names{};
    for (unsigned int i = 0; i < n; ++i)
      names[i] = pairs[i].cells;
    const OverlapOctet *common = overlaps.intersect(cells, names.data(), n);
    for (unsigned int first = 0; first < n; first += batch_size)
      {
        const unsigned int n_here = std::min(batch_size, n - first);
        PairBatch          batch(pairs + first, n_here);
        apply_law(cells, common[first / batch_size], time_step, batch)
          .write(forces + first, n_here);
        batch.write_memory(pairs + first, n_here);
      }
  }
} // namespace rift
