// Overlap of two tetrahedra: closed forms, brute force, the gradient by finite
// differences, and that it has neither force nor torque.

#include <rift/contact/separation.h>

#include "../support/single_pair.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace rift;
using namespace rift::test;

namespace
{
  const Tetrahedron unit = {
    {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};

  double
  volume(const Tetrahedron &t)
  {
    return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) / 6;
  }

  std::array<double, 4>
  coordinates(const Tetrahedron &t, const Vector3<double> &x)
  {
    std::array<double, 4> c;
    for (unsigned int i = 0; i < 4; ++i)
      {
        Tetrahedron part = t;
        part[i]          = x;
        c[i]             = volume(part) / volume(t);
      }
    return c;
  }

  double
  least(const std::array<double, 4> &c)
  {
    return *std::min_element(c.begin(), c.end());
  }

  /** Random tetrahedra that are not flat. */
  class Generator
  {
  public:
    Tetrahedron
    operator()(const double spread)
    {
      std::normal_distribution<double> normal;
      while (true)
        {
          Tetrahedron t;
          for (auto &x : t)
            for (double &v : x)
              v = spread * normal(engine);
          if (volume(t) < 0)
            std::swap(t[0], t[1]);
          if (volume(t) > .02)
            return t;
        }
    }

  private:
    std::mt19937 engine{1};
  };
} // namespace

TEST(Overlap, OfATetrahedronWithItself)
{
  const Overlap all = overlap(unit, unit);
  EXPECT_NEAR(all.volume, 1. / 6, 1e-15);
  // The mean of the least coordinate is 1/16: each quarter has a quarter of
  // its largest value, 1/4.
  EXPECT_NEAR(all.potential, 2. / 16 / 6, 1e-15);
  for (unsigned int c = 0; c < 4; ++c)
    {
      EXPECT_NEAR(all.weights_a[c], .25, 1e-15);
      EXPECT_NEAR(all.weights_b[c], .25, 1e-15);
    }
}

TEST(Overlap, OfFacesThatAreParallel)
{
  // Two prisms' ends would overlap by A depth; tetrahedra whose faces lie upon
  // each other lose a little at the sides. To first order in the depth the
  // potential is A depth^2 / h, A and h of both being the same.
  const double depth = 1e-5;
  Tetrahedron  below = unit;
  std::swap(below[1], below[2]);
  for (auto &x : below)
    x[2] = -x[2] + depth;
  const Overlap shallow = overlap(unit, below);
  EXPECT_NEAR(shallow.volume / (.5 * depth), 1, 1e-4);
  EXPECT_NEAR(shallow.potential / (.5 * depth * depth), 1, 1e-4);
  Vector3<double> pull{};
  for (const auto &g : shallow.gradient_a)
    pull += g;
  // The depth becomes smaller when the upper one goes up.
  EXPECT_NEAR(pull[2] / -depth, 1, 1e-4);
}

TEST(Overlap, AgreesWithSampling)
{
  Generator                              make;
  std::mt19937                           engine(7);
  std::uniform_real_distribution<double> uniform;
  unsigned int                           n_overlaps = 0;
  for (unsigned int trial = 0; trial < 100; ++trial)
    {
      const Tetrahedron  a = make(1), b = make(1);
      const unsigned int n = 20000;
      double             v = 0, phi = 0, spread = 0;
      for (unsigned int i = 0; i < n; ++i)
        {
          std::array<double, 3> s{
            {uniform(engine), uniform(engine), uniform(engine)}};
          std::sort(s.begin(), s.end());
          const Vector3<double> x = s[0] * a[0] + (s[1] - s[0]) * a[1] +
                                    (s[2] - s[1]) * a[2] + (1 - s[2]) * a[3];
          const double in_b = least(coordinates(b, x));
          if (in_b < 0)
            continue;
          const double value = least(coordinates(a, x)) + in_b;
          v += volume(a) / n;
          phi += value * volume(a) / n;
          spread += value * value;
        }
      const Overlap exact = overlap(a, b);
      n_overlaps += exact.volume > 0;
      // Five standard deviations of the sample.
      const double share = exact.volume / volume(a);
      EXPECT_NEAR(exact.volume,
                  v,
                  5 * volume(a) * std::sqrt(share * (1 - share) / n) + 1e-3);
      EXPECT_NEAR(exact.potential,
                  phi,
                  5 * volume(a) * std::sqrt(spread) / n + 5e-4);
    }
  EXPECT_GT(n_overlaps, 50U);
}

