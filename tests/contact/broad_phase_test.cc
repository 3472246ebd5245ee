// The broad phase against all pairs one by one.

#include <rift/contact/broad_phase.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace rift;

namespace
{
  std::vector<BoxPair>
  brute_force(const std::vector<Box> &boxes)
  {
    std::vector<BoxPair> pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      for (std::uint32_t j = i + 1; j < boxes.size(); ++j)
        if (boxes_overlap(boxes[i], boxes[j]))
          pairs.push_back({i, j});
    return pairs;
  }

  /** All of them. */
  std::vector<BoxPair>
  find_all(const std::vector<Box> &boxes)
  {
    return *find_touching(boxes, -1, [](const BoxPair &) { return true; });
  }

  /** A unit cube of n^3 boxes that touch their neighbours. */
  std::vector<Box>
  lattice(const unsigned int n, const double size)
  {
    std::vector<Box> boxes;
    for (unsigned int x = 0; x < n; ++x)
      for (unsigned int y = 0; y < n; ++y)
        for (unsigned int z = 0; z < n; ++z)
          boxes.push_back({{{size * x, size * y, size * z}},
                           {{size * (x + 1), size * (y + 1), size * (z + 1)}}});
    return boxes;
  }
} // namespace

TEST(BroadPhase, MissesNoPairInRandomStates)
{
  std::mt19937                           engine(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::size_t                            n_pairs = 0;
  for (unsigned int state = 0; state < 100000; ++state)
    {
      // Boxes of sizes over up to three orders of magnitude, some of them flat.
      const double     grading = 3 + 3 * uniform(engine);
      std::vector<Box> boxes(2 + state % 12);
      for (Box &box : boxes)
        {
          const double size =
            std::pow(10., grading * (uniform(engine) - 1) / 4);
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double centre = uniform(engine);
              const double half =
                .5 * size * std::max(0., uniform(engine) + .5);
              box.lower[d] = centre - half;
              box.upper[d] = centre + half;
            }
        }
      const auto expected = brute_force(boxes);
      n_pairs += expected.size();
      ASSERT_EQ(find_all(boxes), expected) << state;
    }
  EXPECT_GT(n_pairs, 40000U);
}

TEST(BroadPhase, FindsBoxesThatJustTouch)
{
  for (const double size : {1., .1, 3e-7, 1e9})
    {
      // Sums of an edge length differ by rounding: compare with the same test.
      const std::vector<Box> boxes = lattice(6, size);
      const auto             pairs = find_all(boxes);
      EXPECT_EQ(pairs, brute_force(boxes));
    }
  // Each inner box of a lattice touches 26 others.
  const std::vector<Box> boxes  = lattice(6, .5);
  unsigned int           number = 0;
  for (const BoxPair &pair : find_all(boxes))
    number += pair.first == 43 || pair.second == 43;
  EXPECT_EQ(number, 26U);
}

TEST(BroadPhase, KnowsOneAmongManySmallOnes)
{
  std::vector<Box> boxes = lattice(12, 1. / 12);
  boxes.push_back({{{-1, -1, -1}}, {{2, 2, 2}}});
  boxes.push_back({{{.5, .5, .5}}, {{.5, .5, .5}}});
  EXPECT_EQ(find_all(boxes), brute_force(boxes));
}

TEST(BroadPhase, KeepsThePairsThatAreWanted)
{
  const std::vector<Box> boxes  = lattice(6, .5);
  const auto             is_odd = [](const BoxPair &pair) {
    return (pair.first + pair.second) % 2 == 1;
  };
  std::vector<BoxPair> expected;
  for (const BoxPair &pair : brute_force(boxes))
    if (is_odd(pair))
      expected.push_back(pair);
  EXPECT_EQ(find_touching(boxes, 10000, is_odd), expected);
}

TEST(BroadPhase, StopsWhenThereAreTooManyPairs)
{
  const std::vector<Box> boxes(1000, Box{{{0, 0, 0}}, {{1, 1, 1}}});
  std::size_t            n_found = 0;
  const auto             count   = [&](const BoxPair &) {
    ++n_found;
    return false;
  };
  EXPECT_FALSE(find_touching(boxes, 5000, count));
  EXPECT_LT(n_found, 7000U);
  EXPECT_TRUE(find_touching(boxes, 1000 * 999 / 2, count));
  EXPECT_TRUE(find_touching({}, 0, count)->empty());
}
