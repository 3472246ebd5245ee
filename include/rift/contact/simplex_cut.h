#ifndef rift_contact_simplex_cut_h
#define rift_contact_simplex_cut_h

#include <rift/base/simd.h>

#include <array>

namespace rift
{
  // Weights of corners that a part of a simplex has, eight simplices at a time:
  // the inner part of OverlapBatch.

  /** The coordinate by which a plane cuts simplices, of their four corners: not
   * negative inside. */
  using Plane = std::array<Simd, 4>;

  /** How often each corner of simplices counts in the means over a part of
   * them: the sum is the share of the volume. */
  using Weights = std::array<Simd, 4>;

  /** Exchanges two numbers where a mask is true. */
  inline void
  exchange(const SimdMask &where, Simd &a, Simd &b)
  {
    const Simd old = a;
    a              = select(where, b, a);
    b              = select(where, old, b);
  }

  /** A number of each of the points of a cut. */
  struct CutPoints
  {
    /** See Cut. */
    Simd p0, p1, p2, p3, x, y, z, w;
  };

  /**
   * A plane's cut through simplices, whose corners p0 to p3 are sorted by their
   * coordinate f: first those inside. With t_ij = f_i/(f_i - f_j), how far it is
   * from corner i inside to the plane on the way to corner j outside, the edges
   * are cut at
   *
   *   corners inside   x     y     z     w     the simplices inside
   *   one              t_03  t_02  t_01        p0 z y x
   *   two              t_03  t_02  t_12  t_13  p0 p1 y x; x p1 y z; p1 x w z
   *   three            t_03  t_13  t_23        p0 p1 p2 z; p0 p1 y z; p0 x y z
   *
   * Simplices that are wholly inside count as three with z = p3.
   */
  class Cut
  {
  public:
    /** @param f the coordinate. */
    explicit Cut(Plane f)
    {
      const auto sort_two =
        [&](SimdMask &swap, const unsigned int i, const unsigned int j) {
          swap         = f[i] < f[j];
          const Simd a = f[i];
          f[i]         = select(swap, f[j], a);
          f[j]         = select(swap, a, f[j]);
        };
      sort_two(swaps[0], 0, 1);
      sort_two(swaps[1], 2, 3);
      sort_two(swaps[2], 0, 2);
      sort_two(swaps[3], 1, 3);
      sort_two(swaps[4], 1, 2);
      has_one                = f[1] < 0;
      has_three              = f[2] >= 0;
      const SimdMask has_two = ~(has_one | has_three),
                     is_cut  = (f[0] >= 0) & (f[3] < 0);
      const Simd one         = broadcast(1), zero{};

      const Simd y_in  = select(has_three, f[1], f[0]),
                 y_out = select(has_three, f[3], f[2]),
                 z_in  = select(has_one, f[0], select(has_three, f[2], f[1])),
                 z_out = select(has_one, f[1], select(has_three, f[3], f[2]));
      // One division for all: they take longest. No t is above 1, and what is
      // not a number because all is tiny becomes 1.
      const Simd dx = f[0] - f[3], dy = y_in - y_out, dz = z_in - z_out,
                 dw  = select(has_two, f[1] - f[3], one);
      const Simd dxy = dx * dy, dzw = dz * dw;
      const Simd inverse = one / select(is_cut, dxy * dzw, one);
      const Simd of_xy = inverse * dzw, of_zw = inverse * dxy;
      x = min(f[0] * (dy * of_xy), one);
      y = min(y_in * (dx * of_xy), one);
      z = select(is_cut, min(z_in * (dw * of_zw), one), one);
      w = select(has_two, min(f[1] * (dz * of_zw), one), one);

      shares[0] = select(f[0] < 0,
                         zero,
                         select(has_three, z, y * x) * select(has_one, z, one));
      shares[1] = select(has_one,
                         zero,
                         select(has_three, y * (one - z), (one - y) * x * z));
      shares[2] =
        select(has_one,
               zero,
               select(has_three, x * (one - y) * (one - z), (one - x) * z * w));
    }

