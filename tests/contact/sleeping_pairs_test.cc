// Pairs sleep until they may have met.

#include <rift/contact/sleeping_pairs.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

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
