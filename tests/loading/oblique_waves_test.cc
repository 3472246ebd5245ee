// Packets of plane waves that meet an absorbing boundary at a slant.

#include <rift/loading/absorbing_boundaries.h>
#include <rift/material/wave_speeds.h>
#include <rift/time_integration/central_difference.h>

#include "../support/elastic_body.h"
#include "../support/periodic_box.h"
#include <gtest/gtest.h>

#include <complex>

using namespace rift;
using namespace rift::test;

namespace
{
  using Complex = std::complex<double>;

  MaterialParameters
  rock(const double poissons_ratio = .25)
  {
    MaterialParameters material;
    material.name           = "rock";
    material.density        = 2650;
    material.youngs_modulus = 60e9;
    material.poissons_ratio = poissons_ratio;
    return material;
  }

  /** Compression; shear in the plane of incidence, and across it. */
  enum class Wave
  {
    p,
    sv,
    sh
  };

  double
  speed_of(const Wave wave, const MaterialParameters &m)
  {
    const double mu = m.youngs_modulus / (2 * (1 + m.poissons_ratio));
    const double m_p =
      2 * mu * (1 - m.poissons_ratio) / (1 - 2 * m.poissons_ratio);
    return std::sqrt((wave == Wave::p ? m_p : mu) / m.density);
  }

  /** Amplitude and slowness along x, s/m, of a wave exp(i w (s.x - t)). */
  struct PlaneWave
  {
    /** @param slowness_y along the boundary, s/m.
     * @param sign 1: towards the boundary; -1: away from it, or fading with the
     *   distance. */
    PlaneWave(const double speed,
              const bool   is_p,
              const double slowness_y,
              const double sign)
    {
      const Complex root =
        std::sqrt(Complex(1 / (speed * speed) - slowness_y * slowness_y));
      slowness_x = sign * root;
      amplitude  = {{speed * slowness_x, speed * slowness_y}};
      if (!is_p)
        amplitude = {{-speed * slowness_y, speed * slowness_x}};
    }

    Complex                slowness_x;
    std::array<Complex, 2> amplitude;
  };

  /**
   * Share of the energy of a plane wave that comes back from dashpots rho c_P
   * along and rho c_S across the normal of the boundary, at an angle from it:
   * the amplitudes of reflected P and SV follow from
   *   sigma_xx + rho c_P v_x = 0,  sigma_xy + rho c_S v_y = 0.
   */
  double
  reflected_share(const Wave                wave,
                  const MaterialParameters &material,
                  const double              angle)
  {
    if (wave == Wave::sh)
      return std::pow((1 - std::cos(angle)) / (1 + std::cos(angle)), 2);
    const double c_p = speed_of(Wave::p, material);
    const double c_s = speed_of(Wave::sv, material);
    const double c   = wave == Wave::p ? c_p : c_s;
    const double s_y = std::sin(angle) / c;

    // Tractions and dashpots of unit density, over i w.
    const auto rest = [&](const PlaneWave &w) -> std::array<Complex, 2> {
      const Complex x = w.slowness_x * w.amplitude[0];
      const Complex y = s_y * w.amplitude[1];
      return {
        {c_p * c_p * (x + y) - 2 * c_s * c_s * y - c_p * w.amplitude[0],
         c_s * c_s * (w.slowness_x * w.amplitude[1] + s_y * w.amplitude[0]) -
           c_s * w.amplitude[1]}};
    };
    const PlaneWave incident(c, wave == Wave::p, s_y, 1);
    const PlaneWave p(c_p, true, s_y, -1), s(c_s, false, s_y, -1);
    const auto      of_i = rest(incident), of_p = rest(p), of_s = rest(s);
    const Complex   det = of_p[0] * of_s[1] - of_p[1] * of_s[0];
    const Complex   a_p = (of_s[0] * of_i[1] - of_s[1] * of_i[0]) / det;
    const Complex   a_s = (of_p[1] * of_i[0] - of_p[0] * of_i[1]) / det;
    // Flux of energy along the normal: rho c^2 s_x |a|^2.
    const auto flux = [](const double speed, const PlaneWave &w) {
      return std::abs(speed * speed * w.slowness_x.real());
    };
    return (std::norm(a_p) * flux(c_p, p) + std::norm(a_s) * flux(c_s, s)) /
           flux(c, incident);
  }

  /**
   * Waves exp(i (q x + k y - w t)) whose wave numbers q along the normal are
   * scattered about k, that is about 45 degrees, with amplitudes of a Gaussian.
   */
  struct Packet
  {
    Wave               wave;
    MaterialParameters material = rock();

    /** Along the boundary, m. */
    static constexpr double period = .02;

    static constexpr double k = 2 * M_PI / period, width = .25 * k;

    /** Half of the length of the packet: there the energy is down to 1e-4. */
    static constexpr double reach = 3 / width;

