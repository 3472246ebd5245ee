#ifndef rift_contact_simplex_clipper_h
#define rift_contact_simplex_clipper_h

#include <rift/base/simd.h>

#include <array>
#include <memory>

namespace rift
{
  /** Number of coordinates of a point that is clipped. */
  constexpr unsigned int n_point_coordinates = 5;

  /** Eight points: the coordinates 0 to 3 by which they are clipped, and one
   * more. They depend on each other linearly, so that points between points
   * need nothing else. */
  using PointBatch = std::array<Simd, n_point_coordinates>;

  /** Eight simplices, each a part of a body. */
  struct SimplexBatch
  {
    /** In any order. */
    std::array<PointBatch, 4> corners;

    /** m^3. */
    Simd volume;

    /** The numbers of their bodies. */
    SimdMask body;
  };

  /** What of a body has no negative coordinates: eight numbers, to be read at
   * once. */
  struct alignas(64) BodyPart
  {
    /** m^3, and the integrals of the coordinates over it. */
    double volume, moment[n_point_coordinates];

    /** Zeros. */
    double unused[2];
  };

  /**
   * Clips many simplices by the four planes where a coordinate is zero.
   *
   * A plane cuts a simplex into at most three simplices on the inner side,
   * whose volumes are products of positive numbers: nothing cancels, and the
   * result depends continuously on the corners through all types of
   * intersection. Of these inner simplices, which the other planes cut in turn,
   * none is made: volume and centroid follow from weights of the corners, which
   * are sums of such products. Bodies wait for others that are cut by as many
   * planes and then go their way eight at a time; each has the same bits in any
   * company.
   */
  class SimplexClipper
  {
  public:
    /** Largest number of bodies. */
    static constexpr unsigned int capacity = 512;

    SimplexClipper();
    ~SimplexClipper();

    /** Starts with bodies without any part. */
    void
    start(unsigned int n_bodies);

    /** Adds bodies, each a simplex.
     * @param lanes bits of those to be added. */
    void
    add(const SimplexBatch &simplices, unsigned int lanes);

    /** Clips all that has been added. */
    void
    clip();

    /** By number; to be read after clip(). */
    const BodyPart *
    parts() const;

  private:
    struct Workspace;

    std::unique_ptr<Workspace> workspace;
  };
} // namespace rift

#endif
