// A free body that spins for a thousand turns.

#include <rift/solid/damping.h>
#include <rift/time_integration/central_difference.h>

#include "../support/elastic_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  /** About a tenth of critical damping, Pa s. */
  constexpr double viscosity = 4e6;

  Vector3<double>
  momentum(const State &state)
  {
    Vector3<double> sum = {{0, 0, 0}};
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      sum += state.mass[i] * state.velocity[i].vector();
    return sum;
  }

  /**
   * Angular momentum of the positions at t_n and the velocities at t_n - dt/2.
   * The kick changes it by x_n x f dt, whose sum over the nodes is zero since
   * P F^T is symmetric; the drift by dt v x v = 0. Hence it is conserved
   * exactly, and equal to that of the velocities after the kick and, as the
   * mean of both, to that of the velocities at t_n.
   */
  Vector3<double>
  angular_momentum(const State &state)
  {
    Vector3<double> sum = {{0, 0, 0}};
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      sum +=
        state.mass[i] * cross(state.position(i), state.velocity[i].vector());
    return sum;
  }

  /** The same of the velocities at t_n, between forces and kick. */
  Vector3<double>
  angular_momentum_of_mean_velocity(const State &state, const double dt)
  {
    Vector3<double> sum = angular_momentum(state);
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      sum += (.5 * dt) * cross(state.position(i), state.force[i].vector());
    return sum;
  }

  /** A crooked cube of six cells in anisotropic rock. */
  ElasticBody
  make_crooked_cube()
  {
    Random random(7);
    Body   box = make_box({{1, 1, 1}});
    for (auto &x : box.vertices)
      x += .1 * random_matrix(random)[0];
    for (auto &x : box.vertices)
      x += Vector3<double>{{.2, .2, .2}};
    return ElasticBody(box, random_anisotropic(random));
  }

  /** Mass, its centre and the axis of the largest moment of inertia. */
  struct Inertia
  {
    explicit Inertia(const State &state)
    {
      for (NodeIndex i = 0; i < state.n_nodes(); ++i)
        {
          mass += state.mass[i];
          centre += state.mass[i] * state.position(i);
        }
      centre = (1 / mass) * centre;
      Matrix3<double> moments{};
      for (NodeIndex i = 0; i < state.n_nodes(); ++i)
        {
          const Vector3<double> x = state.position(i) - centre;
          for (unsigned int d = 0; d < 3; ++d)
            moments[d] +=
              state.mass[i] * (dot(x, x) * unit_matrix[d] - x[d] * x);
        }
      for (unsigned int iteration = 0; iteration < 2000; ++iteration)
        {
          axis = moments * axis;
          axis = (1 / norm(axis)) * axis;
        }
    }

    double          mass   = 0;
    Vector3<double> centre = {{0, 0, 0}};
    Vector3<double> axis   = {{.48, .6, .64}};
  };

  /** Velocities of a spin about the centre and of a slow translation. */
  void
  set_spinning(State &state, const Vector3<double> &spin)
  {
    const Vector3<double> centre = Inertia(state).centre;
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      {
        const Vector3<double> v = Vector3<double>{{1e-4, -2e-4, 3e-4}} +
                                  cross(spin, state.position(i) - centre);
        for (unsigned int d = 0; d < 3; ++d)
          state.velocity[i][d] = v[d];
      }
  }

  /** Largest deviations from the start of a run, relative. */
  struct Deviations
  {
    double momentum = 0, angular_momentum = 0, mean_angular_momentum = 0,
           energy = 0;
  };

  /** Goes on from a state whose forces are those of its displacements. */
  Deviations
  spin(ElasticBody &body, const double dt, const std::uint64_t n_steps)
  {
    State     &state  = body.state;
    const auto energy = [&] {
      return kinetic_energy(body.topology, state, dt).value() +
             body.force.strain_energy(state).value();
    };
    const Vector3<double> p0 = momentum(state), l0 = angular_momentum(state);
    const double          e0    = energy();
    double                scale = 0;
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      scale += state.mass[i] * norm(state.velocity[i].vector());

    Deviations result;
    const auto note = [](double &largest, const double value) {
      largest = std::max(largest, value);
    };
    for (std::uint64_t n = 0; n <= n_steps; ++n)
      {
        if (n % 37 == 0 || n == n_steps)
          {
            note(result.momentum, norm(momentum(state) - p0) / scale);
            note(result.angular_momentum,
                 norm(angular_momentum(state) - l0) / norm(l0));
            note(result.mean_angular_momentum,
                 norm(angular_momentum_of_mean_velocity(state, dt) - l0) /
                   norm(l0));
            note(result.energy, std::abs(energy() / e0 - 1));
          }
        advance(state, body.activity, dt);
        if (body.force.add_to(state, body.activity))
          {
            ADD_FAILURE() << "failed cell in step " << n;
            break;
          }
      }
    return result;
  }

  /** Direction of an edge of the body, to see it turn. */
  Vector3<double>
  edge(const State &state)
  {
    const Vector3<double> x = state.position(7) - state.position(0);
    return (1 / norm(x)) * x;
  }
} // namespace