    /** Calls f(q, amplitude) with q from -3 to 3 times the width about k. */
    template <typename Function>
    static void
    for_each(const Function &f)
    {
      for (int i = -60; i <= 60; ++i)
        f(k + .06 * i * width, std::exp(-.5 * std::pow(.06 * i, 2)));
    }

    /** The closed form, as a mean over the energies of the waves. */
    double
    expected_share() const
    {
      double reflected = 0, all = 0;
      for_each([&](const double q, const double amplitude) {
        const double energy = std::pow(amplitude, 2) * (q * q + k * k);
        all += energy;
        reflected += energy * reflected_share(wave, material, std::atan2(k, q));
      });
      return reflected / all;
    }

    /** Displacements and velocities with the centre `reach` before the end. */
    void
    start(State &state, const double length) const
    {
      const double speed = speed_of(wave, material);
      for (NodeIndex node = 0; node < state.n_nodes(); ++node)
        {
          const double x = state.reference[node][0] - (length - reach);
          const double y = state.reference[node][1];
          for_each([&](const double q, const double amplitude) {
            const double          number = std::hypot(q, k);
            const Vector3<double> p =
              wave == Wave::p  ? Vector3<double>{{q / number, k / number, 0}} :
              wave == Wave::sv ? Vector3<double>{{-k / number, q / number, 0}} :
                                 Vector3<double>{{0, 0, 1}};
            const double phase = q * x + k * y, a = 1e-9 * amplitude;
            for (unsigned int d = 0; d < dim; ++d)
              {
                state.displacement[node][d] += a * p[d] * std::cos(phase);
                state.velocity[node][d] +=
                  a * p[d] * speed * number * std::sin(phase);
              }
          });
        }
    }

    double
    energy(const ElasticBody &body, const double time_step) const
    {
      return kinetic_energy(body.topology, body.state, time_step).value() +
             body.force.strain_energy(body.state).value();
    }

    /**
     * Energy in the body when the packet has met the end, over that before.
     *
     * @param n cubes in a period.
     */
    double
    measured_share(const unsigned int n) const
    {
      const double       h      = period / n;
      const unsigned int n_long = std::ceil(2 * reach / h);
      const double       length = n_long * h;
      ElasticBody body(make_periodic_box({n_long, n, 3}, h, material.density),
                       material);
      const auto  stiffness = stiffness_matrix(make_elasticity(material));
      AbsorbingBoundaries boundary(
        body.topology,
        body.discrete.reference,
        {{"end", plane_surface(body.discrete, 0, length)}},
        [&](const std::uint16_t, const Vector3<double> &normal) {
          return impedance(stiffness, material.density, normal);
        });
      State &state = body.state;
      start(state, length);
      const double dt = .7 * body.critical_step();
      // Waves of more than 45 degrees come late.
      const double end_time =
        1.3 * 2 * reach / (std::sqrt(.5) * speed_of(wave, material));
      double first = 0;
      for (;;)
        {
          EXPECT_FALSE(body.force.add_to(state, body.activity));
          boundary.add_to_held(state, dt, {}, {});
          boundary.add_to_others(state, dt, {});
          if (state.step == 0)
            {
              start_velocities(state, dt);
              first = energy(body, dt);
            }
          if (state.time >= end_time)
            return energy(body, dt) / first;
          advance(state, body.activity, dt);
        }
    }
  };
} // namespace

TEST(ClosedForm, AtMostFivePerCentComeBackAt45Degrees)
{
  for (const double poissons_ratio : {.05, .1, .15, .2, .25, .3, .35, .4})
    for (const Wave wave : {Wave::p, Wave::sv, Wave::sh})
      EXPECT_LT(reflected_share(wave, rock(poissons_ratio), M_PI / 4), .05)
        << poissons_ratio;
  EXPECT_NEAR(reflected_share(Wave::p, rock(), 0), 0, 1e-15);
  EXPECT_NEAR(reflected_share(Wave::sv, rock(), 0), 0, 1e-15);
  EXPECT_NEAR(reflected_share(Wave::p, rock(), M_PI / 4), .0039377, 1e-6);
  EXPECT_NEAR(reflected_share(Wave::sv, rock(), M_PI / 4), .0286861, 1e-6);
  EXPECT_NEAR(reflected_share(Wave::sh, rock(), M_PI / 4), .0294373, 1e-6);
}

// The error of the mesh falls with the square of its size: the limit must be
// the closed form.
TEST(ObliqueWaves, ReflectedEnergyIsThatOfTheClosedForm)
{
  for (const Wave wave : {Wave::p, Wave::sv, Wave::sh})
    {
      const Packet packet{wave};
      const double coarse = packet.measured_share(16);
      const double fine   = packet.measured_share(24);
      const double limit  = fine + (fine - coarse) / (24. * 24 / (16 * 16) - 1);
      EXPECT_LT(fine, .05);
      EXPECT_NEAR(limit, packet.expected_share(), 1.5e-3);
    }
}
