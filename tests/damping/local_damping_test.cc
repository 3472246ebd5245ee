// Local damping by itself: the force on a node, what it dissipates, and a bar
// that comes to rest where statics says.

#include <rift/base/floating_point.h>
#include <rift/damping/local_damping.h>
#include <rift/loading/body_force.h>
#include <rift/loading/prescribed_motion.h>
#include <rift/time_integration/central_difference.h>
#include <rift/time_integration/energy_ledger.h>

#include "../support/elastic_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  constexpr double alpha = .7;

  void
  set(NodalVector &vector, const Vector3<double> &values)
  {
    for (unsigned int d = 0; d < dim; ++d)
      vector[d] = values[d];
  }

  /** A column on rollers under its weight; nu = 0, so that it is as in one
   * dimension. */
  struct Column
  {
    static constexpr double length = 4, gravity = 10;

    Column()
      : body(make_box({{2, 2, 8}}, length / 8), rock())
      , weight(Vector3<double>{{0, 0, -gravity}})
      , base(body.topology, {{plane_surface(body.discrete, 2, 0), held()}})
      , damping(body.topology, {rock()}, alpha)
      , time_step(.6 * body.critical_step())
    {
    }

    static MaterialParameters
    rock()
    {
      MaterialParameters material;
      material.density        = 2500;
      material.youngs_modulus = 1e11;
      return material;
    }

    static BoundaryParameters
    held()
    {
      BoundaryParameters boundary;
      boundary.velocity = {{"", "", "0"}};
      return boundary;
    }

    void
    step()
    {
      State &state = body.state;
      EXPECT_FALSE(body.force.add_to(state, body.activity));
      weight.add_to(state);
      if (state.step == 0)
        start_velocities(state, time_step);
      damping.add_to(state, body.activity);
      base.impose(state, body.activity, time_step);
      damping.count_work(state, time_step);
      EnergyTable sums;
      sums["kinetic"]       = kinetic_energy(body.topology, state, time_step);
      sums["strain"]        = body.force.strain_energy(state);
      sums["local damping"] = damping.work().sum();
      sums["loads"]         = weight.work(body.topology, state);
      sums["loads"].add(base.work().sum());
      ledger.enter(sums.total(Communicator()));
      advance(state, body.activity, time_step);
    }

    ElasticBody      body;
    BodyForce        weight;
    PrescribedMotion base;
    LocalDamping     damping;
    const double     time_step;
    EnergyLedger     ledger;
  };
} // namespace

TEST(LocalDamping, IsAShareOfTheForceAgainstTheVelocity)
{
  ElasticBody  body(make_box({{1, 1, 1}}), Column::rock());
  LocalDamping damping(body.topology, {Column::rock()}, alpha);
  State       &state = body.state;
  set(state.velocity[0], {{2, -3, 0}});
  set(state.force[0], {{-5, -7, 11}});
  set(state.velocity[1], {{1, 1, 1}});
  damping.add_to(state, body.activity);
  EXPECT_DOUBLE_EQ(state.force[0][0], -5 - alpha * 5);
  EXPECT_DOUBLE_EQ(state.force[0][1], -7 + alpha * 7);
  EXPECT_EQ(state.force[0][2], 11);
  for (unsigned int d = 0; d < 3; ++d)
    EXPECT_EQ(state.force[1][d], 0);

  // The trapezoidal rule over the velocities before and after the kick.
  const double dt = 1e-3;
  damping.count_work(state, dt);
  damping.count_work(state, 0);
  double expected = 0;
  for (unsigned int d = 0; d < 2; ++d)
    {
      const double force  = d == 0 ? alpha * 5 : -alpha * 7;
      const double before = state.velocity[0][d];
      const double after  = before + dt / state.mass[0] * state.force[0][d];
      expected += .5 * dt * force * (before + after);
    }
  EXPECT_NEAR(damping.work().sum().value(), expected, 1e-15);
}

TEST(LocalDamping, LeavesRigidBodiesAlone)
{
  MaterialParameters rigid = Column::rock();
  rigid.elasticity         = MaterialParameters::Elasticity::rigid;
  ElasticBody  body(make_box({{1, 1, 1}}), Column::rock());
  LocalDamping damping(body.topology, {rigid}, alpha);
  set(body.state.velocity[0], {{1, 1, 1}});
  set(body.state.force[0], {{1, 1, 1}});
  damping.add_to(body.state, body.activity);
  EXPECT_EQ(body.state.force[0][0], 1);
}

TEST(LocalDamping, BringsAColumnToItsEquilibrium)
{
  FlushDenormals flush_denormals;
  Column         column;
  // Some fifty times the way of a wave along the column.
  const double speed = std::sqrt(1e11 / 2500);
  while (column.body.state.time < 50 * Column::length / speed)
    column.step();
  // Single nodes differ, since a corner of one tetrahedron has less weight
  // than one of six.
  const State &state = column.body.state;
  double       sum = 0, n = 0;
  for (NodeIndex i = 0; i < state.n_nodes(); ++i)
    if (state.reference[i][2] > Column::length - 1e-9)
      {
        sum += state.displacement[i][2];
        ++n;
      }
  const double top =
    -2500 * Column::gravity * Column::length * Column::length / (2 * 1e11);
  EXPECT_NEAR(sum / n / top, 1, .02);
  // Clapeyron: a weight that is put on at once does twice the work that the
  // body keeps; 0.1 % are of the half step with which velocities start.
  const Energies &energies = column.ledger.energies();
  EXPECT_LT(energies["kinetic"], 1e-8 * energies["strain"]);
  EXPECT_NEAR(energies["local damping"] / energies["strain"], 1, 2e-3);
  EXPECT_LT(column.ledger.largest_relative_residual(), 1e-6);
}