TEST(Overlap, GradientIsThatOfThePotential)
{
  Generator    make;
  unsigned int n_overlaps = 0;
  double       worst      = 0;
  while (n_overlaps < 10000)
    {
      const std::array<Tetrahedron, 2> pair{{make(.7), make(.7)}};
      const Overlap                    o = overlap(pair[0], pair[1]);
      if (o.volume < 1e-3)
        continue;
      ++n_overlaps;
      double size = 0;
      for (unsigned int c = 0; c < 4; ++c)
        size += norm(o.gradient_a[c]) + norm(o.gradient_b[c]);
      // Along a random direction of all 24 coordinates; of fourth order. The
      // derivative has kinks of its own, so that a larger step may be worse.
      const std::array<Tetrahedron, 2> direction{{make(1), make(1)}};
      double                           expected = 0;
      for (unsigned int c = 0; c < 4; ++c)
        expected += dot(o.gradient_a[c], direction[0][c]) +
                    dot(o.gradient_b[c], direction[1][c]);
      const auto at = [&](const double s) {
        auto moved = pair;
        for (unsigned int k = 0; k < 2; ++k)
          for (unsigned int c = 0; c < 4; ++c)
            moved[k][c] += s * direction[k][c];
        return overlap(moved[0], moved[1]).potential;
      };
      double error = 1;
      for (const double h : {1e-4, 1e-5})
        error =
          std::min(error,
                   std::abs((8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) /
                              (12 * h) -
                            expected) /
                     size);
      worst = std::max(worst, error);
    }
  EXPECT_LT(worst, 1e-6);
}

TEST(Overlap, PullsWithoutForceAndTorque)
{
  Generator make;
  for (unsigned int trial = 0; trial < 1000; ++trial)
    {
      const Tetrahedron a = make(1), b = make(1);
      const Overlap     o = overlap(a, b);
      Vector3<double>   force{}, torque{}, distance{};
      for (unsigned int c = 0; c < 4; ++c)
        {
          // Both weights give the same point.
          distance += o.weights_a[c] * a[c] - o.weights_b[c] * b[c];
          force += o.gradient_a[c] + o.gradient_b[c];
          torque += cross(a[c], o.gradient_a[c]) + cross(b[c], o.gradient_b[c]);
        }
      EXPECT_LT(norm(force), 1e-13);
      EXPECT_LT(norm(torque), 1e-13);
      EXPECT_LT(norm(distance), 1e-13);
    }
}

TEST(Overlap, IsZeroWithoutCommonVolume)
{
  // Side by side, corner to corner, edge to edge, and one in the other's
  // bounding box but beyond its oblique face.
  for (const Vector3<double> &shift : {Vector3<double>{{-1, 0, 0}},
                                       Vector3<double>{{0, 0, 1}},
                                       Vector3<double>{{-1, -1, 0}},
                                       Vector3<double>{{.4, .4, .4}},
                                       Vector3<double>{{5, 0, 0}}})
    {
      Tetrahedron other = unit;
      for (auto &x : other)
        x += shift;
      const Overlap o = overlap(unit, other);
      EXPECT_EQ(o.volume, 0);
      EXPECT_EQ(o.potential, 0);
    }
}

TEST(FacePlanes, KnowDistances)
{
  const auto separation = [](const Tetrahedron &a, const Tetrahedron &b) {
    return std::max(FacePlanes(a).distance_to(b), FacePlanes(b).distance_to(a));
  };
  Tetrahedron above = unit;
  for (auto &x : above)
    x[2] += 1.25;
  // A corner of one, a face of the other; the oblique face and a corner.
  EXPECT_NEAR(FacePlanes(above).distance_to(unit), .25, 1e-15);
  EXPECT_NEAR(FacePlanes(unit).distance_to(above), .25 / std::sqrt(3), 1e-15);
  EXPECT_LE(separation(unit, unit), 0);

  // Never more than the distance of any two points.
  Generator make;
  for (unsigned int trial = 0; trial < 2000; ++trial)
    {
      const Tetrahedron a = make(1);
      Tetrahedron       b = make(1);
      for (auto &x : b)
        x[0] += 2;
      double corners = 100;
      for (const auto &x : a)
        for (const auto &y : b)
          corners = std::min(corners, norm(x - y));
      const double distance = separation(a, b);
      EXPECT_LE(distance, corners);
      EXPECT_FALSE(distance > 0 && overlap(a, b).volume > 0);
    }
}
