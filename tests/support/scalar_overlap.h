#ifndef rift_tests_support_scalar_overlap_h
#define rift_tests_support_scalar_overlap_h

#include <rift/base/simd.h>
#include <rift/contact/cell_motion.h>

#include <algorithm>
#include <limits>

// The overlap of two tetrahedra one pair at a time, by recursion: the oracle of
// OverlapBatch.
namespace rift::test
{
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

  namespace scalar
  {
    /** Overlaps of this share of the smaller tetrahedron, at a corner a depth
     * of 1e-10 of its height, are nothing but rounding. */
    constexpr double negligible_share = 1e-30;

    /** Barycentric coordinates in one tetrahedron. */
    using Coordinates = Row;
    using Mask        = std::int64_t __attribute__((vector_size(32)));

    /** A point by its coordinates in A and in B, which depend on each other
     * linearly: points between points need nothing else. */
    struct Point
    {
      Coordinates in_a, in_b;
    };

    /** The coordinates of the corners of one tetrahedron in the other. */
    using Corners = std::array<Coordinates, 4>;

    /** The corners of a simplex, which others share. */
    using Simplex = std::array<const Point *, 4>;

    /** Volume of a part of a simplex, m^3, and the integrals of the coordinates
     * over it. */
    struct Part
    {
      double volume = 0;
      Point  moment{};
    };

    /** Gradients of the barycentric coordinates, 1/m, and volume, m^3. */
    struct Frame
    {
      explicit Frame(const Tetrahedron &t)
        : origin(t[0])
      {
        const Vector3<double> e1 = t[1] - t[0], e2 = t[2] - t[0],
                              e3 = t[3] - t[0];
        const Vector3<double> n1 = cross(e2, e3), n2 = cross(e3, e1),
                              n3 = cross(e1, e2);
        const double d           = dot(e1, n1);
        volume                   = d / 6;
        for (unsigned int k = 0; k < 3; ++k)
          gradients[k] =
            (1 / d) * Row{-(n1[k] + n2[k] + n3[k]), n1[k], n2[k], n3[k]};
      }

      Coordinates
      coordinates(const Vector3<double> &x) const
      {
        Coordinates c = {1, 0, 0, 0};
        for (unsigned int k = 0; k < 3; ++k)
          c += (x[k] - origin[k]) * gradients[k];
        return c;
      }

      Corners
      coordinates(const Tetrahedron &t) const
      {
        return {{coordinates(t[0]),
                 coordinates(t[1]),
                 coordinates(t[2]),
                 coordinates(t[3])}};
      }

      Vector3<double> origin;

      /** Component by component. */
      std::array<Row, 3> gradients;
      double             volume;
    };

    /** How a plane cuts a simplex. */
    struct Cut
    {
      /** Of the corners, those inside first. */
      std::array<unsigned int, 4> order;
      unsigned int                n_inside;
    };

    /** One for each set of corners outside, of which these are the bits. */
    constexpr std::array<Cut, 16>
    make_cuts()
    {
      std::array<Cut, 16> cuts{};
      for (unsigned int outside = 0; outside < 16; ++outside)
        {
          Cut         &cut = cuts[outside];
          unsigned int n   = 0;
          for (unsigned int c = 0; c < 4; ++c)
            if ((outside >> c & 1) == 0)
              cut.order[n++] = c;
          cut.n_inside = n;
          for (unsigned int c = 0; c < 4; ++c)
            if ((outside >> c & 1) == 1)
              cut.order[n++] = c;
        }
      return cuts;
    }

    constexpr std::array<Cut, 16> cuts = make_cuts();

    /** A plane that cuts a simplex. */
    class Plane
    {
    public:
      /** The one of the other tetrahedron with the fewest corners inside: it
       * leaves least to do for the others. */
      explicit Plane(const Simplex &simplex)
      {
        Mask outside{};
        for (unsigned int c = 0; c < 4; ++c)
          outside |= (simplex[c]->in_b < 0) & (1 << c);
        // Number of corners inside, corners outside, and number of the plane in
        // one, so that it is chosen without branches.
        std::int64_t best = std::numeric_limits<std::int64_t>::max();
        for (unsigned int k = 0; k < 4; ++k)
          best = std::min(best,
                          std::int64_t{cuts[outside[k]].n_inside} * 64 +
                            outside[k] * 4 + k);
        cut    = &cuts[best / 4 % 16];
        number = best % 4;
      }

