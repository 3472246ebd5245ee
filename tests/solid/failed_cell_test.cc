// Cells that have left the range of the elastic law.

#include "../support/elastic_body.h"
#include <gtest/gtest.h>

#include <limits>

using namespace rift;
using namespace rift::test;

namespace
{
  /** A corner of some cell, pushed so that only its own cells are distorted. */
  struct PushedNode
  {
    explicit PushedNode(const double share_of_height)
      : body(make_box({{2, 2, 2}}), granite())
    {
      // The inner vertex is moved towards the face opposite to it in one cell.
      cell = 20;
      while (inner_corner() == n_corners)
        ++cell;
      const unsigned int    corner = inner_corner();
      const Vector3<double> g =
        body.discrete.reference[cell / batch_size].gradient(corner,
                                                            cell % batch_size);
      const NodeIndex node = body.topology.node(cell, corner);
      for (unsigned int d = 0; d < 3; ++d)
        body.state.displacement[node][d] = -share_of_height * g[d] / dot(g, g);
    }

    unsigned int
    inner_corner() const
    {
      unsigned int c = 0;
      for (; c < n_corners; ++c)
        {
          const auto x =
            body.state.reference[body.topology.node(cell, c)].vector();
          if (norm(x - Vector3<double>{{1, 1, 1}}) < 1e-12)
            break;
        }
      return c;
    }

    /** Volume ratios of all cells by the volumes before and after. */
    double
    volume_ratio(const CellIndex of) const
    {
      Vector3<double> x[4], y[4];
      for (unsigned int c = 0; c < 4; ++c)
        {
          const NodeIndex node = body.topology.node(of, c);
          x[c]                 = body.state.reference[node].vector();
          y[c]                 = body.state.position(node);
        }
      return signed_volume(y[0], y[1], y[2], y[3]) /
             signed_volume(x[0], x[1], x[2], x[3]);
    }

    ElasticBody body;
    CellIndex   cell = 0;
  };
} // namespace

TEST(FailedCell, SqueezedAndInverted)
{
  for (const double share : {.49, .51, .9, 1., 1.5, 3.})
    {
      PushedNode pushed(share);
      ASSERT_NEAR(pushed.volume_ratio(pushed.cell), 1 - share, 1e-12);
      CellIndex first_bad = invalid_index;
      for (CellIndex cell = 0; cell < pushed.body.topology.n_cells(); ++cell)
        if (first_bad == invalid_index && pushed.volume_ratio(cell) <= .5)
          first_bad = cell;
      EXPECT_EQ(first_bad == invalid_index, share < .5);

      const auto failed =
        pushed.body.force.add_to(pushed.body.state, pushed.body.activity);
      ASSERT_EQ(failed.has_value(), first_bad != invalid_index) << share;
      if (failed)
        {
          EXPECT_EQ(failed->cell, first_bad);
          EXPECT_NEAR(failed->volume_ratio,
                      pushed.volume_ratio(first_bad),
                      1e-12);
        }
    }
}

TEST(FailedCell, UniformSqueeze)
{
  // A body squeezed in one direction fails at half of its volume, not before.
  Random random(1);
  for (unsigned int n = 0; n < 50; ++n)
    for (const double ratio : {.501, .499, .01, 0., -.5, -2.})
      {
        ElasticBody           body(make_box({{1, 1, 2}}), granite());
        const Vector3<double> a = random_direction(random);
        Matrix3<double>       h;
        for (unsigned int i = 0; i < 3; ++i)
          h[i] = ((ratio - 1) * a[i]) * a;
        impose_gradient(body.state, rotated(random_rotation(random), h));
        const auto failed = body.force.add_to(body.state, body.activity);
        ASSERT_EQ(failed.has_value(), ratio < .5) << ratio;
        if (failed)
          {
            EXPECT_EQ(failed->cell, 0u);
            EXPECT_NEAR(failed->volume_ratio, ratio, 1e-12);
          }
      }
}

TEST(FailedCell, NotANumber)
{
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()})
    for (NodeIndex node = 0; node < 27; ++node)
      {
        ElasticBody body(make_box({{2, 2, 2}}), granite());
        ASSERT_EQ(body.state.n_nodes(), 27u);
        body.state.displacement[node][node % 3] = bad;
        const auto failed = body.force.add_to(body.state, body.activity);
        ASSERT_TRUE(failed) << bad << " at " << node;
        bool has_node = false;
        for (unsigned int c = 0; c < n_corners; ++c)
          has_node |= body.topology.node(failed->cell, c) == node;
        EXPECT_TRUE(has_node);
        EXPECT_FALSE(failed->volume_ratio > .5);
      }
}

TEST(FailedCell, LargeStretchIsNone)
{
  ElasticBody body(make_box({{1, 1, 1}}), granite());
  impose_gradient(body.state, {{{{3, 0, 0}}, {{0, 0, 0}}, {{0, 0, .5}}}});
  EXPECT_FALSE(body.force.add_to(body.state, body.activity));
}
