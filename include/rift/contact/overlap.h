#ifndef rift_contact_overlap_h
#define rift_contact_overlap_h

#include <rift/base/simd.h>
#include <rift/base/vector3.h>

namespace rift
{
  /** The corners of a tetrahedron of positive volume, m. */
  using Tetrahedron = std::array<Vector3<double>, 4>;

  /** What two tetrahedra A and B have in common. */
  struct Overlap
  {
    /**
     * Munjiza's potentials integrated over the overlap, m^3:
     * sum over A and B of the least of the four barycentric coordinates, which
     * is zero on the surface of a tetrahedron and 1/4 at its centroid
     * (doc/theory.md, eq. 24). Times the penalty it is the contact energy.
     */
    double potential = 0;

    /** Derivatives of the potential by the corners of A and of B, m^2. They
     * are what pulls them together; as a whole they have neither force nor
     * torque. */
    std::array<Vector3<double>, 4> gradient_a{}, gradient_b{};

    /** m^3, and over the volume of the smaller one of the two. */
    double volume = 0, volume_fraction = 0;

    /** The centroid of the overlap as means of the corners of A and of B with
     * these weights. */
    std::array<double, 4> weights_a{}, weights_b{};
  };

  /** Intersects two tetrahedra, exactly but for rounding. All is zero if they
   * have no volume in common. */
  Overlap
  overlap(const Tetrahedron &a, const Tetrahedron &b);

  /** A tetrahedron by the planes of its faces. */
  class FacePlanes
  {
  public:
    /** The planes of a tetrahedron of positive volume. */
    explicit FacePlanes(const Tetrahedron &t);

    /** From the face from which another tetrahedron is farthest, m: they have
     * at least this distance. Not positive if no face parts them. */
    double
    distance_to(const Tetrahedron &other) const;

  private:
    Vector3<double> origin;

    /** Outward, component by component, and the distances of the origin. */
    std::array<Row, 3> normals;
    Row                distances;
  };
} // namespace rift

#endif