    /** A coordinate of the corners at all points. */
    CutPoints
    points(const Plane &f) const
    {
      CutPoints p{f[0], f[1], f[2], f[3], {}, {}, {}, {}};
      exchange(swaps[0], p.p0, p.p1);
      exchange(swaps[1], p.p2, p.p3);
      exchange(swaps[2], p.p0, p.p2);
      exchange(swaps[3], p.p1, p.p3);
      exchange(swaps[4], p.p1, p.p2);
      const auto between = [](const Simd &in, const Simd &out, const Simd &t) {
        return in + t * (out - in);
      };
      p.x = between(p.p0, p.p3, x);
      p.y = between(select(has_three, p.p1, p.p0),
                    select(has_three, p.p3, p.p2),
                    y);
      p.z = between(select(has_one, p.p0, select(has_three, p.p2, p.p1)),
                    select(has_one, p.p1, select(has_three, p.p3, p.p2)),
                    z);
      p.w = between(p.p1, p.p3, w);
      return p;
    }

    /** Those of the corners of simplex 0, 1 or 2 inside. */
    std::array<Simd, 4>
    part(const CutPoints &p, const unsigned int number) const
    {
      switch (number)
        {
        case 0:
          return {{p.p0,
                   select(has_one, p.z, p.p1),
                   select(has_three, p.p2, p.y),
                   select(has_three, p.z, p.x)}};
        case 1:
          return {{select(has_three, p.p0, p.x), p.p1, p.y, p.z}};
        default:
          return {{select(has_three, p.p0, p.p1),
                   p.x,
                   select(has_three, p.y, p.w),
                   p.z}};
        }
    }

    /** Weights of the corners of the whole from those of the simplices inside,
     * as if each of these were a whole. */
    Weights
    weights(const std::array<Weights, 3> &inner) const
    {
      Weights a, b, c;
      for (unsigned int i = 0; i < 4; ++i)
        {
          a[i] = shares[0] * inner[0][i];
          b[i] = shares[1] * inner[1][i];
          c[i] = shares[2] * inner[2][i];
        }
      const Simd one  = broadcast(1), zero{};
      const Simd at_x = c[1] + select(has_three, zero, a[3] + b[0]),
                 at_y = b[2] + select(has_three, c[2], a[2]),
                 at_z = (b[3] + c[3]) +
                        select(has_three, a[3], select(has_one, a[1], zero)),
                 at_w = select(has_three, zero, c[2]);
      const Simd y_in = (one - y) * at_y, y_out = y * at_y,
                 z_in = (one - z) * at_z, z_out = z * at_z;
      const SimdMask has_two = ~(has_one | has_three);
      Weights        r;
      r[0] = (a[0] + (one - x) * at_x) + select(has_three, b[0] + c[0], y_in) +
             select(has_one, z_in, zero);
      r[1] = (b[1] + (one - w) * at_w) + select(has_one, z_out, a[1]) +
             select(has_three, y_in, c[0] + select(has_two, z_in, zero));
      r[2] =
        select(has_three, a[2] + z_in, y_out) + select(has_two, z_out, zero);
      r[3] = (x * at_x + w * at_w) + select(has_three, y_out + z_out, zero);
      exchange(swaps[4], r[1], r[2]);
      exchange(swaps[3], r[1], r[3]);
      exchange(swaps[2], r[0], r[2]);
      exchange(swaps[1], r[2], r[3]);
      exchange(swaps[0], r[0], r[1]);
      return r;
    }

    /** Whether one corner is inside, or three. */
    SimdMask has_one, has_three;

    /** Volumes of the inner simplices over that of the whole. */
    Simd shares[3];

  private:
    /** How the corners were sorted. */
    SimdMask swaps[5];

    /** t_ij of the cuts. */
    Simd x, y, z, w;
  };

  /** The weights of the corners in the part of simplices that is inside of n
   * planes, each of which cuts what the others before it have left. All are sums
   * of products of positive numbers. */
  template <std::size_t n>
  Weights
  inside(const std::array<Plane, n> &planes)
  {
    if constexpr (n == 0)
      {
        const Simd quarter = broadcast(.25);
        return {{quarter, quarter, quarter, quarter}};
      }
    else
      {
        const Cut                cut(planes[0]);
        std::array<CutPoints, n> points;
        std::array<Weights, 3>   inner;
        for (std::size_t k = 1; k < n; ++k)
          points[k] = cut.points(planes[k]);
        for (unsigned int i = 0; i < 3; ++i)
          {
            std::array<Plane, n - 1> others;
            for (std::size_t k = 1; k < n; ++k)
              others[k - 1] = cut.part(points[k], i);
            inner[i] = inside<n - 1>(others);
          }
        return cut.weights(inner);
      }
  }
} // namespace rift

#endif
