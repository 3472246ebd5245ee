// When cells are divided anew.

#include <rift/app/run_record.h>

#include <gtest/gtest.h>

using namespace rift;

TEST(DivisionPolicy, WaitsLongerAfterEachDivisionThatDoesNotHelp)
{
  DivisionPolicy            policy;
  std::vector<unsigned int> divided;
  for (unsigned int checkpoint = 0; checkpoint < 16; ++checkpoint)
    if (policy.divides_anew(true))
      divided.push_back(checkpoint);
  EXPECT_EQ(divided, (std::vector<unsigned int>{0, 2, 6, 14}));
}

TEST(DivisionPolicy, ForgetsWhenTheRanksHaveEqualWork)
{
  DivisionPolicy policy;
  EXPECT_FALSE(policy.divides_anew(false));
  EXPECT_TRUE(policy.divides_anew(true));
  EXPECT_FALSE(policy.divides_anew(true));
  EXPECT_FALSE(policy.divides_anew(false));
  EXPECT_TRUE(policy.divides_anew(true));
  EXPECT_FALSE(policy.divides_anew(true));
}
