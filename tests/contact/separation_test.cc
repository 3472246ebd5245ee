// Gaps of pairs: never more than the distance, and there where it is clear.

#include <rift/contact/separation.h>

#include "../support/contact_pairs.h"
#include "../support/scalar_overlap.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  double
  clamp(const double x)
  {
    return std::min(std::max(x, 0.), 1.);
  }

  double
  distance_to_triangle(const Vector3<double> &x,
                       const Vector3<double> &p,
                       const Vector3<double> &q,
                       const Vector3<double> &r)
  {
    const Vector3<double> n        = cross(q - p, r - p);
    const bool            is_above = dot(cross(q - p, x - p), n) >= 0 &&
                          dot(cross(r - q, x - q), n) >= 0 &&
                          dot(cross(p - r, x - r), n) >= 0;
    return is_above ? std::abs(dot(x - p, n)) / norm(n) : 1e300;
  }

  double
  distance_of_edges(const Vector3<double> &p,
                    const Vector3<double> &q,
                    const Vector3<double> &r,
                    const Vector3<double> &s)
  {
    // The nearest points of two segments, by turns: convex, so that it
    // converges to the least distance, from above.
    const Vector3<double> u = q - p, v = s - r;
    double                a = .5, b = .5;
    for (unsigned int i = 0; i < 200; ++i)
      {
        b = clamp(dot(p + a * u - r, v) / dot(v, v));
        a = clamp(dot(r + b * v - p, u) / dot(u, u));
      }
    return norm(p + a * u - r - b * v);
  }

  /** Of two tetrahedra that have no point in common. */
  double
  distance(const Tetrahedron &a, const Tetrahedron &b)
  {
    constexpr unsigned int edges[6][2] =
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
    double least = 1e300;
    for (const auto &e : edges)
      for (const auto &f : edges)
        least = std::min(least,
                         distance_of_edges(a[e[0]], a[e[1]], b[f[0]], b[f[1]]));
    for (unsigned int c = 0; c < 4; ++c)
      for (unsigned int i = 0; i < 4; ++i)
        for (const auto &[t, u] : {std::make_pair(a, b), std::make_pair(b, a)})
          least = std::min(least,
                           distance_to_triangle(t[c],
                                                u[(i + 1) % 4],
                                                u[(i + 2) % 4],
                                                u[(i + 3) % 4]));
    return least;
  }
} // namespace

TEST(Gaps, AreLowerBoundsOfDistances)
{
  PairGenerator make(3);
  PairList      list;
  for (unsigned int i = 0; i < 3000; ++i)
    list.add(make, i % 3 == 0 ? PairKind::deep : PairKind::parted);
  const std::size_t         n = list.pairs.size();
  std::vector<std::uint8_t> axes(n, no_axis);
  std::vector<double>       gaps(n);
  find_gaps(list.cells.data(), list.pairs.data(), n, axes.data(), gaps.data());

  unsigned int n_by_faces = 0, n_by_edges = 0;
  for (std::size_t i = 0; i < n; ++i)
    {
      const Tetrahedron a = unpack(list.cells[list.pairs[i].a]).positions,
                        b = unpack(list.cells[list.pairs[i].b]).positions;
      if (scalar_overlap(a, b).volume > 0)
        {
          EXPECT_LE(gaps[i], 0);
          EXPECT_EQ(axes[i], no_axis);
          continue;
        }
      const double exact = distance(a, b);
      EXPECT_LE(gaps[i], exact * (1 + 1e-12));
      // One of the axes of faces and edges parts any two.
      if (exact > 1e-6)
        {
          EXPECT_GT(gaps[i], 0);
          EXPECT_NE(axes[i], no_axis);
        }
      n_by_faces += axes[i] < 8 ? 1 : 0;
      n_by_edges += axes[i] >= 8 && axes[i] != no_axis ? 1 : 0;
    }
  EXPECT_GT(n_by_faces, 500U);
  EXPECT_GT(n_by_edges, 20U);
}

TEST(Gaps, KeepAnAxisThatParts)
{
  // Two edges across each other, which no face parts.
  const Tetrahedron lower = {
    {{{-1, 0, 0}}, {{1, 0, 0}}, {{.2, -1, -1}}, {{-.2, 1, -1}}}};
  Tetrahedron upper = {
    {{{0, -1, .01}}, {{0, 1, .01}}, {{-1, .2, 1.01}}, {{1, -.2, 1.01}}}};
  for (Tetrahedron t : {lower, upper})
    ASSERT_NE(volume(t), 0);
  std::vector<PackedMotion> cells;
  for (Tetrahedron t : {lower, upper})
    {
      if (volume(t) < 0)
        std::swap(t[2], t[3]);
      cells.push_back(pack(t));
    }
  const CellPair pair = {0, 1};
  std::uint8_t   axis = no_axis;
  double         gap  = 0;
  find_gaps(cells.data(), &pair, 1, &axis, &gap);
  EXPECT_NEAR(gap, .01, 1e-7);
  EXPECT_LT(gap, .01);
  ASSERT_GE(axis, 8);
  ASSERT_NE(axis, no_axis);

  const std::uint8_t before = axis;
  for (NodalVector &x : cells[1].position)
    x[2] += 1e-3;
  find_gaps(cells.data(), &pair, 1, &axis, &gap);
  EXPECT_EQ(axis, before);
  EXPECT_NEAR(gap, .011, 1e-7);

  for (NodalVector &x : cells[1].position)
    x[2] -= .1;
  find_gaps(cells.data(), &pair, 1, &axis, &gap);
  EXPECT_LE(gap, 0);
  EXPECT_EQ(axis, no_axis);
}

TEST(Gaps, AreThoseOfFacePlanes)
{
  PairGenerator make(8);
  PairList      list;
  for (unsigned int i = 0; i < 100; ++i)
    list.add(make, PairKind::parted);
  for (const CellPair &pair : list.pairs)
    {
      const Tetrahedron a = unpack(list.cells[pair.a]).positions,
                        b = unpack(list.cells[pair.b]).positions;
      const double expected =
        std::max(FacePlanes(a).distance_to(b), FacePlanes(b).distance_to(a));
      std::uint8_t axis = no_axis;
      double       gap  = 0;
      find_gaps(list.cells.data(), &pair, 1, &axis, &gap);
      if (expected > 0)
        {
          EXPECT_NEAR(gap, expected, 1e-13);
          EXPECT_LT(axis, 8);
        }
    }
}
