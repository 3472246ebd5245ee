// Waves in confined bars against d'Alembert's formula and Christoffel's
// equation.

#include "../support/barre_granite.h"
#include "plane_wave.h"

#include <gtest/gtest.h>

using namespace rift;
using test::barre_granite;
using test::PlaneWave;

namespace
{
  MaterialParameters
  rock()
  {
    MaterialParameters material;
    material.name           = "rock";
    material.density        = 2650;
    material.youngs_modulus = 60e9;
    material.poissons_ratio = .25;
    return material;
  }

} // namespace

TEST(ConfinedBar, SpeedOfPWavesAndOrderOfTheError)
{
  const double speed = std::sqrt(1.2 * 60e9 / 2650);
  PlaneWave    wave{rock()};
  double       previous = 0;
  for (const double size : {3e-3, 1.5e-3, .75e-3})
    {
      wave.element_size              = size;
      const PlaneWave::Result result = wave.run(speed);
      EXPECT_NEAR(result.speed / speed, 1, .005) << "element size " << size;
      if (previous > 0)
        {
          EXPECT_GE(std::log2(previous / result.error), 1.5)
            << "element size " << size << ": " << previous << " to "
            << result.error;
        }
      previous = result.error;
    }
  EXPECT_LE(previous, 2e-3);
}

TEST(ConfinedBar, AbsorbingEndTakesTheWave)
{
  // The rest after the pulse has gone. The end where it came from is held.
  const auto left = [](const MaterialParameters &material,
                       const unsigned int        direction,
                       const double              speed) {
    PlaneWave wave{material};
    wave.direction      = direction;
    wave.element_size   = 1.5e-3;
    Parameters scene    = wave.scene();
    scene.time.end_time = PlaneWave::duration + 1.5 * PlaneWave::length / speed;
    BoundaryParameters end;
    end.name    = "x_max";
    end.absorbs = true;
    scene.boundaries.push_back(end);
    Log            log(nullptr);
    Simulation     simulation(scene, log);
    FlushDenormals flush_denormals;
    while (simulation.state().step < simulation.n_steps())
      simulation.step();
    const Energies &energies = simulation.energy_ledger().energies();
    EXPECT_LT(simulation.energy_ledger().largest_relative_residual(), 1e-6);
    EXPECT_GT(energies["damping"], .99 * energies["loads"]);
    return (energies["kinetic"] + energies["strain"]) / energies["loads"];
  };
  EXPECT_LT(left(rock(), 0, std::sqrt(1.2 * 60e9 / 2650)), 2e-3);
  EXPECT_LT(left(rock(), 1, std::sqrt(.4 * 60e9 / 2650)), 2e-3);
  EXPECT_LT(left(barre_granite(), 0, std::sqrt(54.7e9 / 2660)), 2e-3);
  EXPECT_LT(left(barre_granite(), 1, std::sqrt(19.2e9 / 2660)), 2e-3);
}

TEST(OrthotropicBlock, SpeedsAlongMaterialAxes)
{
  // Rows: the material axes 1 and 2 so that 1, 2, 3 lies along the bar. Speeds
  // squared times density of P-waves and of S-waves that move along y and z.
  struct Case
  {
    Vector3<double> axis_1, axis_2, moduli;
  };
  const Case cases[] = {{{{1, 0, 0}}, {{0, 1, 0}}, {{54.7e9, 19.2e9, 17.9e9}}},
                        {{{0, 0, 1}}, {{1, 0, 0}}, {{40.7e9, 15.5e9, 19.2e9}}},
                        {{{0, 1, 0}}, {{0, 0, 1}}, {{35.2e9, 17.9e9, 15.5e9}}}};
  for (const Case &c : cases)
    for (unsigned int direction = 0; direction < 3; ++direction)
      {
        PlaneWave wave{barre_granite()};
        wave.material.axis_1 = c.axis_1;
        wave.material.axis_2 = c.axis_2;
        wave.direction       = direction;
        wave.element_size    = 1e-3;
        const double speed   = std::sqrt(c.moduli[direction] / 2660);
        EXPECT_NEAR(wave.run(speed).speed / speed, 1, .0025);
      }
}

TEST(OrthotropicBlock, PWavesWithAxesTurnedAboutTheBar)
{
  // The P-wave is the same whatever the angle about its direction.
  const double angle = .5;
  PlaneWave    wave{barre_granite()};
  wave.material.axis_1 = {{1, 0, 0}};
  wave.material.axis_2 = {{0, std::cos(angle), std::sin(angle)}};
  const double speed   = std::sqrt(54.7e9 / 2660);
  EXPECT_NEAR(wave.run(speed).speed / speed, 1, .005);
}
