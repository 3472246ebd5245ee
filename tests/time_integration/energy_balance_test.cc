// The ledger of energies, by itself and with all loads at once.

#include <rift/loading/body_force.h>
#include <rift/loading/prescribed_motion.h>
#include <rift/loading/surface_load.h>
#include <rift/solid/damping.h>
#include <rift/time_integration/central_difference.h>
#include <rift/time_integration/energy_ledger.h>

#include "../support/elastic_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

TEST(EnergyLedger, WhatIsNotANumberIsNoBalance)
{
  EnergyLedger ledger;
  ledger.enter({});
  Energies energies;
  energies.at("kinetic") = std::numeric_limits<double>::quiet_NaN();
  ledger.enter(energies);
  EXPECT_EQ(ledger.relative_residual(),
            std::numeric_limits<double>::infinity());
}

TEST(EnergyLedger, ResidualIsWhatCameFromNowhere)
{
  EnergyLedger ledger;
  Energies     e;
  e.at("kinetic") = 3;
  e.at("strain")  = 1;
  e.at("loads")   = 2;
  ledger.enter(e);
  EXPECT_EQ(ledger.residual(), 0);

  e.at("kinetic")  = 4;
  e.at("cohesive") = .5;
  e.at("fracture") = .25;
  e.at("contact")  = .125;
  e.at("friction") = 1;
  e.at("damping")  = 2;
  e.at("loads")    = 6;
  ledger.enter(e);
  EXPECT_DOUBLE_EQ(e.total(), 8.875);
  EXPECT_DOUBLE_EQ(ledger.residual(), 8.875 - 6 - 2);
  EXPECT_DOUBLE_EQ(ledger.relative_residual(), .875 / 8);
  e.at("kinetic") = 3;
  ledger.enter(e);
  EXPECT_DOUBLE_EQ(ledger.residual(), -.125);
  EXPECT_DOUBLE_EQ(ledger.largest_relative_residual(), .875 / 8);
}

TEST(EnergyLedger, NothingInPlay)
{
  EnergyLedger ledger;
  ledger.enter({});
  EXPECT_EQ(ledger.relative_residual(), 0);
}

TEST(EnergyLedger, RoundingOfWorksThatCancelIsNoError)
{
  // Half a step before the start a load has moved what is held.
  EnergyLedger ledger;
  Energies     e;
  e.at("kinetic") = 4e-24;
  e.at("loads")   = -3.6e-7;
  ledger.enter(e);
  e.at("kinetic") = 1e-41;
  e.at("loads")   = std::nextafter(e.at("loads"), 0);
  ledger.enter(e);
  EXPECT_NE(ledger.residual(), 0);
  EXPECT_LT(ledger.largest_relative_residual(), 1e-5);
  // More than that is an error.
  e.at("strain") = 1e-15;
  ledger.enter(e);
  EXPECT_NEAR(ledger.relative_residual(), 1, 1e-4);
}

namespace
{
  /** A block with every kind of load, in the order of the program's step. */
  class LoadedBlock
  {
  public:
    LoadedBlock(const double size,
                const double share_of_step,
                const bool   damped)
      : body(make_box({{2, 2, 4}}, 1, .1), random_rock())
      , dt(share_of_step * body.critical_step(eta))
      , gravity(Vector3<double>{{2 * size, -.3 * size, -9.81 * size}})
    {
      // In units of the time that a wave takes through an element.
      const std::string omega = std::to_string(.05 / body.critical_step(eta));
      const std::string s     = std::to_string(1 / size);
      const auto        at    = [&](const double z) {
        return plane_surface(body.discrete, 2, z);
      };
      BoundaryParameters pressed;
      pressed.name     = "pressed";
      pressed.pressure = "1e5*sin(" + omega + "*t)/" + s;
      loads.emplace_back(body.topology, at(4), pressed);
      BoundaryParameters pulled;
      pulled.name     = "pulled";
      pulled.traction = {{"2e5/" + s, "", "3e5*cos(" + omega + "*t)/" + s}};
      loads.emplace_back(body.topology,
                         plane_surface(body.discrete, 0, 2),
                         pulled);
      BoundaryParameters moved;
      moved.name     = "moved";
      moved.velocity = {{"0", "", "1e-2*sin(2*" + omega + "*t)/" + s}};
      motion.emplace(body.topology,
                     std::vector<PrescribedMotion::Boundary>{{at(0), moved}});
      if (damped)
        damping.emplace(body.topology,
                        body.discrete.reference,
                        std::vector<double>{eta});
    }