      const Cut &
      how() const
      {
        return *cut;
      }

      /** How far it is from a corner inside to the plane, on the way to one
       * outside. */
      double
      cut_fraction(const Point &in, const Point &out) const
      {
        return in.in_b[number] / (in.in_b[number] - out.in_b[number]);
      }

      /** The point there: exactly in the plane, which it is not cut by again.
       */
      Point
      between(const Point &in, const Point &out, const double fraction) const
      {
        constexpr Mask others[4] = {{0, -1, -1, -1},
                                    {-1, 0, -1, -1},
                                    {-1, -1, 0, -1},
                                    {-1, -1, -1, 0}};
        const Row      in_b      = in.in_b + fraction * (out.in_b - in.in_b);
        return {in.in_a + fraction * (out.in_a - in.in_a),
                (Row)((Mask)in_b & others[number])};
      }

    private:
      const Cut   *cut;
      unsigned int number;
    };

    /** Adds a simplex that is in all half-spaces. */
    inline void
    add(const Simplex &simplex, const double volume, Part &part)
    {
      const auto &[p0, p1, p2, p3] = simplex;
      part.volume += volume;
      part.moment.in_a +=
        volume / 4 * ((p0->in_a + p1->in_a) + (p2->in_a + p3->in_a));
      part.moment.in_b +=
        volume / 4 * ((p0->in_b + p1->in_b) + (p2->in_b + p3->in_b));
    }

    /**
     * Adds what of a simplex has no negative coordinates in B. A plane cuts it
     * into at most three simplices on the inner side, whose volumes are
     * products of positive numbers: nothing cancels, and the result depends
     * continuously on the corners through all types of intersection.
     *
     * @param volume of the simplex, m^3.
     */
    inline void
    clip(const Simplex &simplex, const double volume, Part &part)
    {
      if (volume == 0)
        return;
      const Plane  plane(simplex);
      const auto  &how = plane.how();
      const Point &p0 = *simplex[how.order[0]], &p1 = *simplex[how.order[1]],
                  &p2 = *simplex[how.order[2]], &p3 = *simplex[how.order[3]];
      switch (how.n_inside)
        {
        case 0:
          return;
        case 1:
          {
            const double t1 = plane.cut_fraction(p0, p1),
                         t2 = plane.cut_fraction(p0, p2),
                         t3 = plane.cut_fraction(p0, p3);
            const Point c1  = plane.between(p0, p1, t1),
                        c2  = plane.between(p0, p2, t2),
                        c3  = plane.between(p0, p3, t3);
            clip({{&p0, &c1, &c2, &c3}}, volume * t1 * t2 * t3, part);
            return;
          }
        case 2:
          {
            const double t02 = plane.cut_fraction(p0, p2),
                         t03 = plane.cut_fraction(p0, p3),
                         t12 = plane.cut_fraction(p1, p2),
                         t13 = plane.cut_fraction(p1, p3);
            const Point c02  = plane.between(p0, p2, t02),
                        c03  = plane.between(p0, p3, t03),
                        c12  = plane.between(p1, p2, t12),
                        c13  = plane.between(p1, p3, t13);
            clip({{&p0, &p1, &c02, &c03}}, volume * t02 * t03, part);
            clip({{&c02, &c03, &p1, &c12}},
                 volume * (1 - t02) * t03 * t12,
                 part);
            clip({{&c03, &p1, &c12, &c13}},
                 volume * (1 - t03) * t12 * t13,
                 part);
            return;
          }
        case 3:
          {
            const double t0 = plane.cut_fraction(p0, p3),
                         t1 = plane.cut_fraction(p1, p3),
                         t2 = plane.cut_fraction(p2, p3);
            const Point c0  = plane.between(p0, p3, t0),
                        c1  = plane.between(p1, p3, t1),
                        c2  = plane.between(p2, p3, t2);
            clip({{&p0, &p1, &p2, &c2}}, volume * t2, part);
            clip({{&p0, &p1, &c1, &c2}}, volume * t1 * (1 - t2), part);
            clip({{&p0, &c0, &c1, &c2}},
                 volume * t0 * (1 - t1) * (1 - t2),
                 part);
            return;
          }
        default:
          add(simplex, volume, part);
        }
    }

