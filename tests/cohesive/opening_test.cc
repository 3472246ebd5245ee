#include "breaking_body.h"
#include <gtest/gtest.h>

#include <set>

using namespace rift;
using namespace rift::test;

// How cohesive elements come to life: which nodes they join, and that nodes
// which part go on as if they had not.
namespace
{
  using Vector = Vector3<double>;

  /** Accelerations of the corners of all cells, by slot and corner. */
  std::vector<Vector>
  corner_accelerations(const BreakingBody &body)
  {
    std::vector<Vector> result;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < 4 && !body.topology.is_padding(cell); ++c)
        {
          const NodeIndex node = body.topology.node(cell, c);
          result.push_back((1 / body.state.mass[node]) *
                           body.state.force[node].vector());
        }
    return result;
  }

  /** The largest difference over the largest acceleration. */
  double
  relative_difference(const std::vector<Vector> &a,
                      const std::vector<Vector> &b)
  {
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        difference = std::max(difference, norm(a[i] - b[i]));
        size       = std::max(size, norm(a[i]));
      }
    return difference / size;
  }

  /** Random displacements that strain cells by about `strain`. */
  void
  strain_at_random(BreakingBody &body,
                   std::mt19937 &random,
                   const double  strain,
                   const double  h)
  {
    std::uniform_real_distribution<double> value(-strain * h, strain * h);
    for (NodalVector &u : body.state.displacement)
      for (unsigned int d = 0; d < dim; ++d)
        u[d] += value(random);
  }

  /** Face by face: a cohesive element joins the nodes that the topology has at
   * its two sides; where no corner has parted there is none. */
  void
  expect_faces_follow_topology(const BreakingBody &body)
  {
    const CohesiveFaces &faces    = body.force.faces();
    const Topology      &topology = body.topology;
    std::set<FaceIndex>  open;
    for (std::size_t i = 0; i < faces.size(); ++i)
      {
        const FaceIndex face = faces.infos[i].face;
        EXPECT_TRUE(open.insert(face).second);
        const Face &f = topology.faces[face];
        for (unsigned int c = 0; c < 3; ++c)
          {
            const unsigned int corner = face_corners[f.local_faces[0]][c];
            const VertexIndex  vertex = topology.vertex(f.cells[0], corner);
            ASSERT_EQ(faces.batches[i / batch_size].minus[c][i % batch_size],
                      topology.node(f.cells[0], corner));
            ASSERT_EQ(
              faces.batches[i / batch_size].plus[c][i % batch_size],
              topology.node(f.cells[1],
                            topology.corner_at_vertex(f.cells[1], vertex)));
          }
      }
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      {
        const Face &f          = topology.faces[face];
        bool        has_parted = false;
        for (const unsigned int c : face_corners[f.local_faces[0]])
          has_parted |= topology.node(f.cells[0], c) !=
                        topology.node(f.cells[1],
                                      topology.corner_at_vertex(
                                        f.cells[1],
                                        topology.vertex(f.cells[0], c)));
        ASSERT_EQ(open.count(face) > 0, has_parted) << "face " << face;
      }
  }

  /** What random cuts have met with. */
  struct Coverage
  {
    /** Splits into 2, 3 and more nodes. */
    unsigned int into[5] = {};

    /** Two nodes of a vertex that split at once. */
    unsigned int at_same_vertex = 0;

    /** Open faces one side of which kept its node while the other side's
     * split. */
    unsigned int one_side = 0;

    void
    count(const TopologyChange &change, const BreakingBody &body)
    {
      std::set<VertexIndex> vertices;
      std::set<NodeIndex>   parts;
      for (const NodeSplit &split : change.splits)
        {
          ++into[std::min<std::size_t>(split.parts.size(), 4)];
          parts.insert(split.parts.begin(), split.parts.end());
          at_same_vertex +=
            !vertices.insert(body.topology.node_vertices[split.parts[0]])
               .second;
        }
      const CohesiveFaces &faces = body.force.faces();
      for (std::size_t i = 0; i < faces.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto &batch = faces.batches[i / batch_size];
            one_side += parts.count(batch.minus[c][i % batch_size]) !=
                        parts.count(batch.plus[c][i % batch_size]);
          }
    }
  };

  /**
   * Cuts a body under a random stress field face by face, a few at a time,
   * and compares the accelerations before and after each cut. Every other
   * time the body moves on in between, so that faces have opened and softened.
   */
  void
  cut_at_random(const double       strain,
                const unsigned int seed,
                Coverage          &coverage)
  {
    constexpr double h = 1e-3;
    std::mt19937     random(seed);
    BreakingBody     body(make_box({2, 2, 2}, h, .2, seed));
    strain_at_random(body, random, strain, h);

    auto faces = body.all_faces();
    std::shuffle(faces.begin(), faces.end(), random);
    for (std::size_t i = 0; i < faces.size();)
      {
        const std::size_t n =
          std::min<std::size_t>(1 + random() % 8, faces.size() - i);
        ASSERT_TRUE(body.sum_forces());
        const auto before = corner_accelerations(body);

        const auto change =
          body.split({faces.begin() + i, faces.begin() + i + n});
        coverage.count(change, body);
        ASSERT_TRUE(body.sum_forces());
        ASSERT_LT(relative_difference(before, corner_accelerations(body)),
                  1e-10);
        // Without the drift, the tractions of the faces take over exactly.
        body.start_openings();
        expect_faces_follow_topology(body);
        ASSERT_TRUE(body.sum_forces());
        ASSERT_LT(relative_difference(before, corner_accelerations(body)),
                  1e-10);
        i += n;
        if (random() % 2)
          advance(body.state, body.activity, .5 * body.critical.time_step);
      }
    EXPECT_EQ(body.topology.n_nodes(), 4 * body.topology.n_cells());
  }
} // namespace

