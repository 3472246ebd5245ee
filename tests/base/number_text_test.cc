#include <rift/base/number_text.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

using namespace rift;

TEST(NumberText, IsShort)
{
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(to_text(0), "0");
  EXPECT_EQ(to_text(-2.5e-7), "-2.5e-07");
  EXPECT_EQ(to_text(std::nan("")), "nan");
}

TEST(NumberText, KeepsEveryBit)
{
  std::mt19937_64 random(1);
  for (unsigned int i = 0; i < 10000; ++i)
    {
      const std::uint64_t bits = random();
      double              value, again = 0;
      std::memcpy(&value, &bits, 8);
      if (!std::isfinite(value))
        continue;
      ASSERT_TRUE(from_text(to_text(value), again));
      ASSERT_EQ(std::memcmp(&value, &again, 8), 0) << to_text(value);
    }
}

TEST(NumberText, ReadsWhatPeopleWrite)
{
  double value = 0;
  EXPECT_TRUE(from_text(" +1.5E-3\r", value));
  EXPECT_EQ(value, 1.5e-3);
  EXPECT_TRUE(from_text(".5", value));
  EXPECT_EQ(value, 0.5);
}

TEST(NumberText, RefusesTheRest)
{
  double value = 7;
  for (const char *text :
       {"", " ", "+", "-", "+-1", "1,5", "2 mm", "1e", "0x10", "1d5", "1e999"})
    EXPECT_FALSE(from_text(text, value)) << text;
  EXPECT_EQ(value, 7);
}
