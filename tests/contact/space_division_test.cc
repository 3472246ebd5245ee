// Who owns which point of space.

#include <rift/contact/space_division.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace rift;

namespace
{
  constexpr std::uint64_t n_keys = std::uint64_t(1)
                                   << 3 * SpaceDivision::n_levels;
}

TEST(SpaceDivision, FollowsMortonsCurve)
{
  EXPECT_EQ(morton_key({{1, 0, 0}}), 1U);
  EXPECT_EQ(morton_key({{0, 1, 0}}), 2U);
  EXPECT_EQ(morton_key({{0, 0, 1}}), 4U);
  EXPECT_EQ(morton_key({{2, 3, 0}}), 8U + 16U + 2U);
  constexpr std::uint32_t last = (1U << SpaceDivision::n_levels) - 1;
  EXPECT_EQ(morton_key({{last, last, last}}), n_keys - 1);
}

TEST(SpaceDivision, GivesOctantsToRanks)
{
  const Vector3<double> lower{{-3, 1e4, 0}};
  const SpaceDivision   division(lower, 2, {n_keys / 8, n_keys / 2, n_keys});
  const auto            rank = [&](double x, double y, double z) {
    return division.rank_of(lower + Vector3<double>{{x, y, z}});
  };
  EXPECT_EQ(rank(.9, .9, .9), 0);
  EXPECT_EQ(rank(1.1, .9, .9), 1);
  EXPECT_EQ(rank(1.1, 1.1, .9), 1);
  EXPECT_EQ(rank(.1, .1, 1.1), 2);
  // Rank 3 has nothing; what is outside belongs to what is next to it.
  EXPECT_EQ(rank(2, 2, 2), 2);
  EXPECT_EQ(rank(1e300, 1e300, 1e300), 2);
  EXPECT_EQ(rank(-1e300, .5, -1), 0);
  EXPECT_EQ(rank(NAN, NAN, NAN), 0);
  EXPECT_EQ(SpaceDivision().rank_of({{5, 5, 5}}), 0);

  using Ranks    = std::vector<int>;
  const auto box = [&](const Vector3<double> &a, const Vector3<double> &b) {
    return division.ranks_of({lower + a, lower + b});
  };
  EXPECT_EQ(box({{.1, .1, .1}}, {{.9, .9, .9}}), Ranks({0}));
  EXPECT_EQ(box({{.9, .9, .1}}, {{1.1, 1.1, .9}}), Ranks({0, 1}));
  EXPECT_EQ(box({{.9, .9, .9}}, {{1.1, 1.1, 1.1}}), Ranks({0, 1, 2}));
  // From the first octant to the one above it.
  EXPECT_EQ(box({{.1, .1, .9}}, {{.2, .2, 1.1}}), Ranks({0, 2}));
  EXPECT_EQ(box({{-9, -9, -9}}, {{9, 9, 9}}), Ranks({0, 1, 2}));
}

// A pair is found by the owner of a point of both boxes: that rank must know
// them.
TEST(SpaceDivision, KnowsTheOwnersOfAllPointsOfABox)
{
  std::mt19937                           engine(1);
  std::uniform_real_distribution<double> uniform(-.1, 1.1);
  std::size_t                            n_ranks = 0, n_met = 0;
  for (unsigned int state = 0; state < 20000; ++state)
    {
      std::vector<std::uint64_t> first_keys(state % 9);
      for (std::uint64_t &key : first_keys)
        key = static_cast<std::uint64_t>(std::max(0., uniform(engine)) / 1.1 *
                                         n_keys);
      std::sort(first_keys.begin(), first_keys.end());
      const SpaceDivision division({}, 1, first_keys);
      const double        size = std::pow(uniform(engine), 4);
      Box                 box;
      for (unsigned int d = 0; d < 3; ++d)
        {
          box.lower[d] = uniform(engine);
          box.upper[d] = box.lower[d] + size * std::abs(uniform(engine));
        }
      const std::vector<int> ranks = division.ranks_of(box);
      ASSERT_TRUE(std::is_sorted(ranks.begin(), ranks.end()));
      std::set<int> met;
      for (unsigned int i = 0; i < 64; ++i)
        {
          // On a lattice that has the corners.
          Vector3<double> point;
          for (unsigned int d = 0; d < 3; ++d)
            {
              const double share = (i >> 2 * d & 3) / 3.;
              point[d]           = share < 1 ? box.lower[d] +
                                       share * (box.upper[d] - box.lower[d]) :
                                               box.upper[d];
            }
          const int rank = division.rank_of(point);
          ASSERT_TRUE(std::binary_search(ranks.begin(), ranks.end(), rank));
          met.insert(rank);
        }
      n_ranks += ranks.size();
      n_met += met.size();
    }
  // Hardly one too many.
  EXPECT_GT(n_met, 25000U);
  EXPECT_LT(n_ranks, 1.1 * n_met);
}
