// When cells are divided anew.

#include <rift/app/run_record.h>

#include <gtest/gtest.h>

using namespace rift;

TEST(RepartitionPolicy, WaitsLongerAfterEachDivisionThatDoesNotHelp)
{
  RepartitionPolicy         policy;
  std::vector<unsigned int> divided;
  for (unsigned int checkpoint = 0; checkpoint < 16; ++checkpoint)
    if (policy.repartitions(true))
      divided.push_back(checkpoint);
  EXPECT_EQ(divided, (std::vector<unsigned int>{0, 2, 6, 14}));
}

TEST(RepartitionPolicy, ForgetsWhenTheRanksHaveEqualWork)
{
  RepartitionPolicy policy;
  EXPECT_FALSE(policy.repartitions(false));
  EXPECT_TRUE(policy.repartitions(true));
  EXPECT_FALSE(policy.repartitions(true));
  EXPECT_FALSE(policy.repartitions(false));
  EXPECT_TRUE(policy.repartitions(true));
  EXPECT_FALSE(policy.repartitions(true));
}
