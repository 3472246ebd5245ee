#ifndef rift_material_strength_field_h
#define rift_material_strength_field_h

#include <rift/base/vector3.h>

#include <array>
#include <cstdint>

namespace rift
{
  /** Scrambles the bits of a number (the finaliser of splitmix64). */
  std::uint64_t
  scramble(std::uint64_t x);

  /** A number in (0, 1] from random bits. */
  double
  unit_number(std::uint64_t bits);

  /**
   * A factor of mean 1 with the distribution of Weibull, greater than zero
   * (doc/theory.md, section 2); it falls as u grows.
   *
   * @param u uniformly distributed in (0, 1].
   */
  double
  weibull_factor(double u, double modulus);

  /**
   * A random field of strength: factors of mean 1 with the distribution of
   * Weibull at each place, which are alike at places that are closer together
   * than the correlation length (doc/theory.md, section 13). The field is a
   * function of the place and the seed alone.
   */
  class StrengthField
  {
  public:
    /** @param correlation_length greater than zero, m.
     * @param weibull_modulus greater than zero. */
    StrengthField(unsigned int seed,
                  double       correlation_length,
                  double       weibull_modulus);

    /** The field of normally distributed numbers, of mean 0 and variance 1, that
     * the factors are made of.
     * @param place in the undeformed body, m. */
    double
    normal_value(const Vector3<double> &place) const;

    /** Factor of the strength at a place in the undeformed body, m. */
    double
    factor(const Vector3<double> &place) const;

  private:
    /** A normally distributed number for each point of the lattice. */
    double
    lattice_value(const std::array<std::int64_t, 3> &point) const;

    const std::uint64_t seed_bits;

    /** Distance of neighbouring points of the lattice, m. */
    const double spacing;

    const double modulus;
  };
} // namespace rift

#endif
