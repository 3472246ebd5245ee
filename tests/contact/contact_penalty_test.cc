// That contact adds no more to the squares of frequencies than it may.

#include <rift/contact/contact_penalty.h>

#include "../support/single_pair.h"
#include <gtest/gtest.h>

#include <random>

using namespace rift;
using namespace rift::test;

namespace
{
  double
  volume(const Tetrahedron &t)
  {
    return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) / 6;
  }

  /** Of a cell of the shape of `t` alone in its batch. */
  double
  penalty_of(const Tetrahedron &t, const double density, const double room)
  {
    ReferenceBatch batch{};
    for (unsigned int c = 1; c < 4; ++c)
      {
        const Vector3<double> &a = t[c == 1 ? 2 : 1], &b = t[c == 3 ? 2 : 3];
        Vector3<double>        gradient = cross(a - t[0], b - t[0]);
        gradient = (1 / dot(gradient, t[c] - t[0])) * gradient;
        for (unsigned int d = 0; d < 3; ++d)
          batch.gradients[c - 1][d][0] = gradient[d];
      }
    batch.volume[0] = volume(t);
    return largest_penalty(batch, 0, density, room);
  }

  /** The mirror image of a cell at one of its faces, pushed into it by a
   * little. */
  Tetrahedron
  mirrored(const Tetrahedron &t, const unsigned int corner, const double depth)
  {
    const Vector3<double> &p = t[(corner + 1) % 4];
    Vector3<double> n = cross(t[(corner + 2) % 4] - p, t[(corner + 3) % 4] - p);
    n                 = (1 / norm(n)) * n;
    if (dot(t[corner] - p, n) < 0)
      n = -1. * n;
    Tetrahedron image;
    for (unsigned int c = 0; c < 4; ++c)
      image[c] = t[c] - (2 * dot(t[c] - p, n) - depth) * n;
    std::swap(image[0], image[1]);
    return image;
  }

  /** A cell with a partner at each face: cell 0 and cells 1 to 4. */
  struct Cluster
  {
    std::vector<Tetrahedron> cells;
    double                   penalty;

    /** Forces on all corners, N. */
    std::vector<Vector3<double>>
    forces(const std::vector<Vector3<double>> &displacement) const
    {
      std::vector<Vector3<double>> result(20, Vector3<double>{});
      std::vector<CellMotion>      motions(5);
      for (unsigned int i = 0; i < 20; ++i)
        {
          motions[i / 4].positions[i % 4] =
            cells[i / 4][i % 4] + displacement[i];
          motions[i / 4].velocities[i % 4] = {};
        }
      for (unsigned int b = 1; b < 5; ++b)
        {
          ContactMemory    memory;
          const PairForces pair =
            pair_forces(motions[0], motions[b], {penalty, 0, 0, 1}, 0, memory);
          for (unsigned int c = 0; c < 4; ++c)
            {
              result[c] += pair.on_a[c].vector();
              result[4 * b + c] += pair.on_b[c].vector();
            }
        }
      return result;
    }

    /** Largest eigenvalue of stiffness over lumped mass, 1/s^2, by iteration
     * with differences of forces. */
    double
    largest_frequency_squared(const double density, const double step) const
    {
      const double mass = density * volume(cells[0]) / 4;
      std::mt19937 random(1);
      std::uniform_real_distribution<double> number(-1, 1);
      std::vector<Vector3<double>>           mode(20);
      for (Vector3<double> &x : mode)
        x = {{number(random), number(random), number(random)}};
      double eigenvalue = 0;
      for (unsigned int i = 0; i < 300; ++i)
        {
          double length = 0;
          for (const Vector3<double> &x : mode)
            length += dot(x, x);
          length = std::sqrt(length);
          std::vector<Vector3<double>> forward, backward;
          for (const Vector3<double> &x : mode)
            {
              forward.push_back((step / length) * x);
              backward.push_back((-step / length) * x);
            }
          const auto after = forces(forward), before = forces(backward);
          eigenvalue = 0;
          for (unsigned int j = 0; j < 20; ++j)
            {
              const Vector3<double> change =
                (1 / (2 * step * mass)) * (before[j] - after[j]);
              eigenvalue += dot(change, (1 / length) * mode[j]);
              mode[j] = change;
            }
        }
      return eigenvalue;
    }
  };
} // namespace

TEST(ContactPenalty, LeavesTheRoomThatThereIs)
{
  const double                           density = 2700, room = 1e12;
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> number(0, 1e-3);
  unsigned int                           n_cells  = 0;
  double                                 smallest = 1;
  while (n_cells < 50)
    {
      Tetrahedron t;
      for (Vector3<double> &x : t)
        x = {{number(random), number(random), number(random)}};
      if (volume(t) < 2e-11)
        continue;
      ++n_cells;
      const double height =
        std::sqrt(48 * penalty_of(t, density, room) / (density * room));
      Cluster cluster{{t}, penalty_of(t, density, room)};
      for (unsigned int c = 0; c < 4; ++c)
        cluster.cells.push_back(mirrored(t, c, 1e-3 * height));
      const double share =
        cluster.largest_frequency_squared(density, 1e-5 * height) / room;
      EXPECT_LT(share, 1);
      smallest = std::min(smallest, share);
    }
  // Nor is it smaller than it need be by much.
  EXPECT_GT(smallest, .2);
}