    /** Whether all corners are on the outer side of a face of the other. */
    inline bool
    is_outside(const Corners &c)
    {
      const Mask is_inside = (c[0] > 0) | (c[1] > 0) | (c[2] > 0) | (c[3] > 0);
      return (is_inside[0] & is_inside[1] & is_inside[2] & is_inside[3]) == 0;
    }

    /**
     * Adds the potential of A over the overlap, and its derivatives. A consists
     * of four simplices between the centroid and a face each, in which the
     * coordinate of the corner opposite to the face is the least. Where the
     * boundary of the overlap moves, the potential is zero (on the surface of
     * A), or its change is the flux through that of B, which by the theorem of
     * Gauss is again an integral over the volume (doc/theory.md, eq. 25). So
     * volumes and centroids of the parts are all that is needed.
     */
    inline Part
    add_potential(const Frame                    &a,
                  const Frame                    &b,
                  const Corners                  &corners_in_b,
                  double                         &potential,
                  std::array<Vector3<double>, 4> &gradient_a,
                  std::array<Vector3<double>, 4> &gradient_b)
    {
      std::array<Point, 4> corners;
      Point                centroid{};
      for (unsigned int i = 0; i < 4; ++i)
        {
          corners[i].in_a    = Row{};
          corners[i].in_a[i] = 1;
          corners[i].in_b    = corners_in_b[i];
          centroid.in_a += corners[i].in_a / 4;
          centroid.in_b += corners[i].in_b / 4;
        }

      Part         whole;
      Vector3<Row> by_a{}, by_b{};
      double       sum = 0;
      for (unsigned int i = 0; i < 4; ++i)
        {
          Simplex simplex{{&corners[0], &corners[1], &corners[2], &corners[3]}};
          simplex[i] = &centroid;
          Part part;
          clip(simplex, a.volume / 4, part);
          if (part.volume == 0)
            continue;

          sum += part.moment.in_a[i];
          whole.volume += part.volume;
          whole.moment.in_a += part.moment.in_a;
          whole.moment.in_b += part.moment.in_b;
          for (unsigned int d = 0; d < 3; ++d)
            {
              by_a[d] -= a.gradients[d][i] * part.moment.in_a;
              by_b[d] += a.gradients[d][i] * part.moment.in_b;
            }
        }
      potential += sum;
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int c = 0; c < 4; ++c)
          {
            gradient_a[c][d] += by_a[d][c];
            gradient_b[c][d] += by_b[d][c] + sum * b.gradients[d][c];
          }
      return whole;
    }
  } // namespace scalar

  /** Intersects two tetrahedra, exactly but for rounding. All is zero if they
   * have no volume in common. */
  inline Overlap
  scalar_overlap(const Tetrahedron &a, const Tetrahedron &b)
  {
    using namespace scalar;
    const Frame   frame_b(b);
    const Corners corners_a = frame_b.coordinates(a);
    Overlap       result;
    if (is_outside(corners_a))
      return result;
    const Frame   frame_a(a);
    const Corners corners_b = frame_a.coordinates(b);
    if (is_outside(corners_b))
      return result;

    const Part   part    = add_potential(frame_a,
                                    frame_b,
                                    corners_a,
                                    result.potential,
                                    result.gradient_a,
                                    result.gradient_b);
    const double smaller = std::min(frame_a.volume, frame_b.volume);
    if (!(part.volume > negligible_share * smaller))
      return Overlap();
    add_potential(frame_b,
                  frame_a,
                  corners_b,
                  result.potential,
                  result.gradient_b,
                  result.gradient_a);
    result.volume          = part.volume;
    result.volume_fraction = part.volume / smaller;
    for (unsigned int c = 0; c < 4; ++c)
      {
        result.weights_a[c] = part.moment.in_a[c] / part.volume;
        result.weights_b[c] = part.moment.in_b[c] / part.volume;
      }
    return result;
  }
} // namespace rift::test

#endif
