#ifndef rift_rigid_rigid_motion_h
#define rift_rigid_rigid_motion_h

#include <rift/base/vector3.h>

namespace rift
{
  /** A rotation: cosine of half of the angle, and the axis times the sine. */
  struct Quaternion
  {
    /** The cosine, and the axis times the sine. */
    double          real = 1;
    Vector3<double> imaginary{};
  };

  /** First `b`, then `a`. */
  Quaternion
  operator*(const Quaternion &a, const Quaternion &b);

  /** How much a vector changes when it is turned. */
  Vector3<double>
  change_by(const Quaternion &rotation, const Vector3<double> &vector);

  /** A vector rotated by a quaternion. */
  inline Vector3<double>
  turned(const Quaternion &rotation, const Vector3<double> &vector)
  {
    return vector + change_by(rotation, vector);
  }

  /** What a rigid body weighs, in the undeformed body. */
  struct RigidMass
  {
    /** kg */
    double mass = 0;

    /** Centre of mass, m. */
    Vector3<double> centre{};

    /** About the centre, kg m^2, and its inverse. */
    Matrix3<double> inertia{}, inverse_inertia{};
  };

  /** Where a rigid body is at t_n, and how it moves at t_n - dt/2. */
  struct RigidMotion
  {
    /** Of the centre of mass, m. */
    Vector3<double> displacement{};

    /** About the centre of mass, from the undeformed body. */
    Quaternion rotation;

    /** Of the centre of mass, m/s. */
    Vector3<double> velocity{};

    /** About the centre of mass, in the frame of the mesh, kg m^2/s. */
    Vector3<double> angular_momentum{};
  };

  /** Displacement of a point of the body that is at `from_centre` of the centre
   * of the undeformed body, m. */
  inline Vector3<double>
  displacement_of(const RigidMotion &motion, const Vector3<double> &from_centre)
  {
    return motion.displacement + change_by(motion.rotation, from_centre);
  }

  /** Angular velocity that belongs to the angular momentum, 1/s. */
  Vector3<double>
  angular_velocity(const RigidMotion &motion, const RigidMass &mass);

  /**
   * Goes from t_n to t_(n+1): central differences under the condition that no
   * distances change (doc/theory.md, eq. 28), which keep the angular momentum.
   *
   * @return whether the body turns little enough in a step, by some 60 degrees
   *   at most; false, too, if something is not a number.
   */
  bool
  drift(RigidMotion &motion, const RigidMass &mass, double time_step);
} // namespace rift

#endif
