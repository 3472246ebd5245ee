// Overlap and contact by eights: against the scalar overlap, in any company,
// and of cells that are degenerate.

#include "../support/contact_pairs.h"
#include "../support/single_pair.h"
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

using namespace rift;
using namespace rift::test;

namespace
{
  PairList
  pairs_of_all_kinds(PairGenerator &make, const unsigned int n_per_kind)
  {
    PairList list;
    for (unsigned int i = 0; i < n_per_kind; ++i)
      for (const PairKind kind : all_pair_kinds)
        list.add(make, kind);
    return list;
  }

  Tetrahedron
  corners(const PackedMotion &cell)
  {
    return unpack(cell).positions;
  }

  /** The largest of the numbers of overlaps, of their kind. */
  struct Sizes
  {
    void
    include(const Overlap &o)
    {
      potential = std::max(potential, std::abs(o.potential));
      volume    = std::max(volume, std::abs(o.volume));
      fraction  = std::max(fraction, std::abs(o.volume_fraction));
      for (unsigned int c = 0; c < 4; ++c)
        {
          gradient =
            std::max({gradient, norm(o.gradient_a[c]), norm(o.gradient_b[c])});
          weight = std::max(
            {weight, std::abs(o.weights_a[c]), std::abs(o.weights_b[c])});
        }
    }

    double potential = 0, volume = 0, fraction = 0, gradient = 0, weight = 0;
  };

  Overlap
  difference(const Overlap &x, const Overlap &y)
  {
    Overlap d;
    d.potential       = x.potential - y.potential;
    d.volume          = x.volume - y.volume;
    d.volume_fraction = x.volume_fraction - y.volume_fraction;
    for (unsigned int c = 0; c < 4; ++c)
      {
        d.gradient_a[c] = x.gradient_a[c] - y.gradient_a[c];
        d.gradient_b[c] = x.gradient_b[c] - y.gradient_b[c];
        d.weights_a[c]  = x.weights_a[c] - y.weights_a[c];
        d.weights_b[c]  = x.weights_b[c] - y.weights_b[c];
      }
    return d;
  }

  void
  expect_agreement(const PairKind kind, const unsigned int n)
  {
    PairGenerator make(11);
    PairList      list;
    for (unsigned int i = 0; i < n; ++i)
      list.add(make, kind);
    const auto   batch = std::make_unique<OverlapBatch>();
    Sizes        size, error;
    unsigned int n_overlaps = 0;
    for (unsigned int first = 0; first < n; first += OverlapBatch::chunk_size)
      {
        const unsigned int n_here =
          std::min(OverlapBatch::chunk_size, n - first);
        const OverlapOctet *result =
          batch->intersect(list.cells.data(), &list.pairs[first], n_here);
        for (unsigned int i = 0; i < n_here; ++i)
          {
            const CellPair &pair = list.pairs[first + i];
            const Overlap   expected =
              scalar_overlap(corners(list.cells[pair.a]),
                             corners(list.cells[pair.b]));
            const Overlap found =
              overlap_of_lane(result[i / batch_size], i % batch_size);
            n_overlaps += expected.volume > 0;
            EXPECT_EQ(expected.volume > 0, found.volume > 0);
            size.include(expected);
            error.include(difference(expected, found));
          }
      }
    if (kind == PairKind::parted)
      {
        EXPECT_LT(n_overlaps, n / 4);
        return;
      }
    EXPECT_GT(n_overlaps, kind == PairKind::deep ? n / 2 : n - 1);
    EXPECT_LE(error.potential, 1e-12 * size.potential);
    EXPECT_LE(error.volume, 1e-12 * size.volume);
    EXPECT_LE(error.fraction, 1e-12 * size.fraction);
    EXPECT_LE(error.gradient, 1e-12 * size.gradient);
    EXPECT_LE(error.weight, 1e-12 * size.weight);
  }
} // namespace

TEST(OverlapBatch, AgreesWithTheScalarOneWhereDeep)
{
  expect_agreement(PairKind::deep, 5000);
}

// The overlap is as wide as it is deep, 1e-6, and the coordinates of which it is
// computed have rounding errors of 1e-16: of its third power that is 3e-10.
TEST(OverlapBatch, AgreesWithTheScalarOneWhereShallow)
{
  PairGenerator make(3);
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const auto    pair     = make.pair(PairKind::shallow);
      const Overlap expected = scalar_overlap(pair[0], pair[1]),
                    found    = overlap(pair[0], pair[1]);
      ASSERT_GT(expected.volume, 0);
      EXPECT_NEAR(found.volume / expected.volume, 1, 3e-8);
      EXPECT_NEAR(found.potential / expected.potential, 1, 3e-8);
      Sizes size, error;
      size.include(expected);
      error.include(difference(expected, found));
      EXPECT_LE(error.gradient, 3e-8 * size.gradient);
      EXPECT_LE(error.weight, 1e-12);
    }
}

