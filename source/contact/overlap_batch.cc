#include <rift/base/check.h>
#include <rift/contact/overlap_batch.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** Overlaps of this share of the smaller tetrahedron, at a corner a depth
     * of 1e-10 of its height, are nothing but rounding. */
    constexpr double negligible_share = 1e-30;

    /** The bodies of an octet: four of A, then four of B, lane by lane. */
    constexpr unsigned int bodies_of_octet = 8 * batch_size;

    static_assert(OverlapBatch::chunk_size / batch_size * bodies_of_octet <=
                  SimplexClipper::capacity);

    /** Bits of lanes where no face of the other has all corners on its outer
     * side. What is not a number is outside. */
    unsigned int
    may_overlap(const std::array<CoordinateBatch, 4> &c)
    {
      SimdMask result = ~SimdMask{};
      for (unsigned int k = 0; k < 4; ++k)
        result &= (c[0][k] > 0) | (c[1][k] > 0) | (c[2][k] > 0) | (c[3][k] > 0);
      return sign_bits(result);
    }

    /** Zero in lanes where a mask is false. */
    Simd
    only(const SimdMask &mask, const Simd &value)
    {
      return select(mask, value, Simd{});
    }
  } // namespace

  /**
   * Adds the bodies. A tetrahedron consists of four simplices between the
   * centroid and a face each, in which the coordinate of the corner opposite to
   * the face is the least: that is the fifth coordinate of their points.
   */
  void
  OverlapBatch::prepare(const PackedMotion *cells,
                        const CellPair     *pairs,
                        const unsigned int  n,
                        const unsigned int  octet)
  {
    std::array<std::uint32_t, batch_size> numbers[2];
    const unsigned int                    first = octet * batch_size;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      {
        // Lanes without a pair do as the last one.
        const CellPair &pair = pairs[std::min(first + lane, n - 1)];
        numbers[0][lane]     = pair.a;
        numbers[1][lane]     = pair.b;
      }
    const TetrahedronBatch a = gather_corners(cells, numbers[0].data()),
                           b = gather_corners(cells, numbers[1].data());
    const FrameBatch frame_a(a), frame_b(b);
    Octet           &data    = octets[octet];
    data.gradients[0]        = frame_a.gradients;
    data.gradients[1]        = frame_b.gradients;
    data.corners_in_other[0] = frame_b.coordinates(a);
    data.corners_in_other[1] = frame_a.coordinates(b);
    data.smaller_volume      = min(frame_a.volume, frame_b.volume);
    const unsigned int valid =
      n - first < batch_size ? (1 << (n - first)) - 1 : (1 << batch_size) - 1;
    const unsigned int lanes = valid & may_overlap(data.corners_in_other[0]) &
                               may_overlap(data.corners_in_other[1]);
    if (lanes == 0)
      return;
    for (unsigned int side = 0; side < 2; ++side)
      {
        const auto  &corners = data.corners_in_other[side];
        SimplexBatch simplex;
        simplex.volume = (side == 0 ? frame_a : frame_b).volume / 4;
        PointBatch points[4], centroid;
        for (unsigned int k = 0; k < 4; ++k)
          {
            for (unsigned int c = 0; c < 4; ++c)
              points[c][k] = corners[c][k];
            centroid[k] = ((corners[0][k] + corners[1][k]) +
                           (corners[2][k] + corners[3][k])) /
                            4 +
                          0.;
          }
        for (unsigned int c = 0; c < 4; ++c)
          points[c][4] = Simd{};
        centroid[4] = broadcast(.25);
        for (unsigned int i = 0; i < 4; ++i)
          {
            for (unsigned int c = 0; c < 4; ++c)
              simplex.corners[c] = c == i ? centroid : points[c];
            simplex.body =
              SimdMask{0, 1, 2, 3, 4, 5, 6, 7} +
              (octet * bodies_of_octet + (4 * side + i) * batch_size);
            clipper.add(simplex, lanes);
          }
      }
  }

  /**
   * Sums up the parts. Where the boundary of the overlap moves, the potential
   * of A is zero (on the surface of A), or its change is the flux through that
   * of B, which by the theorem of Gauss is again an integral over the volume
   * (doc/theory.md, eq. 25). So volumes and centroids of the parts are all that
   * is needed.
   */
  void
  OverlapBatch::sum(const unsigned int octet)
  {
    const Octet &data      = octets[octet];
    OverlapOctet result    = {};
    Simd         volume[2] = {}, moment[2][4] = {};
    for (unsigned int side = 0; side < 2; ++side)
      {
        auto &by_own      = side == 0 ? result.gradient_a : result.gradient_b;
        auto &by_other    = side == 0 ? result.gradient_b : result.gradient_a;
        const auto &own   = data.gradients[side],
                   &other = data.gradients[1 - side];
        // The sum over the parts of the gradient of the own coordinate times
        // the moments of those in the other.
        Vector3<Simd> products[4] = {};
        Simd          potential{};
        for (unsigned int i = 0; i < 4; ++i)
          {
            const BodyPart *parts = clipper.parts() + octet * bodies_of_octet +
                                    (4 * side + i) * batch_size;
            std::array<Simd, 8> rows;
            for (unsigned int lane = 0; lane < batch_size; ++lane)
              rows[lane] = load(&parts[lane].volume);
            const std::array<Simd, 8> columns = transpose(rows);
            volume[side] += columns[0];
            potential += columns[5];
            for (unsigned int k = 0; k < 4; ++k)
              {
                moment[side][k] += columns[1 + k];
                products[k] += columns[1 + k] * own[i];
              }
          }
        result.potential += potential;
        const auto &in_own = data.corners_in_other[1 - side];
        for (unsigned int c = 0; c < 4; ++c)
          {
            by_other[c] += products[c] + potential * other[c];
            for (unsigned int k = 0; k < 4; ++k)
              by_own[c] -= in_own[k][c] * products[k];
          }
      }
    const Simd     fraction = volume[0] / data.smaller_volume;
    const SimdMask overlaps =
      volume[0] > negligible_share * data.smaller_volume;
    const Simd inverse     = 1 / volume[0];
    result.potential       = only(overlaps, result.potential);
    result.volume          = only(overlaps, volume[0]);
    result.volume_fraction = only(overlaps, fraction);
    for (unsigned int c = 0; c < 4; ++c)
      {
        for (unsigned int d = 0; d < 3; ++d)
          {
            result.gradient_a[c][d] = only(overlaps, result.gradient_a[c][d]);
            result.gradient_b[c][d] = only(overlaps, result.gradient_b[c][d]);
          }
        Simd in_a{};
        for (unsigned int k = 0; k < 4; ++k)
          in_a += moment[0][k] * data.corners_in_other[1][k][c];
        result.weights_a[c] = only(overlaps, in_a * inverse);
        result.weights_b[c] = only(overlaps, moment[0][c] * inverse);
      }
    results[octet] = result;
  }

  const OverlapOctet *
  OverlapBatch::intersect(const PackedMotion *cells,
                          const CellPair     *pairs,
                          const unsigned int  n)
  {
    rift_check(n <= chunk_size);
    const unsigned int n_filled = (n + batch_size - 1) / batch_size;
    clipper.start(n_filled * bodies_of_octet);
    for (unsigned int octet = 0; octet < n_filled; ++octet)
      prepare(cells, pairs, n, octet);
    clipper.clip();
    for (unsigned int octet = 0; octet < n_filled; ++octet)
      sum(octet);
    return results;
  }

  std::vector<CommonPart>
  common_parts(const PackedMotion *cells, const std::vector<CellPair> &pairs)
  {
    std::vector<CommonPart> result(pairs.size());
    OverlapBatch            batch;
    for (std::size_t first = 0; first < pairs.size();
         first += OverlapBatch::chunk_size)
      {
        const auto n = static_cast<unsigned int>(
          std::min<std::size_t>(OverlapBatch::chunk_size,
                                pairs.size() - first));
        const OverlapOctet *overlaps = batch.intersect(cells, &pairs[first], n);
        for (unsigned int i = 0; i < n; ++i)
          {
            const OverlapOctet &octet = overlaps[i / batch_size];
            const unsigned int  lane  = i % batch_size;
            result[first + i]         = {octet.potential[lane],
                                         octet.volume[lane],
                                         octet.volume_fraction[lane]};
          }
      }
    return result;
  }
} // namespace rift
