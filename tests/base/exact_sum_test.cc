// Sums without rounding, against integers of 128 bits.

#include <rift/base/exact_sum.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace rift;

namespace
{
  using Limits = std::numeric_limits<double>;
  using Random = std::mt19937_64;

  ExactSum
  sum_of(const std::vector<double> &terms)
  {
    ExactSum sum;
    for (const double term : terms)
      sum.add(term);
    return sum;
  }

  /** Any double but those that are not finite, all bits being random. */
  double
  random_double(Random &random)
  {
    const double sign = random() % 2 == 0 ? 1 : -1;
    return sign * std::ldexp(static_cast<double>(random() >> 11),
                             static_cast<int>(random() % 2046) - 1074);
  }

  std::vector<double>
  random_doubles(Random &random, const std::size_t n)
  {
    std::vector<double> result(n);
    for (double &x : result)
      x = random_double(random);
    return result;
  }
} // namespace

TEST(ExactSum, IsTheNearestDouble)
{
  // Terms are integers times one power of two: their sum is an integer of up
  // to 128 bits, whose conversion to double rounds to nearest even.
  Random random(1);
  for (unsigned int n = 0; n < 3000; ++n)
    {
      const int  exponent = static_cast<int>(random() % 2040) - 1074;
      const auto n_terms  = 1 + random() % 40;
      const auto n_bits   = 1 + random() % 53;
      const auto n_shifts = 1 + random() % 60;
      ExactSum   sum;
      __int128   expected = 0;
      for (std::size_t i = 0; i < n_terms; ++i)
        {
          const auto mantissa =
            static_cast<std::int64_t>(random() >> (64 - n_bits)) *
            (random() % 2 == 0 ? 1 : -1);
          const auto   shift = static_cast<int>(random() % n_shifts);
          const double term =
            std::ldexp(static_cast<double>(mantissa), exponent + shift);
          if (std::isinf(term))
            continue;
          sum.add(term);
          expected += mantissa * (static_cast<__int128>(1) << shift);
        }
      EXPECT_EQ(sum.value(),
                std::ldexp(static_cast<double>(expected), exponent))
        << exponent;
    }
}

TEST(ExactSum, RoundsToNearestEven)
{
  const double big = std::ldexp(1, 53), tiny = Limits::denorm_min();
  EXPECT_EQ(sum_of({big, 1}).value(), big);
  EXPECT_EQ(sum_of({big, 1, tiny}).value(), big + 2);
  EXPECT_EQ(sum_of({big, 1, -tiny}).value(), big);
  EXPECT_EQ(sum_of({big, 2, 1}).value(), big + 4);
  EXPECT_EQ(sum_of({big, 2, 1, -tiny}).value(), big + 2);
  EXPECT_EQ(sum_of({-big, -1, -tiny}).value(), -big - 2);
  // A mantissa of ones alone goes to the next power of two.
  EXPECT_EQ(sum_of({big, big - 1, .5}).value(), 2 * big);
}

TEST(ExactSum, SingleTerms)
{
  Random random(2);
  for (const double term : random_doubles(random, 100000))
    ASSERT_EQ(sum_of({term}).value(), term);
  for (const double term : {0., 1., Limits::min(), Limits::denorm_min()})
    {
      EXPECT_EQ(sum_of({term}).value(), term);
      EXPECT_EQ(sum_of({-term}).value(), -term);
    }
  EXPECT_EQ(sum_of({Limits::max()}).value(), Limits::max());
  EXPECT_EQ(ExactSum().value(), 0);
}

TEST(ExactSum, SmallestNumbers)
{
  const double tiny = Limits::denorm_min();
  EXPECT_EQ(sum_of({tiny, tiny, tiny}).value(), 3 * tiny);
  EXPECT_EQ(sum_of({Limits::min(), -tiny}).value(), Limits::min() - tiny);
  EXPECT_EQ(sum_of({Limits::min() - tiny, tiny}).value(), Limits::min());
}

TEST(ExactSum, GoesOutOfRangeAndComesBack)
{
  const double        largest = Limits::max();
  std::vector<double> terms(5000, largest);
  EXPECT_EQ(sum_of(terms).value(), Limits::infinity());
  for (double &term : terms)
    term = -term;
  EXPECT_EQ(sum_of(terms).value(), -Limits::infinity());
  terms.resize(10000, largest);
  EXPECT_EQ(sum_of(terms).value(), 0);
  terms.push_back(Limits::denorm_min());
  EXPECT_EQ(sum_of(terms).value(), Limits::denorm_min());

  // Half of the last bit of the largest number makes it infinite, less not.
  const double half = std::ldexp(1, 970);
  EXPECT_EQ(sum_of({largest, half}).value(), Limits::infinity());
  EXPECT_EQ(sum_of({largest, half, -1}).value(), largest);
}