TEST(OverlapBatch, AgreesWithTheScalarOneWhereFacesAreFlatOnEachOther)
{
  expect_agreement(PairKind::pressed, 2000);
}

TEST(OverlapBatch, AgreesWithTheScalarOneOfIdenticalCells)
{
  expect_agreement(PairKind::identical, 2000);
}

TEST(OverlapBatch, AgreesWithTheScalarOneOfTipsInFaces)
{
  expect_agreement(PairKind::tip_in_face, 2000);
}

TEST(OverlapBatch, AgreesWithTheScalarOneWhereApart)
{
  expect_agreement(PairKind::parted, 2000);
}

TEST(PairKernel, GivesAPairTheSameBitsInAnyCompany)
{
  PairGenerator                  make(5);
  const PairList                 list     = pairs_of_all_kinds(make, 100);
  const std::vector<ContactPair> original = contact_pairs(list, make);
  const auto                     kernel   = std::make_unique<PairKernel>();

  std::vector<ContactPair> alone = original;
  std::vector<PairForces>  expected(alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    {
      std::memset(static_cast<void *>(&expected[i]), 0, sizeof(PairForces));
      kernel->compute(list.cells.data(), &alone[i], 1, 1e-6, &expected[i]);
    }

  std::mt19937 random(1);
  for (unsigned int shuffle = 0; shuffle < 20; ++shuffle)
    {
      std::vector<std::size_t> order(original.size());
      for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
      std::shuffle(order.begin(), order.end(), random);
      std::size_t first = 0;
      while (first < order.size())
        {
          const auto n = static_cast<unsigned int>(
            std::min<std::size_t>(1 + random() % PairKernel::chunk_size,
                                  order.size() - first));
          std::vector<ContactPair> chunk;
          std::vector<PairForces>  forces(n);
          std::memset(static_cast<void *>(forces.data()),
                      0,
                      n * sizeof(PairForces));
          for (unsigned int i = 0; i < n; ++i)
            chunk.push_back(original[order[first + i]]);
          kernel->compute(list.cells.data(),
                          chunk.data(),
                          n,
                          1e-6,
                          forces.data());
          for (unsigned int i = 0; i < n; ++i)
            {
              const std::size_t j = order[first + i];
              ASSERT_EQ(
                std::memcmp(&forces[i], &expected[j], sizeof(PairForces)),
                0);
              ASSERT_EQ(std::memcmp(&chunk[i].memory,
                                    &alone[j].memory,
                                    sizeof(ContactMemory)),
                        0);
            }
          first += n;
        }
    }
}

TEST(PairKernel, PassesCellsThatAreDegenerate)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  PairGenerator    make(7);
  for (unsigned int trial = 0; trial < 200; ++trial)
    {
      const auto  pair = make.pair(all_pair_kinds[trial % 5]);
      Tetrahedron flat = pair[1], point = pair[1], tiny = pair[1],
                  unknown = pair[1];
      flat[3]             = .5 * (flat[0] + flat[1]);
      point.fill(pair[0][0]);
      for (Vector3<double> &x : tiny)
        x = pair[0][0] + 1e-9 * (x - pair[0][0]);
      unknown[trial % 4][trial % 3] = nan;
      // None has a volume but for rounding, or one that is known.
      for (const Tetrahedron &other : {flat, point, unknown})
        {
          EXPECT_LT(std::abs(overlap(pair[0], other).volume), 1e-15);
          EXPECT_LT(std::abs(overlap(other, pair[0]).volume), 1e-15);
        }
      const Overlap found    = overlap(pair[0], tiny),
                    expected = scalar_overlap(pair[0], tiny);
      // Its coordinates are as large as its inverse size.
      EXPECT_NEAR(found.volume, expected.volume, 1e-6 * volume(tiny));
    }
}

// A velocity that is not a number must be seen in the forces.
TEST(PairKernel, PassesOnWhatIsNotANumber)
{
  PairGenerator make(9);
  const auto    pair = make.pair(PairKind::identical);
  auto          a = make.moving(pair[0]), b = make.moving(pair[1]);
  for (Vector3<double> &x : b.positions)
    x += Vector3<double>{{.2, .1, 0}};
  a.velocities[1][0] = std::numeric_limits<double>::quiet_NaN();
  for (const ContactConstants &constants :
       {ContactConstants{1e9, 0, .1, 1}, ContactConstants{1e9, .5, 0, 1}})
    {
      ContactMemory memory;
      const auto    forces = pair_forces(a, b, constants, 1e-6, memory);
      EXPECT_TRUE(forces.overlaps);
      EXPECT_TRUE(std::isnan(forces.on_a[0][0]));
      EXPECT_TRUE(std::isnan(forces.on_b[0][0]));
    }
}
