#include <rift/contact/overlap.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace rift
{
  namespace
  {
    /** Barycentric coordinates in one tetrahedron. */
    using Coordinates = std::array<double, 4>;

    /** A point by its coordinates in A and in B, which depend on each other
     * linearly: points between points need nothing else. */
    struct Point
    {
      Coordinates in_a, in_b;
    };

    using Simplex = std::array<Point, 4>;

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
        const Vector3<double> n1 = cross(e2, e3);
        const double          d  = dot(e1, n1);
        volume                   = d / 6;
        gradients[1]             = (1 / d) * n1;
        gradients[2]             = (1 / d) * cross(e3, e1);
        gradients[3]             = (1 / d) * cross(e1, e2);
        gradients[0] = -1. * (gradients[1] + gradients[2] + gradients[3]);
      }

      Coordinates
      coordinates(const Vector3<double> &x) const
      {
        Coordinates c;
        for (unsigned int i = 1; i < 4; ++i)
          c[i] = dot(gradients[i], x - origin);
        c[0] = 1 - c[1] - c[2] - c[3];
        return c;
      }

      Vector3<double>                origin;
      std::array<Vector3<double>, 4> gradients;
      double                         volume;
    };

    Point
    between(const Point &p, const Point &q, const double t)
    {
      Point r;
      for (unsigned int i = 0; i < 4; ++i)
        {
          r.in_a[i] = p.in_a[i] + t * (q.in_a[i] - p.in_a[i]);
          r.in_b[i] = p.in_b[i] + t * (q.in_b[i] - p.in_b[i]);
        }
      return r;
    }

    /** Adds a simplex that is in all half-spaces. */
    void
    add(const Simplex &simplex, const double volume, Part &part)
    {
      part.volume += volume;
      for (unsigned int i = 0; i < 4; ++i)
        for (const Point &p : simplex)
          {
            part.moment.in_a[i] += volume / 4 * p.in_a[i];
            part.moment.in_b[i] += volume / 4 * p.in_b[i];
          }
    }

    /**
     * Adds what of a simplex has no negative coordinates in B. A plane cuts it
     * into at most three simplices on the inner side, whose volumes are
     * products of positive numbers: nothing cancels, and the result depends
     * continuously on the corners through all types of intersection.
     *
     * @param volume of the simplex, m^3.
     * @param plane the coordinates in B before this one are known not to be
     *   negative.
     */
    void
    clip(Simplex simplex, const double volume, unsigned int plane, Part &part)
    {
      for (; plane < 4; ++plane)
        {
          // The corners inside first.
          unsigned int n_inside = 0;
          for (unsigned int i = 0; i < 4; ++i)
            if (simplex[i].in_b[plane] >= 0)
              std::swap(simplex[i], simplex[n_inside++]);
          if (n_inside == 0)
            return;
          if (n_inside == 4)
            continue;

          const auto &[p0, p1, p2, p3] = simplex;
          // How far it is from a corner inside to the plane, on the way to one
          // outside.
          const auto share = [plane](const Point &in, const Point &out) {
            return in.in_b[plane] / (in.in_b[plane] - out.in_b[plane]);
          };
          if (n_inside == 1)
            {
              const double t1 = share(p0, p1), t2 = share(p0, p2),
                           t3 = share(p0, p3);
              simplex         = {{p0,
                                  between(p0, p1, t1),
                                  between(p0, p2, t2),
                                  between(p0, p3, t3)}};
              clip(simplex, volume * t1 * t2 * t3, plane + 1, part);
            }
          else if (n_inside == 2)
            {
              const double t02 = share(p0, p2), t03 = share(p0, p3),
                           t12 = share(p1, p2), t13 = share(p1, p3);
              const Point c02 = between(p0, p2, t02),
                          c03 = between(p0, p3, t03),
                          c12 = between(p1, p2, t12),
                          c13 = between(p1, p3, t13);
              clip({{p0, p1, c02, c03}}, volume * t02 * t03, plane + 1, part);
              clip({{c02, c03, p1, c12}},
                   volume * (1 - t02) * t03 * t12,
                   plane + 1,
                   part);
              clip({{c03, p1, c12, c13}},
                   volume * (1 - t03) * t12 * t13,
                   plane + 1,
                   part);
            }
          else
            {
              const double t0 = share(p0, p3), t1 = share(p1, p3),
                           t2 = share(p2, p3);
              const Point c0 = between(p0, p3, t0), c1 = between(p1, p3, t1),
                          c2 = between(p2, p3, t2);
              clip({{p0, p1, p2, c2}}, volume * t2, plane + 1, part);
              clip({{p0, p1, c1, c2}}, volume * t1 * (1 - t2), plane + 1, part);
              clip({{p0, c0, c1, c2}},
                   volume * t0 * (1 - t1) * (1 - t2),
                   plane + 1,
                   part);
            }
          return;
        }
      add(simplex, volume, part);
    }

    /** Whether all corners are on the outer side of a face of the other. */
    bool
    is_outside(const Simplex &corners)
    {
      for (unsigned int plane = 0; plane < 4; ++plane)
        if (std::none_of(corners.begin(),
                         corners.end(),
                         [plane](const Point &p) { return p.in_b[plane] > 0; }))
          return true;
      return false;
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
    Part
    add_potential(const Frame                    &a,
                  const Frame                    &b,
                  const Simplex                  &corners,
                  double                         &potential,
                  std::array<Vector3<double>, 4> &gradient_a,
                  std::array<Vector3<double>, 4> &gradient_b)
    {
      Part  whole;
      Point centroid{};
      for (unsigned int i = 0; i < 4; ++i)
        for (const Point &p : corners)
          {
            centroid.in_a[i] += p.in_a[i] / 4;
            centroid.in_b[i] += p.in_b[i] / 4;
          }

      for (unsigned int i = 0; i < 4; ++i)
        {
          Simplex simplex = corners;
          simplex[i]      = centroid;
          if (is_outside(simplex))
            continue;
          Part part;
          clip(simplex, a.volume / 4, 0, part);
          if (part.volume == 0)
            continue;

          const auto &[in_a, in_b] = part.moment;
          potential += in_a[i];
          whole.volume += part.volume;
          for (unsigned int c = 0; c < 4; ++c)
            {
              whole.moment.in_a[c] += in_a[c];
              whole.moment.in_b[c] += in_b[c];
              gradient_a[c] -= in_a[c] * a.gradients[i];
              gradient_b[c] +=
                in_b[c] * a.gradients[i] + in_a[i] * b.gradients[c];
            }
        }
      return whole;
    }

    /** The corners of `a`, the coordinates in `a` first. */
    Simplex
    corners_of(const Tetrahedron &a, const Frame &b)
    {
      Simplex corners{};
      for (unsigned int i = 0; i < 4; ++i)
        {
          corners[i].in_a[i] = 1;
          corners[i].in_b    = b.coordinates(a[i]);
        }
      return corners;
    }

    /** From the face of `a` from which `b` is farthest, m. */
    double
    distance_from_faces(const Frame &a, const Tetrahedron &b)
    {
      Coordinates largest;
      largest.fill(-std::numeric_limits<double>::max());
      for (const Vector3<double> &x : b)
        {
          const Coordinates c = a.coordinates(x);
          for (unsigned int i = 0; i < 4; ++i)
            largest[i] = std::max(largest[i], c[i]);
        }
      double distance = -std::numeric_limits<double>::max();
      for (unsigned int i = 0; i < 4; ++i)
        distance = std::max(distance, -largest[i] / norm(a.gradients[i]));
      return distance;
    }
  } // namespace

  double
  separation(const Tetrahedron &a, const Tetrahedron &b)
  {
    return std::max(distance_from_faces(Frame(a), b),
                    distance_from_faces(Frame(b), a));
  }

  Overlap
  overlap(const Tetrahedron &a, const Tetrahedron &b)
  {
    const Frame   frame_a(a), frame_b(b);
    const Simplex corners_a = corners_of(a, frame_b);
    Overlap       result;
    if (is_outside(corners_a))
      return result;
    const Simplex corners_b = corners_of(b, frame_a);
    if (is_outside(corners_b))
      return result;

    const Part part = add_potential(frame_a,
                                    frame_b,
                                    corners_a,
                                    result.potential,
                                    result.gradient_a,
                                    result.gradient_b);
    if (part.volume == 0)
      return Overlap();
    add_potential(frame_b,
                  frame_a,
                  corners_b,
                  result.potential,
                  result.gradient_b,
                  result.gradient_a);
    result.volume = part.volume;
    for (unsigned int c = 0; c < 4; ++c)
      {
        result.weights_a[c] = part.moment.in_a[c] / part.volume;
        result.weights_b[c] = part.moment.in_b[c] / part.volume;
      }
    return result;
  }
} // namespace rift
