#include <rift/base/check.h>
#include <rift/base/disjoint_sets.h>
#include <rift/base/exact_sum.h>

#include <gtest/gtest.h>

namespace
{
  /** The truth of a number, and how often it has been asked for. */
  bool
  is_positive(const int number, int &n_calls)
  {
    ++n_calls;
    return number > 0;
  }
} // namespace

TEST(Check, PassesWhatIsTrue)
{
  int n_calls = 0;
  rift_check(is_positive(1, n_calls));
#ifdef RIFT_CHECKED
  EXPECT_EQ(n_calls, 1);
#else
  EXPECT_EQ(n_calls, 0);
#endif
}

#ifdef RIFT_CHECKED

TEST(CheckDeathTest, EndsTheProgramWhereSomethingIsFalse)
{
  int n_calls = 0;
  EXPECT_DEATH(rift_check(is_positive(-1, n_calls)),
               "base/check_test.cc:[0-9]+: .*"
               "rift_check\\(is_positive\\(-1, n_calls\\)\\) failed");
}

// The definition reaches the headers and the library.
TEST(CheckDeathTest, IsOnInHeadersAndInTheLibrary)
{
  rift::DisjointSets sets(3);
  EXPECT_DEATH(sets.find(3), "disjoint_sets.h:[0-9]+: find: .*parent");
  rift::ExactSum::Digits digits{};
  digits[0] = -1;
  EXPECT_DEATH(rift::ExactSum::from_digits(digits),
               "exact_sum.cc:[0-9]+: from_digits: .*is_carried");
}

#else

TEST(Check, IsNotEvaluatedWithoutChecks)
{
  int n_calls = 0;
  rift_check(is_positive(-1, n_calls));
  EXPECT_EQ(n_calls, 0);
}

#endif
