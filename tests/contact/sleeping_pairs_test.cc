// Pairs sleep until they may have met.

#include <rift/contact/sleeping_pairs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <set>

using namespace rift;

TEST(SleepingPairs, WakeWhenThePathHasGrownSoFar)
{
  std::mt19937                           engine(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  SleepingPairs                          pairs;
  std::map<std::uint32_t, double>        wakes;
  std::uint32_t                          n = 0;
  for (unsigned int step = 0; step < 200; ++step)
    {
      const double path = .01 * step;
      for (unsigned int i = 0; i < 20; ++i, ++n)
        {
          wakes[n] = path + uniform(engine);
          pairs.add({{n, n + 1}, static_cast<std::uint8_t>(n % 251)}, wakes[n]);
        }
      for (const auto &pair : pairs.wake(path))
        {
          ASSERT_EQ(wakes.count(pair.cells.a), 1u);
          EXPECT_EQ(pair.cells.b, pair.cells.a + 1);
          EXPECT_EQ(pair.axis, pair.cells.a % 251);
          EXPECT_LE(wakes[pair.cells.a], path);
          wakes.erase(pair.cells.a);
        }
      ASSERT_EQ(pairs.size(), wakes.size());
      EXPECT_TRUE(std::all_of(wakes.begin(), wakes.end(), [&](const auto &w) {
        return w.second > path;
      }));
    }
}

TEST(SleepingPairs, FollowTheirCells)
{
  SleepingPairs pairs;
  pairs.add({{1, 3}, 7}, 1);
  pairs.renumber({9, 0, 9, 2});
  const auto woken = pairs.wake(2);
  ASSERT_EQ(woken.size(), 1u);
  EXPECT_EQ(woken[0].cells.a, 0u);
  EXPECT_EQ(woken[0].cells.b, 2u);
  EXPECT_EQ(woken[0].axis, 7);
}

TEST(SleepingPairs, WakeHoweverThePathGrows)
{
  // Nothing moves, then slower and faster, then something without bounds.
  const double          infinity = std::numeric_limits<double>::infinity();
  SleepingPairs         pairs;
  std::multiset<double> wakes;
  std::uint32_t         n = 0;
  for (const double path :
       {0., 0., 1e-9, 1e-3, 1e-3, .5, .6, 70., 71., 71.1, 1e4, infinity})
    {
      for (const double sleep :
           {-.2, 0., 1e-12, 1e-4, .3, 1., 40., 1e3, 1e5, 1e9})
        {
          pairs.add({{n, n + 1}, 0}, path + sleep);
          wakes.insert(path + sleep);
          ++n;
        }
      const auto last_awake = wakes.upper_bound(path);
      EXPECT_EQ(static_cast<std::ptrdiff_t>(pairs.wake(path).size()),
                std::distance(wakes.begin(), last_awake));
      wakes.erase(wakes.begin(), last_awake);
      EXPECT_EQ(pairs.size(), wakes.size());
    }
  EXPECT_EQ(pairs.size(), 0u);
}