TEST(ExactSum, HoldsMillionsOfTerms)
{
  // The mantissa of ones at every place within a digit.
  for (int exponent = 0; exponent < 33; ++exponent)
    {
      const double  term = std::ldexp(1 - Limits::epsilon() / 2, 53 + exponent);
      constexpr int n    = 300000;
      ExactSum      sum;
      for (int i = 0; i < n; ++i)
        sum.add(i % 3 == 0 ? -term : term);
      EXPECT_EQ(sum.value(), n / 3 * term);
    }
  ExactSum sum;
  for (int i = 0; i < 10000000; ++i)
    sum.add(.1);
  // Rounded at each term, it would be wrong by 1.6e-4.
  EXPECT_EQ(sum.value(), 1e6);
}

TEST(ExactSum, DoesNotDependOnTheOrder)
{
  Random random(3);
  for (unsigned int n = 0; n < 50; ++n)
    {
      std::vector<double> terms    = random_doubles(random, 3000);
      const ExactSum      expected = sum_of(terms);
      std::shuffle(terms.begin(), terms.end(), random);
      EXPECT_EQ(sum_of(terms).digits(), expected.digits());

      // All but one cancel.
      const double left = random_double(random);
      terms.push_back(left);
      const std::size_t size = terms.size();
      for (std::size_t i = 0; i + 1 < size; ++i)
        terms.push_back(-terms[i]);
      std::shuffle(terms.begin(), terms.end(), random);
      EXPECT_EQ(sum_of(terms).value(), left);
    }
}

TEST(ExactSum, DoesNotDependOnHowTermsAreDivided)
{
  Random random(4);
  for (unsigned int n = 0; n < 20; ++n)
    {
      const std::vector<double> terms = random_doubles(random, 3000);
      std::vector<ExactSum>     parts(1 + random() % 3000);
      for (const double term : terms)
        parts[random() % parts.size()].add(term);
      ExactSum sum;
      for (const ExactSum &part : parts)
        sum.add(part);
      EXPECT_EQ(sum.digits(), sum_of(terms).digits());
    }
}

TEST(ExactSum, DigitsRoundTrip)
{
  Random     random(5);
  const auto terms = random_doubles(random, 1500);
  ExactSum   sum   = sum_of({terms.begin(), terms.begin() + 700});
  ExactSum   copy  = ExactSum::from_digits(sum.digits());
  EXPECT_EQ(copy.digits(), sum.digits());
  for (auto term = terms.begin() + 700; term != terms.end(); ++term)
    copy.add(*term);
  EXPECT_EQ(copy.digits(), sum_of(terms).digits());
}

TEST(ExactSum, IsNoNumberWhenATermIsNone)
{
  for (const double bad :
       {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
    {
      ExactSum sum = sum_of({1, bad, -1});
      EXPECT_TRUE(std::isnan(sum.value()));
      EXPECT_TRUE(std::isnan(ExactSum::from_digits(sum.digits()).value()));
      ExactSum other = sum_of({2});
      other.add(sum);
      EXPECT_TRUE(std::isnan(other.value()));
    }
  EXPECT_TRUE(
    std::isnan(sum_of({Limits::infinity(), -Limits::infinity()}).value()));
}

TEST(ExactSum, TotalOverRanks)
{
  const Communicator all(MPI_COMM_WORLD);
  Random             random(6);
  for (unsigned int n = 0; n < 20; ++n)
    {
      const auto            terms = random_doubles(random, 3000);
      std::vector<ExactSum> sums(1 + random() % 10), expected(sums.size());
      for (const double term : terms)
        {
          const std::size_t i = random() % sums.size();
          const bool        mine =
            static_cast<int>(random() % all.size()) == all.rank();
          expected[i].add(term);
          if (mine)
            sums[i].add(term);
        }
      // One of them is no number on the last rank.
      expected[0].add(Limits::infinity());
      if (all.rank() == all.size() - 1)
        sums[0].add(Limits::infinity());

      std::vector<ExactSum *> pointers;
      for (ExactSum &sum : sums)
        pointers.push_back(&sum);
      ExactSum::sum_over_ranks(pointers, all);
      for (std::size_t i = 0; i < sums.size(); ++i)
        EXPECT_EQ(sums[i].digits(), expected[i].digits());
      EXPECT_TRUE(std::isnan(sums[0].value()));
    }
}
