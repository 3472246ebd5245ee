// The intrinsic model: how much its cohesive elements slow waves down.

#include "../temporary_directory.h"

#include <rift/app/simulation.h>
#include <rift/cohesive/penalty_stiffness.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <sstream>

using namespace rift;

namespace
{
  constexpr double pulse = 40e-6, length = .18;

  /** The cylinder of prm/spalling with a smooth pulse, unbreakable. */
  Parameters
  scene(const std::string &model, const std::string &penalty)
  {
    std::vector<std::string> overrides = {
      "Mesh/Element size=6e-3",
      "Material granite/Tensile strength=15e9",
      "Material granite/Cohesion=36e9",
      "Material granite/Fracture energy I=1e12",
      "Material granite/Fracture energy II=1e12",
      "Boundary loaded/Pressure=t < 40e-6 ? 40e6 * sin(pi * t / 40e-6)^2 : 0",
      "Fracture/Cohesive model=" + model};
    if (!penalty.empty())
      overrides.push_back("Fracture/Cohesive penalty=" + penalty);
    return read_parameters(RIFT_SOURCE_DIRECTORY "/prm/spalling/spalling.prm",
                           overrides);
  }

  /** When the free end of the cylinder has reached half of `velocity`. */
  double
  arrival(Simulation &simulation, const double velocity)
  {
    std::vector<NodeIndex> nodes;
    for (NodeIndex node = 0; node < simulation.topology().n_nodes(); ++node)
      if (simulation.state().reference[node][0] > length - 1e-9)
        nodes.push_back(node);
    double last = 0;
    for (std::uint64_t step = 0; step < simulation.n_steps(); ++step)
      {
        simulation.step();
        double mean = 0;
        for (const NodeIndex node : nodes)
          mean += simulation.state().velocity[node][0] / nodes.size();
        if (mean >= .5 * velocity)
          return (step + (.5 * velocity - last) / (mean - last)) *
                 simulation.time_step();
        last = mean;
      }
    return NAN;
  }

  /**
   * kappa of doc/theory.md, eq. 14c: the area of the faces per volume times
   * their shortest edge, over 3.
   */
  double
  face_compliance(const Simulation &simulation)
  {
    const Topology &topology = simulation.topology();
    const State    &state    = simulation.state();
    const auto      corner   = [&](const CellIndex cell, const unsigned int c) {
      return state.reference[topology.node(cell, c)].vector();
    };
    double sum = 0, volume = 0;
    for (const Face &face : topology.faces)
      {
        Vector3<double> x[3];
        for (unsigned int c = 0; c < 3; ++c)
          x[c] = corner(face.cells[0], face_corners[face.local_faces[0]][c]);
        const double area = .5 * norm(cross(x[1] - x[0], x[2] - x[0]));
        sum +=
          area *
          std::min({norm(x[1] - x[0]), norm(x[2] - x[1]), norm(x[0] - x[2])});
      }
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (!topology.is_padding(cell))
        {
          const auto x0 = corner(cell, 0);
          volume +=
            std::abs(dot(corner(cell, 1) - x0,
                         cross(corner(cell, 2) - x0, corner(cell, 3) - x0))) /
            6;
        }
    return sum / (3 * volume);
  }
} // namespace

TEST(IntrinsicModel, WavesAreSlowerByTheComplianceOfTheFaces)
{
  Log          log(nullptr);
  const double density = 2641, modulus = 40.6e9;
  // Twice the velocity of the pulse in a bar.
  const double velocity = 2 * 40e6 / std::sqrt(density * modulus);
  // The pulse is at half of its peak after a quarter of its time, and the
  // higher the slower the wave is.
  const auto travel = [&](Simulation &simulation, const double slowness) {
    return arrival(simulation, slowness * velocity) - pulse / 4;
  };
  Simulation   plain(scene("none", ""), log);
  const double kappa = face_compliance(plain);
  const double time  = travel(plain, 1);
  EXPECT_NEAR(time, length / std::sqrt(modulus / density), .03 * time);
  for (const double penalty : {1., 10., 100.})
    {
      Simulation simulation(scene("intrinsic", std::to_string(penalty) + " E"),
                            log);
      const double expected = 1 / std::sqrt(1 + kappa / penalty);
      EXPECT_NEAR(time / travel(simulation, 1 / expected),
                  expected,
                  .005 * expected)
        << penalty << " E";
    }
}

// Every cell has nodes of its own, and the mass is what it was.
TEST(IntrinsicModel, PartsAllCells)
{
  Log              log(nullptr);
  const Simulation plain(scene("none", ""), log);
  const Simulation simulation(scene("intrinsic", "10 E"), log);
  const Topology  &topology = simulation.topology();
  EXPECT_EQ(topology.n_nodes(), 4 * topology.n_cells());
  const auto mass = [](const Simulation &of) {
    return std::accumulate(of.state().mass.begin(), of.state().mass.end(), 0.);
  };
  EXPECT_NEAR(mass(simulation), mass(plain), 1e-12 * mass(plain));
  for (const FaceState state : topology.face_states)
    EXPECT_EQ(state, FaceState::cut);
}
