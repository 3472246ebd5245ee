// Loads that cannot have any effect: which are refused, and what is doubted.

#include <rift/loading/absorbing_boundaries.h>
#include <rift/loading/body_force.h>
#include <rift/loading/prescribed_motion.h>
#include <rift/loading/surface_load.h>

#include "../support/elastic_body.h"
#include "../temporary_directory.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  using Boundary = PrescribedMotion::Boundary;

  /** A block of 2 x 2 x 2 with loads on its surfaces. */
  struct Block
  {
    Block()
      : body(make_box({{2, 2, 2}}), granite())
    {
    }

    /** A boundary at x[component] = value. */
    BoundaryParameters &
    add(const std::string &name,
        const unsigned int component,
        const double       value)
    {
      boundaries.push_back(
        {plane_surface(body.discrete, component, value), {}});
      boundaries.back().parameters.name = name;
      return boundaries.back().parameters;
    }

    /** What the checks of the modules say. */
    std::string
    refusal(const Vector3<double> &gravity = {{0, 0, 0}}) const
    {
      const Discretization   discretization{Communicator(),
                                          body.topology,
                                          body.discrete.reference,
                                          body.state,
                                          GhostExchange(),
                                          Activity(body.topology),
                                          {2641}};
      const PrescribedMotion motion(body.topology, boundaries);
      const auto             is_prescribed = [&motion](const NodeIndex    node,
                                           const unsigned int component) {
        return motion.prescribes(node, component);
      };
      return message_of<InputError>([&] {
        for (const auto &[surface, parameters] : boundaries)
          {
            if (SurfaceLoad::is_needed(parameters))
              SurfaceLoad(body.topology, surface, parameters)
                .check_effect(discretization, is_prescribed);
            if (parameters.absorbs)
              AbsorbingBoundaries(
                body.topology,
                body.discrete.reference,
                {{parameters.name, surface}},
                [](std::uint16_t, const auto &) { return Matrix3<double>{}; })
                .check_effect(discretization, is_prescribed);
          }
        if (dot(gravity, gravity) > 0)
          BodyForce(gravity).check_effect(discretization, is_prescribed);
      });
    }

    std::vector<std::string>
    warnings() const
    {
      return PrescribedMotion(body.topology, boundaries)
        .doubts_of_order(Communicator());
    }

    ElasticBody           body;
    std::vector<Boundary> boundaries;
  };

  const std::string accepted = "(nothing was thrown)";

  const std::string reason =
    " has no effect, since the velocities along its forces are prescribed on "
    "all nodes that it acts on. Remove this entry, or the prescribed "
    "velocities.";
} // namespace

TEST(IdleLoad, PressureOnAPlaneThatIsHeldAlongItsNormal)
{
  Block block;
  auto &top       = block.add("top", 2, 2);
  top.pressure    = "1e6";
  top.velocity[0] = top.velocity[1] = "0";
  EXPECT_EQ(block.refusal(), accepted);
  block.boundaries[0].parameters.velocity[2] = "3*t";
  EXPECT_EQ(block.refusal(), "Boundary top / Pressure: \"1e6\"" + reason);
  block.boundaries[0].parameters.velocity[0] = "";
  block.boundaries[0].parameters.velocity[1] = "";
  EXPECT_EQ(block.refusal(), "Boundary top / Pressure: \"1e6\"" + reason);
}

TEST(IdleLoad, RoundingOfCoordinatesIsNoForce)
{
  // A mesh some 100 km from the origin, of cells of 1 m: the plane is even to
  // 1e-11 m only.
  Block  block;
  Random random(1);
  for (NodalVector &x : block.body.state.reference)
    for (unsigned int d = 0; d < dim; ++d)
      x[d] += 1e-10 * random_matrix(random)[0][0];
  auto &top       = block.add("top", 2, 2);
  top.pressure    = "1e6";
  top.velocity[2] = "0";
  EXPECT_EQ(block.refusal(), "Boundary top / Pressure: \"1e6\"" + reason);
}

TEST(IdleLoad, PressureOnACurvedSurfaceActs)
{
  Block block;
  auto &top       = block.add("top", 2, 2);
  top.pressure    = "1e6";
  top.velocity[2] = "0";
  for (NodalVector &x : block.body.state.reference)
    x[2] += 1e-3 * x[0] * x[0];
  EXPECT_EQ(block.refusal(), accepted);
}

TEST(IdleLoad, TractionAndDashpotsOnNodesThatOthersHold)
{
  Block block;
  block.add("side", 0, 0).traction[1] = "2e5*t";
  EXPECT_EQ(block.refusal(), accepted);
  // The same nodes, and then some of them.
  auto &held       = block.add("held", 0, 0);
  held.velocity[1] = "0";
  EXPECT_EQ(block.refusal(), "Boundary side / Traction y: \"2e5*t\"" + reason);
  held.velocity = {{"0", "", "0"}};
  EXPECT_EQ(block.refusal(), accepted);

  block.boundaries[0].parameters.traction[1] = "";
  block.boundaries[0].parameters.absorbs     = true;
  EXPECT_EQ(block.refusal(), accepted);
  block.boundaries[1].parameters.velocity[1] = "1";
  EXPECT_EQ(block.refusal(), "Boundary side / Absorbing: \"true\"" + reason);
}

TEST(IdleLoad, GravityOnABodyThatIsHeldAlongIt)
{
  Block                 block;
  const Vector3<double> gravity = {{0, 0, -9.81}};
  block.boundaries.push_back({whole_surface(block.body.topology), {}});
  block.boundaries[0].parameters.name     = "all";
  block.boundaries[0].parameters.velocity = {{"", "", "0"}};
  // The node in the middle is free.
  EXPECT_EQ(block.refusal(gravity), accepted);
  EXPECT_EQ(block.refusal(), accepted);

  block.boundaries[0].surface.clear();
  for (CellIndex cell = 0; cell < block.body.topology.n_cell_slots(); ++cell)
    for (std::uint8_t f = 0;
         f < n_corners && !block.body.topology.is_padding(cell);
         ++f)
      block.boundaries[0].surface.push_back({cell, f});
  EXPECT_EQ(block.refusal(gravity),
            "Body force / Gravity: \"0, 0, -9.81\"" + reason);
  EXPECT_EQ(block.refusal({{1, 0, -9.81}}), accepted);
}

TEST(IdleLoad, VelocityThatOthersOverrule)
{
  Block block;
  block.add("first", 2, 2).velocity[0]  = "0";
  block.add("second", 2, 2).velocity[0] = "1";
  ASSERT_EQ(block.warnings().size(), 1u);
  EXPECT_EQ(block.warnings()[0],
            "Boundary second / Velocity x: \"1\" has no effect, since all its "
            "nodes belong to boundaries that stand before it in the scene and "
            "prescribe this component as well. Remove one of them, or change "
            "their order.");
  block.boundaries[1].parameters.velocity[0] = "0";
  EXPECT_TRUE(block.warnings().empty());
  block.boundaries[1].parameters.velocity = {{"", "1", ""}};
  EXPECT_TRUE(block.warnings().empty());
  // Only the edge is overruled.
  block.boundaries[1].surface = plane_surface(block.body.discrete, 0, 2);
  block.boundaries[1].parameters.velocity = {{"1", "", ""}};
  EXPECT_TRUE(block.warnings().empty());
}
