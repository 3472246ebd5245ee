// Groups of cells at vertices: against clusters of nodes found one by one.

#include <rift/contact/vertex_groups.h>
#include <rift/mesh/mesh_data.h>

#include "../support/random_cuts.h"
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

using namespace rift;
using namespace rift::test;

namespace
{
  /** A box whose cells are all loose, and which hang together at first. */
  class LooseBox
  {
  public:
    explicit LooseBox(const unsigned int seed)
      : body(make_body(seed))
      , groups(body.topology, opening)
    {
      std::vector<FaceIndex> all;
      for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
        all.push_back(face);
      body.state.grow(split_nodes(body.topology, all));
      for (const FaceIndex face : all)
        groups.watch(body.state, face);
    }

    /** Moves each node by up to `size` against its vertex. */
    void
    shake(std::mt19937 &engine, const double size)
    {
      std::uniform_real_distribution<double> uniform(-size, size);
      for (NodalVector &u : body.state.displacement)
        for (unsigned int d = 0; d < dim; ++d)
          u[d] += uniform(engine);
    }

    /** Names of the groups of all corners. */
    Partition
    names() const
    {
      Partition result;
      for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < n_corners; ++c)
          if (!body.topology.is_padding(cell))
            result.push_back(groups.name(cell, c));
      return result;
    }

    static constexpr double opening = .05;
    DiscreteBody            body;
    VertexGroups            groups;

  private:
    static DiscreteBody
    make_body(const unsigned int seed)
    {
      Body box = make_box({{2, 2, 2}}, .5, .1, seed);
      order(box);
      return discretize_ordered(box, {1000});
    }
  };

  /** The least height of the cells around a vertex, by volume and area. */
  double
  height_at(const DiscreteBody &body, const VertexIndex vertex)
  {
    double least = 1e9;
    std::for_each(
      body.topology.vertex_cells_first(vertex),
      body.topology.vertex_cells_last(vertex),
      [&](const CellIndex cell) {
        for (unsigned int c = 0; c < n_corners; ++c)
          {
            // 1 over the gradient of the barycentric coordinate of the corner
            const auto g =
              body.reference[cell / batch_size].gradient(c, cell % batch_size);
            least = std::min(least, 1 / norm(g));
          }
      });
    return least;
  }

  /** Joins corners of the same old group whose nodes are near each other,
   * until nothing changes. */
  Partition
  clusters(const LooseBox &box, const Partition &before)
  {
    const Topology &t = box.body.topology;
    struct Corner
    {
      VertexIndex     vertex;
      std::size_t     before, now;
      Vector3<double> u;
    };
    std::vector<Corner> corners;
    for (CellIndex cell = 0; cell < t.n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < n_corners; ++c)
        if (!t.is_padding(cell))
          corners.push_back(
            {t.vertex(cell, c),
             before[corners.size()],
             corners.size(),
             box.body.state.displacement[t.node(cell, c)].vector()});
    for (bool has_changed = true; has_changed;)
      {
        has_changed = false;
        for (Corner &x : corners)
          for (Corner &y : corners)
            if (x.vertex == y.vertex && x.before == y.before && y.now < x.now &&
                norm(x.u - y.u) <=
                  LooseBox::opening * height_at(box.body, x.vertex))
              {
                x.now       = y.now;
                has_changed = true;
              }
      }
    Partition result;
    for (const Corner &corner : corners)
      result.push_back(corner.now);
    return result;
  }
} // namespace

TEST(VertexGroups, AreOneAtFirst)
{
  const LooseBox box(1);
  Partition      vertices;
  const auto     cells = vertices_of_cells(box.body.topology);
  for (const auto &cell : cells)
    vertices.insert(vertices.end(), cell.begin(), cell.end());
  EXPECT_EQ(canonical(box.names()), canonical(vertices));
}

TEST(VertexGroups, AreClustersOfNodesForGood)
{
  unsigned int n_partly = 0;
  for (unsigned int seed = 1; seed <= 10; ++seed)
    {
      std::mt19937 engine(seed);
      LooseBox     box(seed);
      for (unsigned int step = 0; step < 12; ++step)
        {
          const Partition before = box.names();
          box.shake(engine, .005);
          const Partition expected = clusters(box, before);
          box.groups.divide(box.body.state, 1e9 * (step + 1));
          const Partition now = box.names();
          ASSERT_EQ(canonical(now), canonical(expected)) << seed;
          const std::size_t n =
            std::set<std::size_t>(now.begin(), now.end()).size();
          n_partly += n > 50 && n < now.size() ? 1 : 0;
        }
    }
  EXPECT_GT(n_partly, 20u);
}

TEST(VertexGroups, DoNotComeTogetherAgain)
{
  std::mt19937 engine(3);
  LooseBox     box(3);
  box.shake(engine, .1);
  EXPECT_FALSE(box.groups.divide(box.body.state, 0).empty());
  const Partition apart = box.names();
  for (NodalVector &u : box.body.state.displacement)
    u = NodalVector();
  EXPECT_TRUE(box.groups.divide(box.body.state, 1e9).empty());
  EXPECT_EQ(box.names(), apart);
}

// What is not looked at cannot have changed: the path is that of the fastest.
TEST(VertexGroups, DoNotDependOnWhatIsPassedOver)
{
  std::mt19937                           engine(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  LooseBox                               all(5), few(5);
  double                                 path = 0, largest_path = 0;
  for (unsigned int step = 0; step < 500; ++step)
    {
      double largest = 0;
      for (NodeIndex i = 0; i < all.body.state.n_nodes(); ++i)
        {
          // Few are fast.
          Vector3<double> u;
          for (double &x : u)
            x = 3e-3 * std::pow(uniform(engine), 9);
          largest = std::max(largest, norm(u));
          for (unsigned int d = 0; d < dim; ++d)
            {
              all.body.state.displacement[i][d] += u[d];
              few.body.state.displacement[i][d] += u[d];
            }
        }
      path += largest;
      largest_path += 1;
      ASSERT_EQ(all.groups.divide(all.body.state, largest_path),
                few.groups.divide(few.body.state, path));
    }
  EXPECT_EQ(all.names(), few.names());
  EXPECT_GT(all.groups.divided_vertices().size(), 5u);
}

TEST(VertexGroups, AreRestored)
{
  std::mt19937 engine(4);
  LooseBox     box(4), other(4);
  for (unsigned int step = 0; step < 6; ++step)
    {
      box.shake(engine, .003);
      box.groups.divide(box.body.state, 1e9 * (step + 1));
    }
  Archive archive;
  box.groups.save(archive);
  other.groups.load(archive);
  EXPECT_EQ(other.names(), box.names());
  EXPECT_EQ(other.groups.divided_vertices(), box.groups.divided_vertices());
}
