// Cells at rest are passed over, and nobody can tell from the result.

#include <rift/base/floating_point.h>
#include <rift/loading/prescribed_motion.h>
#include <rift/loading/surface_load.h>
#include <rift/time_integration/central_difference.h>

#include "../support/elastic_body.h"
#include <gtest/gtest.h>

#include <cstdio>


using namespace rift;
using namespace rift::test;

namespace
{
  enum class Cause
  {
    pressure,
    motion
  };

  /** A bar of `length` cubes, set off at z = 0. */
  class Bar
  {
  public:
    Bar(const unsigned int length, const Cause cause, const double size)
      : body(make_box({{1, 1, length}}, 1), granite())
      , dt(.7 * body.critical_step())
    {
      body.activity              = Activity(body.topology);
      const Surface      surface = plane_surface(body.discrete, 2, 0);
      char               value[100];
      BoundaryParameters boundary;
      boundary.name = "end";
      if (cause == Cause::pressure)
        {
          std::snprintf(value, 100, "t < %.17g ? %.17g : 0", 30 * dt, size);
          boundary.pressure = value;
          load.emplace(body.topology, surface, boundary);
        }
      else
        {
          std::snprintf(value,
                        100,
                        "t > %.17g && t < %.17g ? %.17g : 0",
                        5 * dt,
                        20 * dt,
                        size);
          boundary.velocity[2] = value;
          motion.emplace(
            body.topology,
            std::vector<PrescribedMotion::Boundary>{{surface, boundary}});
        }
    }

    void
    step()
    {
      EXPECT_FALSE(body.force.add_to(body.state, body.activity));
      if (load)
        load->add_to(body.state, body.activity, dt);
      if (motion)
        motion->impose(body.state, body.activity, dt);
      advance(body.state, body.activity, dt);
    }

    std::size_t
    n_awake() const
    {
      return body.activity.n_awake();
    }

    ElasticBody body;

  private:
    const double                    dt;
    std::optional<SurfaceLoad>      load;
    std::optional<PrescribedMotion> motion;
  };

  /** Number of nodes at which two states differ in a bit that matters. */
  std::size_t
  n_differences(const State &a, const State &b)
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.n_nodes(); ++i)
      for (unsigned int d = 0; d < 3; ++d)
        if (!(a.displacement[i][d] == b.displacement[i][d] &&
              a.velocity[i][d] == b.velocity[i][d]))
          ++n;
    return n;
  }

  void
  compare_with_all_awake(const Cause cause, const double size)
  {
    const FlushDenormals flush;
    const unsigned int   length = 200;
    Bar                  bar(length, cause, size), awake(length, cause, size);
    awake.body.activity.wake_all(awake.body.topology);
    const std::size_t n_batches = bar.body.topology.n_batches();
    ASSERT_EQ(awake.n_awake(), n_batches);
    ASSERT_EQ(bar.n_awake(), 0u);

    std::size_t former = 0, n_growths = 0;
    for (unsigned int n = 0; n < 350; ++n)
      {
        bar.step();
        awake.step();
        ASSERT_EQ(n_differences(bar.body.state, awake.body.state), 0u)
          << "step " << n;
        EXPECT_GE(bar.n_awake(), former);
        n_growths += bar.n_awake() > former;
        former = bar.n_awake();
        if (n == 12)
          {
            EXPECT_GT(former, 0u);
            EXPECT_LT(former, n_batches / 2);
          }
      }
    // The front runs through the bar and wakes one part after the other.
    EXPECT_GT(n_growths, length / 4);
    EXPECT_EQ(former, n_batches);
    double largest_displacement = 0;
    for (const auto &u : bar.body.state.displacement)
      largest_displacement = std::max(largest_displacement, norm(u.vector()));
    EXPECT_GT(largest_displacement, 0);
  }
} // namespace

TEST(Activity, SameBitsAsWithAllAwakeUnderPressure)
{
  compare_with_all_awake(Cause::pressure, 1e6);
}

TEST(Activity, SameBitsAsWithAllAwakeUnderMotion)
{
  compare_with_all_awake(Cause::motion, 1e-2);
}

TEST(Activity, SameBitsForDisplacementsWhoseSquareIsNoNumber)
{
  compare_with_all_awake(Cause::pressure, 1e-140);
}

TEST(Activity, SleepsWithoutLoad)
{
  Bar bar(10, Cause::pressure, 0);
  for (unsigned int n = 0; n < 20; ++n)
    bar.step();
  EXPECT_EQ(bar.n_awake(), 0u);
  for (const auto &u : bar.body.state.displacement)
    EXPECT_EQ(norm(u.vector()), 0);
}

TEST(Activity, WakesTheCellsAroundANode)
{
  ElasticBody     body(make_box({{2, 2, 12}}), granite());
  const Topology &topology = body.topology;
  for (NodeIndex node = 0; node < topology.n_nodes(); node += 7)
    {
      Activity activity(topology);
      activity.wake_node(topology, node);
      std::vector<bool> is_expected(topology.n_batches(), false);
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < 4 && !topology.is_padding(cell); ++c)
          if (topology.node(cell, c) == node)
            is_expected[cell / batch_size] = true;
      for (std::size_t batch = 0; batch < topology.n_batches(); ++batch)
        {
          EXPECT_EQ(activity.is_awake(batch), is_expected[batch]);
          for (unsigned int lane = 0; lane < batch_size; ++lane)
            for (unsigned int c = 0; c < 4 && is_expected[batch]; ++c)
              EXPECT_TRUE(activity.is_block_awake(
                topology.batches[batch].corner[c][lane] /
                Activity::block_size));
        }
      EXPECT_FALSE(activity.has_woken_neighbours(0));
    }
}

TEST(Activity, NodesOfASplitAreAwake)
{
  ElasticBody            body(make_box({{4, 4, 4}}), granite());
  Activity               activity(body.topology);
  const auto             n_old = body.topology.n_nodes();
  std::vector<FaceIndex> all;
  for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
    all.push_back(face);
  split_nodes(body.topology, all);
  activity.grow(body.topology.n_nodes());
  for (NodeIndex node = n_old; node < body.topology.n_nodes(); ++node)
    EXPECT_TRUE(activity.is_block_awake(node / Activity::block_size));
}
