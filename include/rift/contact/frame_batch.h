#ifndef rift_contact_frame_batch_h
#define rift_contact_frame_batch_h

#include <rift/contact/packed_motion.h>

namespace rift
{
  /** The corners of eight tetrahedra, m. */
  using TetrahedronBatch = std::array<Vector3<Simd>, 4>;

  /** Rows of the same number in eight cells: 0 to 3 are the positions of their
   * corners, 4 to 7 the velocities of these. */
  inline Vector3<Simd>
  gather_row(const PackedMotion  *cells,
             const std::uint32_t *numbers,
             const unsigned int   row)
  {
    std::array<std::uint32_t, batch_size> rows;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      rows[lane] = 8 * numbers[lane] + row;
    return gather(cells->position, rows.data());
  }

  /** The corners of eight cells. */
  inline TetrahedronBatch
  gather_corners(const PackedMotion *cells, const std::uint32_t *numbers)
  {
    return {{gather_row(cells, numbers, 0),
             gather_row(cells, numbers, 1),
             gather_row(cells, numbers, 2),
             gather_row(cells, numbers, 3)}};
  }

  /** The barycentric coordinates of eight points, each in its tetrahedron. */
  using CoordinateBatch = std::array<Simd, 4>;

  /** Barycentric coordinates in each of eight tetrahedra. */
  struct FrameBatch
  {
    /** Of tetrahedra of positive volume. */
    explicit FrameBatch(const TetrahedronBatch &t)
      : origin(t[0])
    {
      const Vector3<Simd> e1 = t[1] - t[0], e2 = t[2] - t[0], e3 = t[3] - t[0];
      const Vector3<Simd> n1 = cross(e2, e3), n2 = cross(e3, e1),
                          n3 = cross(e1, e2);
      const Simd d           = dot(e1, n1);
      volume                 = d / 6;
      const Simd inverse     = 1 / d;
      gradients              = {
                     {-inverse * (n1 + n2 + n3), inverse * n1, inverse * n2, inverse * n3}};
    }

    /** Coordinates of the corners of other tetrahedra, corner by corner. */
    std::array<CoordinateBatch, 4>
    coordinates(const TetrahedronBatch &others) const
    {
      std::array<CoordinateBatch, 4> result;
      for (unsigned int c = 0; c < 4; ++c)
        {
          const Vector3<Simd> x = others[c] - origin;
          for (unsigned int k = 0; k < 4; ++k)
            {
              // From 0 on, so that no zero is negative.
              Simd sum = broadcast(k == 0 ? 1 : 0);
              for (unsigned int d = 0; d < 3; ++d)
                sum += x[d] * gradients[k][d];
              result[c][k] = sum;
            }
        }
      return result;
    }

    /** m. */
    Vector3<Simd> origin;

    /** Of the four coordinates, 1/m. */
    std::array<Vector3<Simd>, 4> gradients;

    /** m^3. */
    Simd volume;
  };
} // namespace rift

#endif