TEST(SpinningBody, KeepsMomentaAndEnergyOverAThousandTurns)
{
  ElasticBody   body           = make_crooked_cube();
  State        &state          = body.state;
  constexpr int steps_per_turn = 500;
  const double  dt             = .7 * body.critical_step(viscosity);
  const double  speed          = 2 * M_PI / (steps_per_turn * dt);
  set_spinning(state, speed * Inertia(state).axis);

  // Unstrained at the start, the body would ring; viscosity brings it to rest
  // in the frame that turns with it. Since the rate of deformation is that of
  // half a step ago, it leaves a stress of eta times half the step times the
  // square of the spin: the last of it must be small.
  for (const double eta : {viscosity, viscosity / 30})
    {
      Damping damping(body.topology, body.discrete.reference, {eta});
      for (unsigned int n = 0; n < 50 * steps_per_turn; ++n)
        {
          ASSERT_FALSE(body.force.add_to(state, body.activity));
          damping.add_to(state, body.activity);
          advance(state, body.activity, dt);
        }
    }
  ASSERT_FALSE(body.force.add_to(state, body.activity));
  const Deviations deviation = spin(body, dt, 1000 * steps_per_turn);
  EXPECT_LT(deviation.momentum, 1e-11);
  EXPECT_LT(deviation.angular_momentum, 1e-11);
  EXPECT_LT(deviation.mean_angular_momentum, 1e-11);
  EXPECT_LT(deviation.energy, 1e-6);

  // It is strained by its spin, and turns: after a quarter of a turn only the
  // part of an edge along the axis points to where it did.
  EXPECT_GT(body.force.strain_energy(state).value(),
            1e-5 * kinetic_energy(body.topology, state, dt).value());
  const Vector3<double> axis = Inertia(state).axis, before = edge(state);
  spin(body, dt, steps_per_turn / 4 - 1);
  EXPECT_NEAR(dot(before, edge(state)), std::pow(dot(axis, before), 2), .02);
}

TEST(SpinningBody, ThatRingsErrsByTheSquareOfItsTurnPerStep)
{
  // The stress that a spin needs comes and goes as the body rings; the energy
  // of central differences then differs by a share of the square of the angle
  // that the body turns by in a step, and does not drift.
  double errors[2];
  for (unsigned int i = 0; i < 2; ++i)
    {
      ElasticBody  body           = make_crooked_cube();
      const int    steps_per_turn = 400 << i;
      const double angle          = 2 * M_PI / steps_per_turn;
      const double dt             = .5 * body.critical_step();
      set_spinning(body.state, (angle / dt) * Vector3<double>{{.48, .6, .64}});
      EXPECT_FALSE(body.force.add_to(body.state, body.activity));
      start_velocities(body.state, dt);
      errors[i]            = spin(body, dt, 50 * steps_per_turn).energy;
      const double of_next = spin(body, dt, 50 * steps_per_turn).energy;
      EXPECT_LT(errors[i], 2 * angle * angle);
      EXPECT_LT(of_next, 2.5 * errors[i]);
    }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, .2);
}

TEST(CentralDifference, StartVelocitiesAreThoseOfHalfAStepAgo)
{
  DiscreteBody body    = discretize(make_box({{1, 1, 1}}), {1});
  State       &state   = body.state;
  state.mass[0]        = 2;
  state.velocity[0][1] = 3;
  state.force[0][1]    = 8;
  start_velocities(state, .5);
  EXPECT_DOUBLE_EQ(state.velocity[0][1], 3 - .25 * 4);
  // m v- v+ / 2 with v+ = v- + dt f / m
  EXPECT_DOUBLE_EQ(kinetic_energy(body.topology, state, .5).value(),
                   2. * 2 * 4 / 2);
}
