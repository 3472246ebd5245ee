#ifndef rift_cohesive_laws_softening_h
#define rift_cohesive_laws_softening_h

#include <rift/base/simd.h>

#include <array>
#include <cmath>

namespace rift
{
  /**
   * The softening function f(D) of Munjiza (The Combined Finite-Discrete
   * Element Method, Wiley 2004, eq. 7.12): the share of the strength that is
   * left at damage D, from f(0) = 1 to f(1) = 0 (doc/theory.md, eq. 13).
   *
   * In the loops over Gauss points it is evaluated as a Chebyshev series,
   * which a SIMD vector can follow; the two differ by less than 1e-12.
   */
  class Softening
  {
  public:
    /** Area below f from 0 to 1: the separation over which a mode softens is
     * its fracture energy over (this times the strength). */
    static constexpr double integral = 0.386307294744;

    /** No slope of f is steeper than this (at D = 0.145). */
    static constexpr double steepest_slope = 2.0402;

    /** The formula itself. */
    static double
    exact(const double damage)
    {
      constexpr double a = .63, b = 1.8, c = 6;
      return (1 - (a + b - 1) / (a + b) *
                    std::exp(damage * (a + c * b) / ((a + b) * (1 - a - b)))) *
             (a * (1 - damage) + b * std::pow(1 - damage, c));
    }

    /** Computes the series from the formula. */
    Softening()
    {
      for (unsigned int k = 0; k < n_terms; ++k)
        {
          value_terms[k] = 0;
          for (unsigned int i = 0; i < n_terms; ++i)
            {
              const double angle = M_PI * (i + .5) / n_terms;
              value_terms[k] += (k == 0 ? 1. : 2.) / n_terms *
                                std::cos(k * angle) *
                                exact(.5 + .5 * std::cos(angle));
            }
        }
      // Coefficients of the derivative by recurrence; the last factor is that
      // of the interval's length.
      std::array<double, n_terms + 2> slope{};
      for (unsigned int k = n_terms - 1; k > 0; --k)
        slope[k - 1] = slope[k + 1] + 2 * k * value_terms[k];
      slope[0] /= 2;
      for (unsigned int k = 0; k < n_terms; ++k)
        slope_terms[k] = 2 * slope[k];
    }

    /** f(D) for D in [0, 1]. */
    template <typename Number>
    Number
    value(const Number &damage) const
    {
      return sum(value_terms, damage);
    }

    /** f'(D) for D in [0, 1]. */
    template <typename Number>
    Number
    slope(const Number &damage) const
    {
      return sum(slope_terms, damage);
    }

  private:
    static constexpr unsigned int n_terms = 18;
    using Terms                           = std::array<double, n_terms>;

    /** Clenshaw's summation of a Chebyshev series on [0, 1]. */
    template <typename Number>
    static Number
    sum(const Terms &terms, const Number &damage)
    {
      const Number z = 2. * damage - 1.;
      Number       b1{}, b2{};
      for (unsigned int k = n_terms - 1; k > 0; --k)
        {
          const Number b = (2. * z) * b1 - b2 + terms[k];
          b2             = b1;
          b1             = b;
        }
      return z * b1 - b2 + terms[0];
    }

    Terms value_terms, slope_terms;
  };
} // namespace rift

#endif
