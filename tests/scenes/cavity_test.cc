// Waves from a spherical cavity under pressure against the closed solution.

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>
#include <rift/io/probes.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace rift;

namespace
{
  constexpr double radius = 15e-3, pressure = 1e6, duration = 8e-6;

  // E 60 GPa, nu 0.25: lambda = mu.
  constexpr double density = 2650, mu = 24e9;
  const double     p_speed = std::sqrt(3 * mu / density);
  const double     s_speed = std::sqrt(mu / density);

  /** f, f' and f'' of the potential f(t - (r - a) / c_p) / r. */
  using Potential = std::array<double, 3>;

  /** For a pressure of 1 Pa from t = 0 on. */
  Potential
  step_response(const double t)
  {
    const double alpha = 2 * s_speed * s_speed / (p_speed * radius);
    const double omega =
      2 * s_speed / radius * std::sqrt(1 - std::pow(s_speed / p_speed, 2));
    const double size  = -std::pow(radius, 3) / (4 * mu);
    const double decay = std::exp(-alpha * t);
    const double c = std::cos(omega * t), s = std::sin(omega * t);
    const double square = alpha * alpha + omega * omega;
    return {{size * (1 - decay * (c + alpha / omega * s)),
             size * decay * square / omega * s,
             size * decay * square / omega * (omega * c - alpha * s)}};
  }

  /** For the pulse of pressure: the sum of its steps (Duhamel), by Simpson's
   * rule. */
  Potential
  pulse_response(const double t)
  {
    constexpr unsigned int n      = 400;
    const double           end    = std::clamp(t, 0., duration);
    const double           rate   = M_PI * pressure / duration;
    Potential              result = {{0, 0, 0}};
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double    s        = end * i / n;
        const double    weight   = (i == 0 || i == n) ? 1 : (i % 2 ? 4 : 2);
        const double    slope    = rate * std::sin(2 * M_PI * s / duration);
        const Potential response = step_response(t - s);
        for (unsigned int k = 0; k < 3; ++k)
          result[k] += weight * end / (3 * n) * slope * response[k];
      }
    return result;
  }

  Parameters
  scene(const double element_size)
  {
    Parameters result;
    result.mesh.file =
      RIFT_SOURCE_DIRECTORY "/tests/benchmarks/errors/cavity.geo";
    result.mesh.element_size   = element_size;
    result.mesh.geo_parameters = {{"inner_radius", radius},
                                  {"outer_radius", 60e-3}};
    MaterialParameters rock;
    rock.name           = "rock";
    rock.density        = density;
    rock.youngs_modulus = 2.5 * mu;
    rock.poissons_ratio = .25;
    result.materials    = {rock};
    // The wave has not come to the outer surface.
    result.time.end_time = 8e-6;
    BoundaryParameters cavity;
    cavity.name     = "cavity";
    cavity.pressure = "0.5e6 * (1 - cos(2 * pi * t / 8e-6))";
    result.boundaries.push_back(cavity);
    for (unsigned int d = 0; d < dim; ++d)
      {
        BoundaryParameters symmetry;
        symmetry.name        = std::string(1, "xyz"[d]) + "_min";
        symmetry.velocity[d] = "0";
        result.boundaries.push_back(symmetry);
      }
    return result;
  }

  /** Relative errors in the L2 norm. */
  struct Errors
  {
    double displacement, velocity;
  };

  Errors
  run(const double element_size)
  {
    Log            log(nullptr);
    Simulation     simulation(scene(element_size), log);
    FlushDenormals flush_denormals;
    while (simulation.state().step < simulation.n_steps())
      simulation.step();
    simulation.step();

    const State &state    = simulation.state();
    const auto   velocity = velocity_at_step(state, simulation.time_step());
    double       difference[2] = {0, 0}, norm[2] = {0, 0};
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      {
        const Vector3<double> x = state.reference[i].vector();
        const double          r = std::sqrt(dot(x, x));
        const Potential f = pulse_response(state.time - (r - radius) / p_speed);
        const double    u = -f[1] / (p_speed * r) - f[0] / (r * r);
        const double    v = -f[2] / (p_speed * r) - f[1] / (r * r);
        const Vector3<double> error[] = {state.displacement[i].vector() -
                                           (u / r) * x,
                                         velocity[i] - (v / r) * x};
        for (unsigned int k = 0; k < 2; ++k)
          difference[k] += state.mass[i] * dot(error[k], error[k]);
        norm[0] += state.mass[i] * u * u;
        norm[1] += state.mass[i] * v * v;
      }
    return {std::sqrt(difference[0] / norm[0]),
            std::sqrt(difference[1] / norm[1])};
  }
} // namespace

TEST(Cavity, WaveOfAPulseOfPressure)
{
  const Errors coarse = run(5e-3), fine = run(2.5e-3);
  EXPECT_LE(fine.displacement, .028);
  EXPECT_LE(fine.velocity, .055);
  EXPECT_GE(std::log2(coarse.displacement / fine.displacement), 1.7)
    << coarse.displacement << " to " << fine.displacement;
  EXPECT_GE(std::log2(coarse.velocity / fine.velocity), 1.7)
    << coarse.velocity << " to " << fine.velocity;
}

TEST(Cavity, StaticDisplacementUnderPressure)
{
  // P a^3 / (4 mu r^2), the limit of the solution that the test above rests on.
  const Potential f = step_response(1e-3);
  EXPECT_NEAR(f[0] / (-std::pow(radius, 3) / (4 * mu)), 1, 1e-12);
  EXPECT_NEAR(f[1] / f[0], 0, 1e-6);
}
