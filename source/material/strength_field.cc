#include <rift/material/strength_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  namespace
  {
    /** Points of the lattice in a correlation length. */
    constexpr double points_per_length = 2;

    /** Radius of the kernel (1 - r^2)^3 in correlation lengths: at a distance of
     * one length the correlation is 1/e. */
    constexpr double radius_per_length = 1.525;
  } // namespace

  std::uint64_t
  scramble(std::uint64_t x)
  {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

  double
  unit_number(const std::uint64_t bits)
  {
    return (static_cast<double>(bits >> 11) + .5) / (1ull << 53);
  }

  double
  weibull_factor(const double u, const double modulus)
  {
    const double below_one =
      std::min(u, 1 - std::numeric_limits<double>::epsilon() / 2);
    return std::pow(-std::log(below_one), 1 / modulus) /
           std::tgamma(1 + 1 / modulus);
  }

  StrengthField::StrengthField(const unsigned int seed,
                               const double       correlation_length,
                               const double       weibull_modulus)
    : seed_bits(scramble(seed))
    , spacing(correlation_length / points_per_length)
    , modulus(weibull_modulus)
  {
  }

  double
  StrengthField::lattice_value(const std::array<std::int64_t, 3> &point) const
  {
    std::uint64_t bits = seed_bits;
    for (const std::int64_t index : point)
      bits = scramble(bits ^ static_cast<std::uint64_t>(index));
    // Box and Muller.
    return std::sqrt(-2 * std::log(unit_number(bits))) *
           std::cos(2 * M_PI * unit_number(scramble(bits)));
  }

  double
  StrengthField::normal_value(const Vector3<double> &place) const
  {
    constexpr double            radius = radius_per_length * points_per_length;
    const Vector3<double>       x      = (1 / spacing) * place;
    std::array<std::int64_t, 3> first, last, point;
    for (unsigned int d = 0; d < 3; ++d)
      {
        first[d] = static_cast<std::int64_t>(std::ceil(x[d] - radius));
        last[d]  = static_cast<std::int64_t>(std::floor(x[d] + radius));
      }
    const auto squared_distance = [&](const unsigned int d) {
      const double distance = (static_cast<double>(point[d]) - x[d]) / radius;
      return distance * distance;
    };
    double sum = 0, sum_of_squares = 0;
    for (point[0] = first[0]; point[0] <= last[0]; ++point[0])
      for (point[1] = first[1]; point[1] <= last[1]; ++point[1])
        for (point[2] = first[2]; point[2] <= last[2]; ++point[2])
          {
            const double base = 1 - squared_distance(0) - squared_distance(1) -
                                squared_distance(2);
            if (base <= 0)
              continue;
            const double weight = base * base * base;
            sum += weight * lattice_value(point);
            sum_of_squares += weight * weight;
          }
    return sum / std::sqrt(sum_of_squares);
  }

  double
  StrengthField::factor(const Vector3<double> &place) const
  {
    return weibull_factor(std::erfc(normal_value(place) / M_SQRT2) / 2,
                          modulus);
  }
} // namespace rift
