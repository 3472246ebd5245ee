#ifndef rift_base_exact_sum_h
#define rift_base_exact_sum_h

#include <rift/base/communicator.h>

#include <array>
#include <cstdint>
#include <vector>

namespace rift
{
  /**
   * A sum of doubles without rounding: the same whatever the order of its
   * terms and however they are spread over ranks. Rounded once, when it is
   * read. Costs about three nanoseconds per term and half a kilobyte.
   *
   * A fixed-point number that covers the whole range of a double, in digits
   * of 32 bits with room for carries in 64.
   */
  class ExactSum
  {
  public:
    /** Adds a term. A term that is not finite makes the sum not a number. */
    void
    add(double term);

    /** Adds the terms of another sum. */
    void
    add(const ExactSum &other);

    /**
     * The sum, rounded to the nearest double; of two equally near, to the one
     * whose last bit is zero. Infinite if it is out of range.
     */
    double
    value() const;

    /** Replaces each sum by its total over all ranks. Collective. */
    static void
    sum_over_ranks(const std::vector<ExactSum *> &sums,
                   const Communicator            &communicator);

    /** Digits of 32 bits, over the whole range of a double. */
    static constexpr std::size_t n_digits = 68;

    /** The digits, the smallest first, and the number of terms that are not
     * finite. */
    using Digits = std::array<std::int64_t, n_digits + 1>;

    /** For checkpoints: equal sums have equal digits. */
    Digits
    digits() const;

    /** The sum of which digits() has been stored. */
    static ExactSum
    from_digits(const Digits &digits);

  private:
    /** Makes all digits but the last positive numbers of 32 bits. */
    void
    carry();

    /** To be called after each addition to the digits. */
    void
    count_term();

    Digits        data{};
    std::uint32_t n_terms = 0;
  };
} // namespace rift

#endif
