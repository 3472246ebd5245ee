#include <rift/base/check.h>
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

    /** What is not a number passes. */
    bool
    is_of_unit_length(const Quaternion &q)
    {
      return !(std::abs(q.real * q.real + dot(q.imaginary, q.imaginary) - 1) >
               1e-12);
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
    rift_check(is_of_unit_length(motion.rotation));
    motion.displacement += time_step * motion.velocity;
    const Vector3<double> &l = motion.angular_momentum;
    if (dot(l, l) == 0)
      return true;

    // Newton's method for eq. 28 in the axes of the body: q0 J q + q x J q = h.
    constexpr unsigned int largest_number_of_iterations = 30;
    constexpr double       largest_sine                 = .5;
    const Vector3<double>  h =
      (.5 * time_step) * turned(inverse(motion.rotation), l);
    const Matrix3<double> &j = mass.inertia;
    Vector3<double>        q = mass.inverse_inertia * h;
    for (unsigned int i = 0; i < largest_number_of_iterations; ++i)
      {
        const double square = dot(q, q);
        if (!(square < largest_sine * largest_sine))
          return false;
        const double          real  = std::sqrt(1 - square);
        const Vector3<double> jq    = j * q;
        const Vector3<double> error = real * jq + cross(q, jq) - h;
        Matrix3<double>       slope;
        for (unsigned int d = 0; d < 3; ++d)
          {
            Vector3<double> unit{};
            unit[d]                      = 1;
            const Vector3<double> column = (-q[d] / real) * jq +
                                           real * (j * unit) + cross(unit, jq) +
                                           cross(q, j * unit);
            for (unsigned int e = 0; e < 3; ++e)
              slope[e][d] = column[e];
          }
        const Vector3<double> change = inverse(slope) * error;
        q -= change;
        // The next change would be below the last digit.
        if (dot(change, change) <= 1e-20 * dot(q, q))
          {
            motion.rotation = normalized(
              motion.rotation * Quaternion{std::sqrt(1 - dot(q, q)), q});
            return true;
          }
      }
    return false;
  }
} // namespace rift
