#ifndef rift_contact_separation_h
#define rift_contact_separation_h

#include <rift/contact/packed_motion.h>

#include <cstddef>

namespace rift
{
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

  /** What of `find_gaps()` stands for no axis. */
  constexpr std::uint8_t no_axis = 255;

  /**
   * Lower bounds of the distances of pairs of tetrahedra of positive volume, m:
   * along the normal of one of their eight faces, or, only where none of these
   * parts the two, of two of their edges, of which a margin against rounding is
   * taken off, 1e-8 of the extent of the pair. Where nothing parts them the
   * bound is not positive.
   *
   * A pair has the same bits in any company, but they depend on the axis that
   * it remembers.
   *
   * @param[in,out] axes the axis of each pair that parted it last: 0 to 3 are
   *   the faces of A, 4 to 7 those of B, 8 to 43 an edge of A and one of B;
   *   `no_axis` if none did. An edge pair is kept as long as it parts the two.
   */
  void
  find_gaps(const PackedMotion *cells,
            const CellPair     *pairs,
            std::size_t         n,
            std::uint8_t       *axes,
            double             *gaps);
} // namespace rift

#endif