// A strain of 1e-4 is below, of 1e-3 above the strength.
TEST(Opening, AccelerationsDoNotJump)
{
  Coverage coverage;
  for (unsigned int seed = 1; seed <= 10; ++seed)
    for (const double strain : {1e-4, 1e-3})
      cut_at_random(strain, seed, coverage);
  EXPECT_GT(coverage.into[2], 1000u);
  EXPECT_GT(coverage.into[3], 100u);
  EXPECT_GT(coverage.into[4], 10u);
  EXPECT_GT(coverage.at_same_vertex, 10u);
  EXPECT_GT(coverage.one_side, 1000u);
}

TEST(Opening, FaceWithoutPartedNodesLiesIdle)
{
  // Inside of a body one cut face parts nothing.
  BreakingBody body(make_box({3, 3, 3}, 1e-3));
  FaceIndex    inside = 0;
  for (const FaceIndex face : body.all_faces())
    {
      bool        is_inside = true;
      const Face &f         = body.topology.faces[face];
      for (const unsigned int c : face_corners[f.local_faces[0]])
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double x =
              body.state.reference[body.topology.node(f.cells[0], c)][d];
            is_inside &= x > .5e-3 && x < 2.5e-3;
          }
      if (is_inside)
        inside = face;
    }
  const TopologyChange change = body.split({inside});
  EXPECT_TRUE(change.splits.empty());
  EXPECT_EQ(body.topology.face_states[inside], FaceState::cut);
  EXPECT_EQ(body.force.faces().size(), 0u);
}

// A force that holds a support up is no force between the nodes on it.
TEST(Opening, BesideAGripNodesKeepTheAccelerationOfTheGrip)
{
  // Cells of a held face are cut from the rest: parts of a node that keep a
  // cell at the grip go on with it, and so must the others.
  constexpr double h = 1e-3;
  std::mt19937     random(2);
  BreakingBody     body(make_box({2, 2, 2}, h));
  strain_at_random(body, random, 1e-4, h);
  const auto change = body.split(body.faces_in_plane(0, h));
  body.internal_force.add_to(body.state, body.activity);
  body.force.add_to(body.state, body.activity);
  const PrescribedAcceleration is_held = [](const NodeIndex    node,
                                            const unsigned int d) {
    // Some of the parts, whichever.
    return d == 0 && node % 2 == 0 ? std::optional<double>(1.5e4) :
                                     std::nullopt;
  };
  body.force.hold_partings(body.state, is_held);
  unsigned int n_mixed = 0;
  for (const NodeSplit &split : change.splits)
    {
      unsigned int n_held = 0;
      for (const NodeIndex node : split.parts)
        n_held += is_held(node, 0) ? 1 : 0;
      if (n_held == 0 || n_held == split.parts.size())
        continue;
      ++n_mixed;
      for (const NodeIndex node : split.parts)
        {
          const double a = body.state.force[node][0] / body.state.mass[node];
          if (!is_held(node, 0))
            {
              EXPECT_NEAR(a, *is_held(0, 0), 1e-9 * *is_held(0, 0));
            }
        }
    }
  EXPECT_GT(n_mixed, 0u);
}

TEST(Opening, PrescribedComponentsTransmitNothing)
{
  constexpr double h = 1e-3;
  for (const bool is_prescribed : {false, true})
    {
      std::mt19937 random(1);
      BreakingBody body(make_box({2, 1, 1}, h));
      strain_at_random(body, random, 1e-4, h);
      body.split(body.faces_in_plane(0, h));
      body.internal_force.add_to(body.state, body.activity);
      body.force.add_to(body.state, body.activity);
      body.openings = body.force.hold_partings(
        body.state,
        [is_prescribed](const NodeIndex, const unsigned int) {
          return is_prescribed ? std::optional<double>(0) : std::nullopt;
        });
      body.start_openings();
      double largest = 0;
      ASSERT_EQ(body.force.faces().size(), 2u);
      for (std::size_t i = 0; i < 2; ++i)
        for (unsigned int q = 0; q < n_face_points; ++q)
          largest = std::max(
            largest,
            norm(elements_of<ExtrinsicLaw>(body.force).point(i, q).traction));
      if (is_prescribed)
        EXPECT_EQ(largest, 0);
      else
        EXPECT_GT(largest, 1e5);
    }
}
