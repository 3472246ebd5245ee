// Plane waves in Barre granite against Christoffel's equation.

#include <rift/material/wave_speeds.h>
#include <rift/time_integration/central_difference.h>

#include "../support/barre_granite.h"
#include "../support/elastic_body.h"
#include "../support/periodic_box.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  using Vector = Vector3<double>;

  /** With axes such that a direction, given in them, lies along x. */
  MaterialParameters
  turned_granite(const Vector &direction)
  {
    const Matrix3<double> frame =
      material_axes(direction, cross(direction, {{.3, -.5, 1}}));
    MaterialParameters material = barre_granite();
    for (unsigned int d = 0; d < dim; ++d)
      {
        material.axis_1[d] = frame[d][0];
        material.axis_2[d] = frame[d][1];
      }
    return material;
  }

  /** How the wave of a speed along x moves: what Christoffel's matrix less
   * rho c^2 makes zero. */
  Vector
  polarisation(const MaterialParameters &material, const double speed)
  {
    const Vector    x = {{1, 0, 0}};
    Matrix3<double> matrix =
      acoustic_matrix(stiffness_matrix(make_elasticity(material)), x, x);
    for (unsigned int d = 0; d < dim; ++d)
      matrix[d][d] -= material.density * speed * speed;
    Vector longest{};
    for (unsigned int d = 0; d < dim; ++d)
      {
        const Vector p = cross(matrix[d], matrix[(d + 1) % dim]);
        if (norm(p) > norm(longest))
          longest = p;
      }
    return (1 / norm(longest)) * longest;
  }

  /** A pulse whose velocity is half a period of 1 - cos. */
  constexpr double amplitude = .1, duration = 10e-6;

  double
  pulse_velocity(const double t)
  {
    return t > 0 && t < duration ?
             .5 * amplitude * (1 - std::cos(2 * M_PI * t / duration)) :
             0;
  }

  double
  pulse(const double t)
  {
    const double omega = 2 * M_PI / duration;
    const double s     = std::clamp(t, 0., duration);
    return .5 * amplitude * (s - std::sin(omega * s) / omega);
  }

  /** Drives the nodes at x = 0 along p. */
  void
  send_pulse(ElasticBody &body, const Vector &p, const double end_time)
  {
    State       &state = body.state;
    const double dt    = .7 * body.critical_step();
    while (state.time < end_time)
      {
        ASSERT_FALSE(body.force.add_to(state, body.activity));
        const double velocity = pulse_velocity(state.time + .5 * dt);
        for (NodeIndex i = 0; i < state.n_nodes(); ++i)
          for (unsigned int d = 0; d < dim && state.reference[i][0] == 0; ++d)
            state.force[i][d] =
              state.mass[i] / dt * (velocity * p[d] - state.velocity[i][d]);
        advance(state, body.activity, dt);
      }
  }

  /** That of the exact pulse that fits the displacements along p best. */
  double
  fitted_speed(const State &state, const Vector &p, double speed)
  {
    double slowness = 1 / speed;
    for (unsigned int iteration = 0; iteration < 10; ++iteration)
      {
        double slope = 0, curvature = 0;
        for (NodeIndex i = 0; i < state.n_nodes(); ++i)
          {
            const double x = state.reference[i][0];
            const double t = state.time - slowness * x;
            const double g = -x * pulse_velocity(t);
            slope += state.mass[i] * g *
                     (dot(p, state.displacement[i].vector()) - pulse(t));
            curvature += state.mass[i] * g * g;
          }
        slowness += slope / curvature;
      }
    return 1 / slowness;
  }

  /** What is not that pulse, in the L2 norm, over the pulse. */
  double
  misfit(const State &state, const Vector &p, const double speed)
  {
    double difference = 0, square = 0;
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      {
        const Vector exact =
          pulse(state.time - state.reference[i][0] / speed) * p;
        const Vector rest = state.displacement[i].vector() - exact;
        difference += state.mass[i] * dot(rest, rest);
        square += state.mass[i] * dot(exact, exact);
      }
    return std::sqrt(difference / square);
  }
} // namespace

// In a body without end across the wave: P or almost P, and both S.
TEST(PlaneWaves, SpeedsInBarreGranite)
{
  constexpr double size = .6e-3;
  for (const Vector &direction : {Vector{{1, 0, 0}},
                                  Vector{{0, 1, 0}},
                                  Vector{{0, 0, 1}},
                                  Vector{{1, 1, 1}}})
    {
      const MaterialParameters material = turned_granite(direction);
      const auto speeds = wave_speeds(stiffness_in_material_axes(material),
                                      material.density,
                                      direction);
      for (unsigned int mode = 0; mode < 3; ++mode)
        {
          const Vector p = polarisation(material, speeds[mode]);
          ElasticBody  body(
            make_periodic_box({150, 3, 3}, size, material.density),
            material);
          send_pulse(body, p, .9 * 150 * size / speeds[mode]);
          const double speed = fitted_speed(body.state, p, speeds[mode]);
          EXPECT_NEAR(speed / speeds[mode], 1, 1e-3)
            << "mode " << mode << " along " << direction[0] << ' '
            << direction[1] << ' ' << direction[2];
          EXPECT_LT(misfit(body.state, p, speed), 1e-2);
        }
    }
}
