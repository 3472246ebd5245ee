// Brazilian tests.

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>

#include <gtest/gtest.h>

using namespace rift;

namespace
{
  /**
   * Mean over r < R of the stress across the load in a plane disc of radius 1
   * with the pressure 1 on two arcs of the half angle a. With Fourier's series
   * of the pressure, a_0 + a_2 cos(2 theta) + ..., and Kolosov's functions the
   * sum of the in-plane stresses has the mean -2 a_0 and their difference
   * 2 a_2 (1 - R^2/2). For R = 0 this is the formula of Hondros.
   */
  double
  mean_tension(const double half_angle, const double radius)
  {
    const double a_0 = 2 * half_angle / M_PI;
    const double a_2 = 2 / M_PI * std::sin(2 * half_angle);
    return a_2 * (1 - .5 * radius * radius) - a_0;
  }

  /** Mean over the cells of which `counts` is true of the linear elastic stress
   * along x, from the displacements of the nodes. */
  template <typename Counts>
  double
  mean_stress(const Simulation &simulation,
              const double      youngs_modulus,
              const double      poissons_ratio,
              const Counts     &counts)
  {
    const double    mu     = .5 * youngs_modulus / (1 + poissons_ratio);
    const double    lambda = 2 * mu * poissons_ratio / (1 - 2 * poissons_ratio);
    const Topology &topology = simulation.topology();
    const State    &state    = simulation.state();
    double          sum = 0, volume = 0;
    for (CellIndex cell = 0; cell < topology.n_cells(); ++cell)
      {
        std::array<Vector3<double>, 4> x, u;
        Vector3<double>                centre{};
        for (unsigned int c = 0; c < 4; ++c)
          {
            const NodeIndex node = topology.node(cell, c);
            x[c]                 = state.reference[node].vector();
            u[c]                 = state.displacement[node].vector();
            centre += .25 * x[c];
          }
        if (!counts(centre))
          continue;
        const std::array<Vector3<double>, 3> edges = {
          {x[1] - x[0], x[2] - x[0], x[3] - x[0]}};
        const double    v = dot(edges[0], cross(edges[1], edges[2]));
        Vector3<double> strain{};
        for (unsigned int e = 0; e < 3; ++e)
          {
            const Vector3<double> gradient =
              (1 / v) * cross(edges[(e + 1) % 3], edges[(e + 2) % 3]);
            for (unsigned int d = 0; d < 3; ++d)
              strain[d] += gradient[d] * (u[e + 1][d] - u[0][d]);
          }
        sum += v * (lambda * (strain[0] + strain[1] + strain[2]) +
                    2 * mu * strain[0]);
        volume += v;
      }
    return sum / volume;
  }
} // namespace

TEST(Brazilian, ElasticDiscHasTheTensionOfHondros)
{
  EXPECT_NEAR(mean_tension(.15, 0), 2 / M_PI * (std::sin(.3) - .15), 1e-15);
  Log            log(nullptr);
  Simulation     simulation(read_parameters(RIFT_SOURCE_DIRECTORY
                                        "/prm/brazilian/elastic_disc.prm",
                                        {}),
                        log);
  FlushDenormals flush_denormals;
  while (simulation.state().step < simulation.n_steps())
    simulation.step();
  constexpr double radius = .0204, core = 3e-3;
  const double     tension =
    mean_stress(simulation, 60e9, .24, [](const Vector3<double> &centre) {
      return std::hypot(centre[0], centre[2]) < core;
    });
  EXPECT_NEAR(tension / (100e6 * mean_tension(.15, core / radius)), 1, .02);
  const Energies &energies = simulation.energy_ledger().energies();
  EXPECT_LT(energies.kinetic, 1e-6 * energies.strain);
}
