#include <rift/contact/separation.h>
#include <algorithm>
namespace rift
{
  static Tetrahedron un(const PackedMotion &m)
  {
    Tetrahedron t;
    for (int i = 0; i < 4; ++i) t[i] = m.position[i].vector();
    return t;
  }
  void
  find_gaps(const PackedMotion *cells, const CellPair *pairs, std::size_t n, std::uint8_t *, double *gaps)
  {
    constexpr int edges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    for (std::size_t i = 0; i < n; ++i)
      {
        const Tetrahedron a = un(cells[pairs[i].a]), b = un(cells[pairs[i].b]);
        double gap = std::max(FacePlanes(a).distance_to(b), FacePlanes(b).distance_to(a));
        if (gap <= 0)
          for (int e = 0; e < 6; ++e)
            for (int f = 0; f < 6; ++f)
              {
                const auto nn = cross(a[edges[e][1]] - a[edges[e][0]], b[edges[f][1]] - b[edges[f][0]]);
                double la = 1e300, ua = -1e300, lb = 1e300, ub = -1e300;
                for (int c = 0; c < 4; ++c)
                  {
                    double x = dot(nn, a[c] - a[0]), y = dot(nn, b[c] - a[0]);
                    la = std::min(la, x); ua = std::max(ua, x); lb = std::min(lb, y); ub = std::max(ub, y);
                  }
                if (norm(nn) > 0)
                  gap = std::max(gap, std::max(lb - ua, la - ub) / norm(nn) - 1e-8 * norm(a[1] - a[0]));
              }
        gaps[i] = gap;
      }
  }
}
