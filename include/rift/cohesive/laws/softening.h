#ifndef rift_cohesive_laws_softening_h
#define rift_cohesive_laws_softening_h

#include <rift/base/simd.h>

#include <array>
#include <cmath>
#include <vector>

namespace rift
{
  /**
   * The softening function f(D) of Munjiza (The Combined Finite-Discrete
   * Element Method, Wiley 2004, eq. 7.12): the share of the strength that is
   * left at damage D, from f(0) = 1 to f(1) = 0 (doc/theory.md, eq. 13).
   *
   * In the loops over Gauss points it is read from a table of cubics, which a
   * SIMD vector can follow; it differs from the formula by less than 2e-10.
   */
  class Softening
  {
  public:
    /** Area below f from 0 to 1: the separation over which a mode softens is
     * its fracture energy over (this times the strength). */
    static constexpr double integral = 0.386307294744;

    /** The formula itself. */
    static double
    exact(const double damage)
    {
      return (1 - (a + b - 1) / (a + b) * std::exp(decay * damage)) *
             (a * (1 - damage) + b * std::pow(1 - damage, c));
    }

    /** The derivative of the formula. */
    static double
    exact_slope(const double damage)
    {
      const double rise = (a + b - 1) / (a + b) * std::exp(decay * damage);
      return -decay * rise * (a * (1 - damage) + b * std::pow(1 - damage, c)) -
             (1 - rise) * (a + b * c * std::pow(1 - damage, c - 1));
    }

    /** Computes the table: the cubic that has the values and slopes of the
     * formula at both ends of each interval. */
    Softening()
      : table(n_intervals)
    {
      for (unsigned int i = 0; i < n_intervals; ++i)
        {
          const double left = i * width, right = (i + 1) * width;
          const double value = exact(left), slope = width * exact_slope(left);
          const double rise      = exact(right) - value - slope;
          const double slope_end = width * exact_slope(right) - slope;
          table[i].v[0]          = value;
          table[i].v[1]          = slope;
          table[i].v[2]          = 3 * rise - slope_end;
          table[i].v[3]          = slope_end - 2 * rise;
        }
    }

    /** f(D), for D in [0, 1]. */
    template <typename Number>
    Number
    operator()(const Number &damage) const
    {
      const Number scaled = damage * (1. / width);
      Number       start;
      const auto   p = cubic(scaled, start);
      const Number x = scaled - start;
      return p[0] + x * (p[1] + x * (p[2] + x * p[3]));
    }

  private:
    static constexpr unsigned int n_intervals = 512;
    static constexpr double       width       = 1. / n_intervals;

    /** Fitted to concrete and used for rock for want of better data. */
    static constexpr double a = .63, b = 1.8, c = 6;
    static constexpr double decay = (a + c * b) / ((a + b) * (1 - a - b));

    static std::uint32_t
    interval(const double scaled)
    {
      const auto i = static_cast<std::uint32_t>(scaled);
      return i < n_intervals ? i : n_intervals - 1;
    }

    /** Coefficients of the cubic at a place, and where its interval starts. */
    std::array<double, 4>
    cubic(const double scaled, double &start) const
    {
      const std::uint32_t i = interval(scaled);
      start                 = i;
      return {{table[i][0], table[i][1], table[i][2], table[i][3]}};
    }

    std::array<Simd, 4>
    cubic(const Simd &scaled, Simd &start) const
    {
      std::array<std::uint32_t, batch_size> intervals;
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        {
          intervals[lane] = interval(scaled[lane]);
          start[lane]     = intervals[lane];
        }
      return gather_rows(table.data(), intervals.data());
    }

    std::vector<NodalVector> table;
  };
} // namespace rift

#endif
