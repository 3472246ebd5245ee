// Loads of whole scenes: those that change faster than the time step, and
// absorbing boundaries that cracks reach.

#include "../temporary_directory.h"

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace rift;

namespace
{
  Parameters
  scene(const std::string &name, const std::vector<std::string> &overrides)
  {
    return read_parameters(RIFT_SOURCE_DIRECTORY "/" + name, overrides);
  }

  /** A hammer that a table of a triangle drives by 1 um within 20 ns. */
  Parameters
  driven_hammer(const TemporaryDirectory &directory)
  {
    const std::string table = directory / "t.csv";
    write_file(table,
               "time [s],velocity [m/s]\n1e-6,0\n1.01e-6,100\n1.02e-6,0\n");
    return scene("prm/contact/hammer.prm",
                 {"Mesh/Element size=6e-3",
                  "Material hammer/Initial velocity=0, 0, 0",
                  "Material hammer/Velocity x=" + table,
                  "Material hammer/Velocity y=0",
                  "Material hammer/Velocity z=0"});
  }
} // namespace

TEST(Loads, DrivenBodyGoesAsFarAsItsTable)
{
  TemporaryDirectory directory;
  Log                log(nullptr);
  Simulation         simulation(driven_hammer(directory), log);
  const State       &state = simulation.state();
  ASSERT_GT(simulation.time_step(), 1e-7);
  while (state.time < 1.1e-6 + simulation.time_step())
    simulation.step();
  unsigned int n_nodes = 0;
  for (NodeIndex i = 0; i < state.n_nodes(); ++i)
    if (state.reference[i][0] < 0)
      {
        ++n_nodes;
        EXPECT_NEAR(state.displacement[i][0], 1e-6, 1e-18);
      }
  EXPECT_GT(n_nodes, 4u);
}

TEST(Loads, WhatTheStepsDoNotSeeIsWarnedOf)
{
  TemporaryDirectory directory;
  const auto         what_is_said = [](const Parameters &parameters) {
    std::ostringstream said;
    Log                log(&said);
    Simulation         simulation(parameters, log);
    return said.str();
  };
  const std::string warning = "WARNING: ", too_fast = " changes too fast";
  const std::string of_hammer = what_is_said(driven_hammer(directory));
  EXPECT_NE(of_hammer.find(warning + "Material hammer / Velocity x: \"" +
                           (directory / "t.csv") + '"' + too_fast),
            std::string::npos)
    << of_hammer;

  const std::string oscillation = "1e6*sin(2*pi*t/1e-9)";
  const std::string of_bar =
    what_is_said(scene("tests/scenes/waking_bar.prm",
                       {"Boundary x_min/Pressure=" + oscillation,
                        "Boundary y_min/Velocity y=" + oscillation}));
  for (const std::string entry : {"x_min / Pressure", "y_min / Velocity y"})
    EXPECT_NE(of_bar.find(warning + "Boundary " + entry + ": \"" + oscillation +
                          '"' + too_fast),
              std::string::npos)
      << of_bar;

  const std::string of_good =
    what_is_said(scene("tests/scenes/waking_bar.prm", {}));
  EXPECT_EQ(of_good.find("WARNING"), std::string::npos) << of_good;
}

TEST(Loads, NodesThatPartAtAbsorbingBoundariesStayTogether)
{
  Log            log(nullptr);
  Simulation     simulation(scene("tests/scenes/absorbing_edges.prm", {}), log);
  FlushDenormals flush_denormals;
  const State   &state         = simulation.state();
  const auto    &vertices      = simulation.topology().node_vertices;
  unsigned int   n_at_boundary = 0;
  while (state.step < simulation.n_steps())
    {
      const std::size_t n_before = state.n_nodes();
      simulation.step();
      for (NodeIndex node = n_before; node < state.n_nodes(); ++node)
        {
          // Of the others at its vertex, at least one goes with it.
          double                smallest = 1e99;
          const Vector3<double> v        = state.velocity[node].vector();
          for (NodeIndex other = 0; other < state.n_nodes(); ++other)
            if (other != node && vertices[other] == vertices[node])
              smallest =
                std::min(smallest, norm(state.velocity[other].vector() - v));
          ASSERT_LT(smallest, 1e-12 * norm(v)) << "node " << node;
          const double x = state.reference[node][0];
          n_at_boundary += x > .03 - 1e-9 || state.reference[node][2] < 1e-9;
        }
    }
  EXPECT_GT(n_at_boundary, 50u);
}
