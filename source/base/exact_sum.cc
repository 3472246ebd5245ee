#include <rift/base/check.h>
#include <rift/base/exact_sum.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

// Digit i stands for data[i] * 2^(32 i - 1074): the lowest bit of digit 0 is
// the smallest double.
namespace rift
{
  namespace
  {
    constexpr unsigned int  mantissa_bits   = 52;
    constexpr std::uint64_t hidden_bit      = std::uint64_t{1} << mantissa_bits;
    constexpr int           lowest_exponent = -1074;
    constexpr std::uint64_t low_half        = 0xffffffff;

    /** A term adds less than 2^52 to a digit. */
    constexpr std::uint32_t most_terms = 1024;

    /** Whether all digits but the last are positive numbers of 32 bits. */
    bool
    is_carried(const ExactSum::Digits &digits)
    {
      return std::all_of(digits.begin(),
                         digits.begin() + (ExactSum::n_digits - 1),
                         [](const std::int64_t digit) {
                           return digit >= 0 && (digit >> 32) == 0;
                         });
    }

    /** Whether all ranks come with as many sums. Collective. */
    bool
    is_same_on_ranks(const std::size_t n_sums, const Communicator &communicator)
    {
      const auto n = static_cast<double>(n_sums);
      return communicator.max(n) == n && communicator.max(-n) == -n;
    }
  } // namespace

  void
  ExactSum::add(const double term)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &term, sizeof(bits));
    const auto exponent =
      static_cast<unsigned int>(bits >> mantissa_bits) & 0x7ff;
    if (exponent == 0x7ff)
      {
        ++data[n_digits];
        return;
      }
    // Denormal numbers have the exponent of the smallest others.
    const std::uint64_t mantissa =
      (bits & (hidden_bit - 1)) | (exponent > 0 ? hidden_bit : 0);
    const unsigned int position = exponent > 0 ? exponent - 1 : 0;
    const unsigned int i = position / 32, shift = position % 32;
    const auto low  = static_cast<std::int64_t>((mantissa << shift) & low_half);
    const auto high = static_cast<std::int64_t>(mantissa >> (32 - shift));
    // Minus one or zero: (x ^ sign) - sign is minus x or x.
    const std::int64_t sign = -static_cast<std::int64_t>(bits >> 63);
    data[i] += (low ^ sign) - sign;
    data[i + 1] += (high ^ sign) - sign;
    count_term();
  }

  void
  ExactSum::add(const ExactSum &other)
  {
    const Digits more = other.digits();
    for (std::size_t i = 0; i < data.size(); ++i)
      data[i] += more[i];
    count_term();
  }

  void
  ExactSum::count_term()
  {
    if (++n_terms == most_terms)
      carry();
  }

  void
  ExactSum::carry()
  {
    std::int64_t carried = 0;
    for (std::size_t i = 0; i + 1 < n_digits; ++i)
      {
        const std::int64_t digit = data[i] + carried;
        carried                  = digit >> 32;
        data[i]                  = digit & low_half;
      }
    data[n_digits - 1] += carried;
    n_terms = 0;
    rift_check(is_carried(data));
  }

  double
  ExactSum::value() const
  {
    if (data[n_digits] != 0)
      return std::numeric_limits<double>::quiet_NaN();
    ExactSum magnitude = *this;
    magnitude.carry();
    const bool is_negative = magnitude.data[n_digits - 1] < 0;
    if (is_negative)
      {
        for (std::int64_t &digit : magnitude.data)
          digit = -digit;
        magnitude.carry();
      }

    // The last of the 65 or more bits that are rounded stands for all below.
    const Digits &of  = magnitude.data;
    std::size_t   top = n_digits - 1;
    while (top > 2 && of[top] == 0)
      --top;
    unsigned __int128 bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 32 | static_cast<std::uint64_t>(of[top - i]);
    if (std::any_of(of.begin(), of.begin() + (top - 2), [](const auto digit) {
          return digit != 0;
        }))
      bits |= 1;
    const double result =
      std::ldexp(static_cast<double>(bits),
                 32 * static_cast<int>(top - 2) + lowest_exponent);
    return is_negative ? -result : result;
  }

  ExactSum::Digits
  ExactSum::digits() const
  {
    ExactSum copy = *this;
    copy.carry();
    return copy.data;
  }

  ExactSum
  ExactSum::from_digits(const Digits &digits)
  {
    rift_check(is_carried(digits));
    ExactSum result;
    result.data = digits;
    return result;
  }

  void
  ExactSum::sum_over_ranks(const std::vector<ExactSum *> &sums,
                           const Communicator            &communicator)
  {
    // Digits that have been carried can be added 2^31 times.
    std::vector<std::int64_t> all;
    for (const ExactSum *sum : sums)
      {
        const Digits digits = sum->digits();
        all.insert(all.end(), digits.begin(), digits.end());
      }
    rift_check(is_same_on_ranks(sums.size(), communicator));
    communicator.sum(all);
    auto next = all.begin();
    for (ExactSum *sum : sums)
      {
        std::copy(next, next + n_digits + 1, sum->data.begin());
        sum->carry();
        next += n_digits + 1;
      }
  }
} // namespace rift
