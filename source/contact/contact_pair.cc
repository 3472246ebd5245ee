#include <rift/base/check.h>
#include <rift/contact/contact_pair.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    Vector3<double>
    weighted(const std::array<double, 4>          &weights,
             const std::array<Vector3<double>, 4> &vectors)
    {
      Vector3<double> sum{};
      for (unsigned int c = 0; c < 4; ++c)
        sum += weights[c] * vectors[c];
      return sum;
    }

    /** Whether the weights of a point among the corners sum to 1, but for
     * rounding. */
    bool
    sum_to_one(const std::array<double, 4> &weights)
    {
      return !(std::abs(weights[0] + weights[1] + weights[2] + weights[3] - 1) >
               1e-9);
    }

    /**
     * Whether the forces on both cells cancel. Their rounding is that of the
     * coordinates, so that it grows as the overlap becomes shallow. What is not
     * a number passes.
     */
    bool
    cancel(const ContactForces &forces, const double volume_fraction)
    {
      Vector3<double> sum{};
      double          scale = 0;
      for (unsigned int c = 0; c < 4; ++c)
        {
          sum += forces.on_a[c] + forces.on_b[c];
          scale += norm(forces.on_a[c]) + norm(forces.on_b[c]);
        }
      return !(norm(sum) * volume_fraction > 1e-14 * scale);
    }

    /** The part of a vector across a normal. */
    Vector3<double>
    across(const Vector3<double> &vector, const Vector3<double> &normal)
    {
      return vector - dot(vector, normal) * normal;
    }

    /** Turns the slip into the plane of the contact as it is now. */
    Vector3<double>
    turned(const Vector3<double> &slip, const Vector3<double> &normal)
    {
      const Vector3<double> in_plane = across(slip, normal);
      const double          length   = norm(in_plane);
      return length > 0 ? (norm(slip) / length) * in_plane : in_plane;
    }

    double
    spring_energy(const ContactMemory &memory)
    {
      return .5 * memory.stiffness * dot(memory.slip, memory.slip);
    }

    /**
     * Moves the spring of friction.
     *
     * @param normal_force N.
     * @param shift of A against B in the plane since the step before, m.
     * @return energy that has been used up, J: by the trapezoidal rule, as the
     *   central differences count the work of the spring.
     */
    double
    slide(const Vector3<double> &normal,
          const double           normal_force,
          const double           stiffness,
          const double           friction,
          const Vector3<double> &shift,
          ContactMemory         &memory)
    {
      memory.slip                     = turned(memory.slip, normal);
      const Vector3<double> old_force = memory.stiffness * memory.slip;
      const double          before    = spring_energy(memory);
      // A spring that becomes stiffer keeps its force, one that becomes softer its
      // elongation: neither makes energy.
      if (stiffness > memory.stiffness)
        memory.slip = (memory.stiffness / stiffness) * memory.slip;
      memory.stiffness = stiffness;
      memory.slip += shift;
      const double length  = norm(memory.slip);
      const double longest = friction * normal_force / memory.stiffness;
      if (length > longest)
        memory.slip = (longest / length) * memory.slip;
      const Vector3<double> force = memory.stiffness * memory.slip;
      rift_check(!(norm(force) > (1 + 1e-12) * friction * normal_force));
      return .5 * dot(old_force + force, shift) -
             (spring_energy(memory) - before);
    }

    /**
     * Sets the elastic forces, energy and depth (eq. 26).
     *
     * @return derivative of the energy by the potential, Pa.
     */
    double
    press(const Overlap          &common,
          const ContactConstants &constants,
          ContactMemory          &memory,
          ContactForces          &result)
    {
      memory.initial_potential =
        std::min(memory.initial_potential, common.potential);
      const double initial = memory.initial_potential;
      const double root    = std::sqrt(common.potential);
      const double excess  = root - std::sqrt(initial);
      const double slope   = constants.penalty * excess / root;
      rift_check(!(common.potential < 0 || initial < 0 || slope < 0));
      result.touches = true;
      result.energy  = constants.penalty * excess * excess;
      result.is_too_deep =
        initial == 0 &&
        (common.potential > largest_mean_potential * common.volume ||
         common.volume_fraction > largest_volume_fraction);
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
    double
    damp(const ContactConstants &constants,
         const double            stiffness,
         const double            elastic,
         const double            speed,
         const double            time_step,
         ContactMemory          &memory,
         ContactForces          &result)
    {
      const double force = std::max(
        -2 * constants.damping * std::sqrt(stiffness * constants.mass) * speed,
        -elastic);
      result.damping_loss =
        -.5 * (memory.damping_force + force) * speed * time_step;
      memory.damping_force = force;
      return force;
    }
  } // namespace

  ContactForces
  pair_forces(const CellMotion       &a,
              const CellMotion       &b,
              const ContactConstants &constants,
              const double            time_step,
              ContactMemory          &memory)
  {
    ContactForces result;
    const Overlap common = overlap(a.positions, b.positions);
    if (common.volume == 0)
      {
        result.friction_loss = spring_energy(memory);
        memory               = ContactMemory();
        return result;
      }

    rift_check(sum_to_one(common.weights_a) && sum_to_one(common.weights_b));
    const double    slope = press(common, constants, memory, result);
    Vector3<double> force{};
    for (const Vector3<double> &f : result.on_a)
      force += f;
    const double elastic = norm(force);
    if (elastic == 0)
      {
        result.friction_loss = spring_energy(memory);
        memory.slip          = {};
        memory.damping_force = 0;
        return result;
      }
    const Vector3<double> normal   = (1 / elastic) * force;
    const Vector3<double> velocity = weighted(common.weights_a, a.velocities) -
                                     weighted(common.weights_b, b.velocities);
    // Of faces that lie flat upon each other the potential is half of the
    // stiffness times the square of the depth, over the penalty.
    const double stiffness = elastic * elastic / (2 * slope * common.potential);

    const double    damping_force = damp(constants,
                                      stiffness,
                                      elastic,
                                      dot(velocity, normal),
                                      time_step,
                                      memory,
                                      result);
    Vector3<double> added         = damping_force * normal;
    if (constants.friction > 0)
      {
        result.friction_loss = slide(normal,
                                     elastic + damping_force,
                                     friction_stiffness_ratio * stiffness,
                                     constants.friction,
                                     time_step * across(velocity, normal),
                                     memory);
        result.energy += spring_energy(memory);
        added -= memory.stiffness * memory.slip;
      }
    for (unsigned int c = 0; c < 4; ++c)
      {
        result.on_a[c] += common.weights_a[c] * added;
        result.on_b[c] -= common.weights_b[c] * added;
      }
    rift_check(cancel(result, common.volume_fraction));
    return result;
  }
} // namespace rift