    /** Largest relative residual over `n_steps`. */
    double
    run(const double n_steps)
    {
      State &state = body.state;
      for (unsigned int n = 0; n <= n_steps; ++n)
        {
          EXPECT_FALSE(body.force.add_to(state, body.activity));
          for (auto &load : loads)
            load.add_to(state, body.activity, dt);
          gravity.add_to(state);
          if (damping)
            damping->add_to(state, body.activity);
          if (n == 0)
            start_velocities(state, dt);
          motion->impose(state, body.activity, dt);
          enter();
          advance(state, body.activity, dt);
        }
      return ledger.largest_relative_residual();
    }

    EnergyLedger ledger;

  private:
    static constexpr double eta = 1e6;

    static MaterialParameters
    random_rock()
    {
      Random random(9);
      return random_anisotropic(random);
    }

    void
    enter()
    {
      EnergyTable sums;
      sums["kinetic"] = kinetic_energy(body.topology, body.state, dt);
      sums["strain"]  = body.force.strain_energy(body.state);
      sums["loads"]   = motion->work().sum();
      sums["loads"].add(gravity.work(body.topology, body.state));
      for (auto &load : loads)
        {
          load.count_work(body.state, dt);
          sums["loads"].add(load.work().sum());
        }
      if (damping)
        {
          damping->count_work(body.state, dt);
          sums["damping"] = damping->work().sum();
        }
      ledger.enter(sums.total(Communicator()));
    }

    ElasticBody                     body;
    const double                    dt;
    BodyForce                       gravity;
    std::vector<SurfaceLoad>        loads;
    std::optional<PrescribedMotion> motion;
    std::optional<Damping>          damping;
  };
} // namespace

TEST(EnergyBalance, ClosesForALinearBodyUnderAllLoads)
{
  for (const bool damped : {false, true})
    for (const double share : {.3, .7})
      {
        LoadedBlock block(1e-9, share, damped);
        EXPECT_LT(block.run(1500), 1e-12);
        // All of it is in play.
        const Energies &e = block.ledger.energies();
        EXPECT_GT(e["kinetic"], 0);
        EXPECT_GT(e["strain"], .01 * std::abs(e["loads"]));
        EXPECT_EQ(e["damping"] > .01 * std::abs(e["loads"]), damped);
      }
}

TEST(EnergyBalance, ClosesWhereALoadPressesOnWhatIsHeld)
{
  // Nothing moves but by rounding, whatever the load and the mesh are.
  Random random(4);
  for (unsigned int n = 0; n < 200; ++n)
    {
      ElasticBody        body(make_box({{2, 2, 2}}, .5e-2, .1, n), granite());
      const double       dt    = .7 * body.critical_step();
      State             &state = body.state;
      const Surface      end   = plane_surface(body.discrete, 2, 0);
      BoundaryParameters held;
      held.name     = "held";
      held.pressure = std::to_string(1e6 * (2 + random_matrix(random)[0][0]));
      held.velocity = {{"0", "0", "0"}};
      SurfaceLoad      load(body.topology, end, held);
      PrescribedMotion motion(body.topology, {{end, held}});
      EnergyLedger     ledger;
      for (unsigned int step = 0; step < 20; ++step)
        {
          EXPECT_FALSE(body.force.add_to(state, body.activity));
          load.add_to(state, body.activity, dt);
          if (step == 0)
            start_velocities(state, dt);
          motion.impose(state, body.activity, dt);
          load.count_work(state, dt);
          EnergyTable sums;
          sums["kinetic"] = kinetic_energy(body.topology, state, dt);
          sums["strain"]  = body.force.strain_energy(state);
          sums["loads"]   = motion.work().sum();
          sums["loads"].add(load.work().sum());
          ledger.enter(sums.total(Communicator()));
          advance(state, body.activity, dt);
        }
      ASSERT_LT(ledger.largest_relative_residual(), 1e-4) << n;
    }
}
