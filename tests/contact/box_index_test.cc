// The broad phase against all boxes one by one.

#include <rift/contact/box_index.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace rift;

namespace
{
  constexpr int any_level = std::numeric_limits<int>::min();

  std::vector<std::uint32_t>
  brute_force(const std::vector<Box> &boxes, const Box &box)
  {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      if (boxes_overlap(boxes[i], box))
        numbers.push_back(i);
    return numbers;
  }

  /** Ascending. */
  std::vector<std::uint32_t>
  find(const BoxIndex &index, const Box &box)
  {
    std::vector<std::uint32_t> numbers;
    index.find(box, any_level, numbers);
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }

  BoxIndex
  index_of(const std::vector<Box> &boxes)
  {
    BoxIndex index;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      index.put(i, boxes[i]);
    return index;
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

  /** Sizes over up to three orders of magnitude, some of them flat. */
  Box
  random_box(std::mt19937 &engine, const double grading)
  {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double size = std::pow(10., grading * (uniform(engine) - 1) / 4);
    Box          box;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const double centre = uniform(engine);
        const double half   = .5 * size * std::max(0., uniform(engine) + .5);
        box.lower[d]        = centre - half;
        box.upper[d]        = centre + half;
      }
    return box;
  }
} // namespace

TEST(BoxIndex, MissesNoBoxInRandomStates)
{
  std::mt19937                           engine(1);
  std::uniform_real_distribution<double> uniform(0, 6);
  std::size_t                            n_found = 0;
  for (unsigned int state = 0; state < 20000; ++state)
    {
      const double     grading = uniform(engine);
      std::vector<Box> boxes(2 + state % 12);
      for (Box &box : boxes)
        box = random_box(engine, grading);
      BoxIndex index = index_of(boxes);
      for (unsigned int round = 0; round < 3; ++round)
        {
          for (const Box &box : boxes)
            {
              const auto expected = brute_force(boxes, box);
              n_found += expected.size();
              ASSERT_EQ(find(index, box), expected) << state;
            }
          // Boxes move and grow.
          for (std::uint32_t i = 0; i < boxes.size(); ++i)
            if (engine() % 2 == 0)
              index.put(i, boxes[i] = random_box(engine, grading));
        }
    }
  EXPECT_GT(n_found, 500000U);
}

TEST(BoxIndex, FindsBoxesThatJustTouch)
{
  for (const double size : {1., .1, 3e-7, 1e9})
    {
      // Sums of an edge length differ by rounding: compare with the same test.
      const std::vector<Box> boxes = lattice(6, size);
      const BoxIndex         index = index_of(boxes);
      for (const Box &box : boxes)
        ASSERT_EQ(find(index, box), brute_force(boxes, box));
    }
  // Each inner box of a lattice touches 26 others and itself.
  const std::vector<Box> boxes = lattice(6, .5);
  EXPECT_EQ(find(index_of(boxes), boxes[43]).size(), 27U);
}

TEST(BoxIndex, KnowsOneAmongManySmallOnes)
{
  std::vector<Box> boxes = lattice(12, 1. / 12);
  boxes.push_back({{{-1e6, -1, -1}}, {{1e6, 2, 2}}});
  boxes.push_back({{{.5, .5, .5}}, {{.5, .5, .5}}});
  const BoxIndex index = index_of(boxes);
  for (const Box &box : boxes)
    ASSERT_EQ(find(index, box), brute_force(boxes, box));
}

TEST(BoxIndex, PassesOverSmallerBoxesThanWanted)
{
  std::mt19937     engine(2);
  std::vector<Box> boxes(200);
  for (Box &box : boxes)
    box = random_box(engine, 6);
  const BoxIndex index = index_of(boxes);
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    {
      std::vector<std::uint32_t> expected, found;
      for (const std::uint32_t j : brute_force(boxes, boxes[i]))
        if (index.level(j) >= index.level(i))
          expected.push_back(j);
      index.find(boxes[i], index.level(i), found);
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);
    }
}

TEST(BoxIndex, ForgetsWhatIsRemoved)
{
  const std::vector<Box> boxes = lattice(6, .5);
  BoxIndex               index = index_of(boxes);
  index.remove(43);
  EXPECT_EQ(find(index, boxes[43]).size(), 26U);
  index.remove(43);
  EXPECT_EQ(find(index, boxes[43]).size(), 26U);
  index.put(43, boxes[43]);
  EXPECT_EQ(find(index, boxes[43]).size(), 27U);
  index.clear();
  EXPECT_TRUE(find(index, boxes[43]).empty());
}

TEST(BoxIndex, TakesBoxesThatAreFarAway)
{
  const std::vector<Box> boxes = {{{{1e300, 0, 0}}, {{2e300, 1, 1}}},
                                  {{{-1e18, 0, 0}}, {{-1e18, 1e-3, 1e-3}}},
                                  {{{0, 0, 0}}, {{1, 1, 1}}}};
  const BoxIndex         index = index_of(boxes);
  for (const Box &box : boxes)
    EXPECT_EQ(find(index, box), brute_force(boxes, box));
}
