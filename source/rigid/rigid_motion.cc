#include <rift/rigid/rigid_motion.h>

namespace rift
{
  namespace
  {
    Quaternion
    inverse(const Quaternion &q)
    {
      return {q.real, -1. * q.imaginary};
    }

    Quaternion
    normalized(const Quaternion &q)
    {
      const double factor =
        1 / std::sqrt(q.real * q.real + dot(q.imaginary, q.imaginary));
      return {factor * q.real, factor * q.imaginary};
    }
  } // namespace

  Quaternion
  operator*(const Quaternion &a, const Quaternion &b)
  {
    return {a.real * b.real - dot(a.imaginary, b.imaginary),
            a.real * b.imaginary + b.real * a.imaginary +
              cross(a.imaginary, b.imaginary)};
  }

  Vector3<double>
  change_by(const Quaternion &q, const Vector3<double> &vector)
  {
    const Vector3<double> twice = 2. * cross(q.imaginary, vector);
    return q.real * twice + cross(q.imaginary, twice);
  }

  Vector3<double>
  angular_velocity(const RigidMotion &motion, const RigidMass &mass)
  {
    const Vector3<double> in_body =
      turned(inverse(motion.rotation), motion.angular_momentum);
    return turned(motion.rotation, mass.inverse_inertia * in_body);
  }

  bool
  drift(RigidMotion &motion, const RigidMass &mass, const double time_step)
  {
    motion.displacement += time_step * motion.velocity;
    const Vector3<double> &l = motion.angular_momentum;
    if (dot(l, l) == 0)
      return true;

    // Eq. 28 in the axes of the body. Each iteration gains as many digits as
    // the angle of the step is small.
    constexpr unsigned int largest_number_of_iterations = 100;
    constexpr double       largest_sine                 = .5;
    const Vector3<double>  half_momentum =
      (.5 * time_step) * turned(inverse(motion.rotation), l);
    Quaternion step;
    for (unsigned int i = 0; i < largest_number_of_iterations; ++i)
      {
        const Vector3<double> &q = step.imaginary;
        const Vector3<double>  next =
          (1 / step.real) *
          (mass.inverse_inertia * (half_momentum - cross(q, mass.inertia * q)));
        const double sine_squared = dot(next, next);
        if (!(sine_squared < largest_sine * largest_sine))
          return false;
        const Vector3<double> change = next - q;
        step                         = {std::sqrt(1 - sine_squared), next};
        if (dot(change, change) <= 1e-30 * sine_squared)
          {
            motion.rotation = normalized(motion.rotation * step);
            return true;
          }
      }
    return false;
  }
} // namespace rift
