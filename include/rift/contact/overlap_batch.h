#ifndef rift_contact_overlap_batch_h
#define rift_contact_overlap_batch_h

#include <rift/contact/frame_batch.h>
#include <rift/contact/simplex_clipper.h>

#include <vector>

namespace rift
{
  /** What each of eight pairs of tetrahedra A and B have in common; all is zero
   * where they have no volume in common. */
  struct OverlapOctet
  {
    /**
     * Munjiza's potentials integrated over the overlap, m^3:
     * sum over A and B of the least of the four barycentric coordinates, which
     * is zero on the surface of a tetrahedron and 1/4 at its centroid
     * (doc/theory.md, eq. 24). Times the penalty it is the contact energy.
     */
    Simd potential;

    /** Derivatives of the potential by the corners of A and of B, m^2. They
     * are what pulls them together; as a whole they have neither force nor
     * torque. */
    std::array<Vector3<Simd>, 4> gradient_a, gradient_b;

    /** m^3, and over the volume of the smaller one of the two. */
    Simd volume, volume_fraction;

    /** The centroid of the overlap as means of the corners of A and of B with
     * these weights. */
    std::array<Simd, 4> weights_a, weights_b;
  };

  /** Intersects pairs of tetrahedra, exactly but for rounding. A pair has the
   * same bits in any company. */
  class OverlapBatch
  {
  public:
    /** Largest number of pairs that are intersected together. */
    static constexpr unsigned int chunk_size = 64;

    /**
     * @param n of pairs, at most `chunk_size`.
     * @return pair i is lane i % 8 of element i / 8; there until the next call.
     *   Lanes without a pair are zero.
     */
    const OverlapOctet *
    intersect(const PackedMotion *cells, const CellPair *pairs, unsigned int n);

  private:
    static constexpr unsigned int n_octets = chunk_size / batch_size;

    /** What the sums of the parts need of eight pairs. */
    struct Octet
    {
      std::array<Vector3<Simd>, 4>   gradients[2];
      std::array<CoordinateBatch, 4> corners_in_other[2];
      Simd                           smaller_volume;
    };

    void
    prepare(const PackedMotion *cells,
            const CellPair     *pairs,
            unsigned int        n,
            unsigned int        octet);

    void
    sum(unsigned int octet);

    SimplexClipper clipper;
    Octet          octets[n_octets];
    OverlapOctet   results[n_octets];
  };

  /** Of a pair of tetrahedra: see OverlapOctet. */
  struct CommonPart
  {
    /** m^3; m^3; over the volume of the smaller one. */
    double potential, volume, volume_fraction;
  };

  /** What any number of pairs have in common. */
  std::vector<CommonPart>
  common_parts(const PackedMotion *cells, const std::vector<CellPair> &pairs);
} // namespace rift

#endif
