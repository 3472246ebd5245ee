#include <rift/contact/frame_batch.h>
#include <rift/contact/separation.h>

#include <algorithm>
#include <limits>

namespace rift
{
  namespace
  {
    constexpr double lowest = -std::numeric_limits<double>::max();

    /** Rounding of distances along edge axes, over the extent of the pair. */
    constexpr double edge_margin = 1e-8;

    constexpr unsigned int n_edges = 6;

    constexpr unsigned int edges[n_edges][2] =
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

    /** The first of the axes that are pairs of edges. */
    constexpr std::uint8_t first_edge_axis = 8;

    /** The largest distances of eight pairs, and their axes. */
    struct Parting
    {
      /** The axis becomes this one where it is better. */
      void
      offer(const Simd &distance, const std::int64_t number)
      {
        const SimdMask is_better = distance > gap;
        gap                      = select(is_better, distance, gap);
        axis                     = is_better ? SimdMask{} + number : axis;
      }

      Simd     gap  = broadcast(lowest);
      SimdMask axis = SimdMask{} + no_axis;
    };

    /** Offers the distances from the four faces of tetrahedra. */
    void
    try_faces(const FrameBatch                     &frame,
              const std::array<CoordinateBatch, 4> &others,
              const unsigned int                    first_number,
              Parting                              &parting)
    {
      for (unsigned int k = 0; k < 4; ++k)
        {
          const Simd highest = max(max(others[0][k], others[1][k]),
                                   max(others[2][k], others[3][k]));
          const Simd height =
            1 / sqrt(dot(frame.gradients[k], frame.gradients[k]));
          parting.offer(-highest * height, first_number + k);
        }
    }

    /** The distance of two cells along the normal of two of their edges, m;
     * `lowest` if these are parallel. */
    double
    distance_along(const PackedMotion &a,
                   const PackedMotion &b,
                   const unsigned int  edge_a,
                   const unsigned int  edge_b)
    {
      const auto side = [](const PackedMotion &cell, const unsigned int edge) {
        return cell.position[edges[edge][1]].vector() -
               cell.position[edges[edge][0]].vector();
      };
      const Vector3<double> axis   = cross(side(a, edge_a), side(b, edge_b));
      const double          length = norm(axis);
      const Vector3<double> origin = a.position[0].vector();
      double                least[2], largest[2], extent = 0;
      for (unsigned int k = 0; k < 2; ++k)
        for (unsigned int c = 0; c < 4; ++c)
          {
            const Vector3<double> x =
              (k == 0 ? a : b).position[c].vector() - origin;
            const double place = dot(axis, x);
            least[k]           = c == 0 ? place : std::min(least[k], place);
            largest[k]         = c == 0 ? place : std::max(largest[k], place);
            extent             = std::max(extent, dot(x, x));
          }
      if (!(length > 0))
        return lowest;
      return std::max(least[1] - largest[0], least[0] - largest[1]) / length -
             edge_margin * std::sqrt(extent);
    }

    /** Looks for two edges that part a pair: those of before, or the best. */
    void
    search_edges(const PackedMotion &a,
                 const PackedMotion &b,
                 std::uint8_t       &axis,
                 double             &gap)
    {
      const auto distance = [&](const unsigned int number) {
        return distance_along(a, b, number / n_edges, number % n_edges);
      };
      if (axis >= first_edge_axis && axis != no_axis)
        if (const double here = distance(axis - first_edge_axis); here > 0)
          {
            gap = here;
            return;
          }
      axis = no_axis;
      for (unsigned int number = 0; number < n_edges * n_edges; ++number)
        if (const double here = distance(number); here > gap)
          {
            gap  = here;
            axis = static_cast<std::uint8_t>(first_edge_axis + number);
          }
      if (!(gap > 0))
        axis = no_axis;
    }
  } // namespace

  FacePlanes::FacePlanes(const Tetrahedron &t)
    : origin(t[0])
  {
    const Vector3<double> e1 = t[1] - t[0], e2 = t[2] - t[0], e3 = t[3] - t[0];
    const Vector3<double> n1 = cross(e2, e3), n2 = cross(e3, e1),
                          n3          = cross(e1, e2);
    const Vector3<double> inward[4]   = {-1. * (n1 + n2 + n3), n1, n2, n3};
    const double          determinant = dot(e1, n1);
    for (unsigned int i = 0; i < 4; ++i)
      {
        const double scale = -1 / norm(inward[i]);
        // The origin is a corner of three faces.
        distances[i] = i == 0 ? scale * determinant : 0;
        for (unsigned int d = 0; d < 3; ++d)
          normals[d][i] = scale * inward[i][d];
      }
  }

  double
  FacePlanes::distance_to(const Tetrahedron &other) const
  {
    Row nearest = Row{} + std::numeric_limits<double>::max();
    for (const Vector3<double> &x : other)
      {
        Row distance = distances;
        for (unsigned int d = 0; d < 3; ++d)
          distance += (x[d] - origin[d]) * normals[d];
        nearest = nearest < distance ? nearest : distance;
      }
    return std::max({nearest[0], nearest[1], nearest[2], nearest[3]});
  }

  void
  find_gaps(const PackedMotion *cells,
            const CellPair     *pairs,
            const std::size_t   n,
            std::uint8_t       *axes,
            double             *gaps)
  {
    for (std::size_t first = 0; first < n; first += batch_size)
      {
        std::array<std::uint32_t, batch_size> a, b;
        for (unsigned int lane = 0; lane < batch_size; ++lane)
          {
            // Lanes without a pair do as the last one.
            const CellPair &pair = pairs[std::min(first + lane, n - 1)];
            a[lane]              = pair.a;
            b[lane]              = pair.b;
          }
        const TetrahedronBatch corners_a = gather_corners(cells, a.data()),
                               corners_b = gather_corners(cells, b.data());
        const FrameBatch frame_a(corners_a), frame_b(corners_b);
        Parting          parting;
        try_faces(frame_a, frame_a.coordinates(corners_b), 0, parting);
        try_faces(frame_b, frame_b.coordinates(corners_a), 4, parting);
        for (unsigned int lane = 0; lane < batch_size && first + lane < n;
             ++lane)
          {
            const std::size_t i = first + lane;
            gaps[i]             = parting.gap[lane];
            if (gaps[i] > 0)
              axes[i] = static_cast<std::uint8_t>(parting.axis[lane]);
            else
              search_edges(cells[a[lane]], cells[b[lane]], axes[i], gaps[i]);
          }
      }
  }
} // namespace rift
