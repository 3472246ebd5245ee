// The split Hopkinson bar of prm/brazilian, with short bars and large cells,
// against the theory of waves in slender bars.

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace rift;

namespace
{
  constexpr double bar_length = .4, disc_radius = .0204, speed = 10;
  constexpr double density = 7850, modulus = 210e9;
  const double     c    = std::sqrt(modulus / density);
  const double     area = M_PI / 4 * .022 * .022;

  /** Momenta along the bars, kg m/s. */
  struct Momenta
  {
    double striker = 0, incident_bar = 0, disc = 0, transmission_bar = 0;

    double
    sum() const
    {
      return striker + incident_bar + disc + transmission_bar;
    }
  };

  Momenta
  momenta(const State &state)
  {
    Momenta result;
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      {
        const double x = state.reference[i][0];
        double &p = x < -disc_radius - 1.5e-6 - bar_length ? result.striker :
                    x < -disc_radius - .5e-6 ? result.incident_bar :
                    x < disc_radius + .5e-6  ? result.disc :
                                               result.transmission_bar;
        p += state.mass[i] * state.velocity[i][0];
      }
    return result;
  }
} // namespace

TEST(HopkinsonBar, WavesAndForcesOnTheDisc)
{
  // A plain striker.
  Log              log(nullptr);
  const Parameters parameters =
    read_parameters(RIFT_SOURCE_DIRECTORY "/prm/brazilian/shpb.prm",
                    {"Mesh/Element size=5e-3",
                     "Mesh/Parameters=bar_length = 0.4, tapered = 0, "
                     "striker_length = 0.3, gauge = 0.1, bar_size = 12e-3",
                     "Fracture/Cohesive model=none",
                     "Contact/Damping=0",
                     "Time/End time=191e-6"});
  Simulation     simulation(parameters, log);
  FlushDenormals flush_denormals;
  const State   &state    = simulation.state();
  const double   start    = momenta(state).sum();
  const double   force    = density * c * speed / 2 * area;
  const auto     run_till = [&](const double time) {
    while (state.time < time)
      simulation.step();
    return momenta(state);
  };

  // Until the wave is at the disc: rho c v / 2 in the incident bar.
  const Momenta early = run_till(15e-6);
  const double  begin = state.time;
  const Momenta late  = run_till(75e-6);
  EXPECT_NEAR((late.incident_bar - early.incident_bar) /
                ((state.time - begin) * force),
              1,
              .02);

  // After 2 L / c the striker has given all: the wave has the right duration.
  EXPECT_NEAR(run_till(140e-6).striker / start, 0, .02);

  // Both bars push the disc with the same force, and nearly all of the wave goes
  // through, when what swings to and fro in the disc is averaged over.
  const Momenta before        = run_till(150e-6);
  const double  time          = state.time;
  const Momenta after         = run_till(190e-6);
  const double  scale         = 1 / ((state.time - time) * force);
  const double  incident_side = scale * (before.striker + before.incident_bar -
                                        after.striker - after.incident_bar);
  const double  transmission_side =
    scale * (after.transmission_bar - before.transmission_bar);
  EXPECT_NEAR(incident_side / transmission_side, 1, .05);
  EXPECT_NEAR(transmission_side, .9, .05);

  EXPECT_NEAR(after.sum() / start, 1, 1e-12);
  EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 1e-3);
}
