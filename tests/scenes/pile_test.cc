// Fragments that fall into a heap or collide (prm/contact/pile.prm, in small).

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

using namespace rift;

namespace
{
  /** 27 fragments. They fall with some velocity from the start, so that a
   * heap comes soon. */
  Parameters
  small_pile(const std::vector<std::string> &overrides)
  {
    std::vector<std::string> all = {
      "Mesh/Parameters=n_x = 3, n_y = 3, n_z = 3",
      "Material lower/Initial velocity=0.3, 0, -2",
      "Material upper/Initial velocity=0, 0.2, -3",
      "Output/History interval=1e-3"};
    all.insert(all.end(), overrides.begin(), overrides.end());
    return read_parameters(RIFT_SOURCE_DIRECTORY "/prm/contact/pile.prm", all);
  }

  /** Kinetic, elastic and potential energy, J, but for a constant. */
  double
  mechanical(const Energies &energies)
  {
    return energies["kinetic"] + energies["strain"] + energies["contact"] -
           energies["loads"];
  }

  void
  expect_energy_is_kept(const std::string &end_time, const double tolerance)
  {
    Log            log(nullptr);
    Simulation     simulation(small_pile({"Contact/Friction coefficient=0",
                                          "Contact/Damping=0",
                                          "Time/End time=" + end_time}),
                          log);
    FlushDenormals flush_denormals;
    double         start = 0, worst = 0, largest_contact = 0;
    while (simulation.state().step < simulation.n_steps())
      {
        simulation.step();
        const Energies energies = simulation.energy_ledger().energies();
        if (start == 0)
          start = mechanical(energies);
        worst = std::max(worst, std::abs(mechanical(energies) - start) / start);
        largest_contact = std::max(largest_contact, energies["contact"]);
      }
    std::printf("%u steps: %.2g of the energy at the start\n",
                static_cast<unsigned int>(simulation.n_steps()),
                worst);
    EXPECT_LT(worst, tolerance);
    EXPECT_LT(simulation.energy_ledger().largest_relative_residual(),
              tolerance);
    // They do meet.
    EXPECT_GT(largest_contact, .01 * start);
  }

  /** Momentum, kg m/s, and angular momentum about the origin, kg m^2/s. The
   * velocities are those that have led to the positions: central differences
   * keep the momenta in this form. */
  struct Momenta
  {
    Vector3<double> linear{}, angular{};

    /** Sums of the lengths. */
    double all_linear = 0, all_angular = 0;
  };

  Momenta
  momenta(const State &state)
  {
    Momenta result;
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      {
        const Vector3<double> p = state.mass[i] * state.velocity[i].vector();
        const Vector3<double> l = cross(state.position(i), p);
        result.linear += p;
        result.angular += l;
        result.all_linear += norm(p);
        result.all_angular += norm(l);
      }
    return result;
  }
} // namespace

TEST(Pile, KeepsItsEnergyWithoutFriction)
{
  expect_energy_is_kept("0.1", 1e-3);
}

TEST(Pile, KeepsItsEnergyWithoutFrictionOver100000Steps)
{
  expect_energy_is_kept("2", .01);
}

TEST(Pile, SettlesAndNeverGainsEnergy)
{
  Log            log(nullptr);
  Simulation     simulation(small_pile({"Time/End time=0.3"}), log);
  FlushDenormals flush_denormals;
  Energies       before{};
  double         kinetic = 0, largest_rise = 0;
  while (simulation.state().step < simulation.n_steps())
    {
      simulation.step();
      const Energies energies = simulation.energy_ledger().energies();
      if (kinetic == 0)
        {
          before  = energies;
          kinetic = energies["kinetic"];
        }
      largest_rise =
        std::max(largest_rise, mechanical(energies) - mechanical(before));
      // What is used up is used up.
      EXPECT_GE(energies["friction"], before["friction"]);
      EXPECT_GE(energies["damping"], before["damping"]);
      before = energies;
    }
  EXPECT_LT(largest_rise, 1e-5 * kinetic);
  EXPECT_GT(before["friction"], .3 * kinetic);
  EXPECT_GT(before["damping"], .3 * kinetic);
  EXPECT_LT(before["kinetic"], 1e-2 * kinetic);
  EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 1e-3);
}

// Two layers that fly into each other, with friction and damping, far from all
// else.
TEST(Fragments, KeepTheirMomentaWhenTheyCollide)
{
  Log        log(nullptr);
  Simulation simulation(
    read_parameters(RIFT_SOURCE_DIRECTORY
                    "/tests/scenes/colliding_fragments.prm"),
    log);
  FlushDenormals flush_denormals;
  const State   &state = simulation.state();
  simulation.step();
  const Momenta start        = momenta(state);
  double        worst_linear = 0, worst_angular = 0;
  while (state.step < simulation.n_steps())
    {
      simulation.step();
      const Momenta now = momenta(state);
      worst_linear =
        std::max(worst_linear,
                 norm(now.linear - start.linear) / start.all_linear);
      worst_angular =
        std::max(worst_angular,
                 norm(now.angular - start.angular) / start.all_angular);
    }
  std::printf("momentum %.2g, angular momentum %.2g\n",
              worst_linear,
              worst_angular);
  EXPECT_LT(worst_linear, 1e-12);
  EXPECT_LT(worst_angular, 1e-12);
  const Energies energies = simulation.energy_ledger().energies();
  EXPECT_GT(energies["friction"], 0);
  EXPECT_GT(energies["damping"], 0);
  EXPECT_LT(energies["kinetic"], energies["friction"] + energies["damping"]);
}
