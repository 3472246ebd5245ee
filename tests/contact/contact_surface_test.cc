// The cells that may touch others, saved between two looks at the cracks.

#include <rift/contact/contact_surface.h>

#include "../support/random_cuts.h"
#include <gtest/gtest.h>

#include <random>

using namespace rift;
using namespace rift::test;

namespace
{
  constexpr double opening = .01, edge = .2;

  /** A cube of irregular cells of which all faces have been cut. */
  DiscreteBody
  loose_cube()
  {
    Body cube = make_box({{4, 4, 4}}, edge, .1, 1);
    order(cube);
    DiscreteBody           body = discretize_ordered(cube, {1});
    std::vector<FaceIndex> all(body.topology.faces.size());
    std::iota(all.begin(), all.end(), FaceIndex(0));
    body.state.grow(split_nodes(body.topology, all));
    return body;
  }

  /** Moves the nodes by up to `size`, m, and has some faces released. */
  void
  crack(DiscreteBody &body, std::mt19937 &random, const double size)
  {
    std::uniform_real_distribution<double> uniform(-size, size);
    for (NodalVector &u : body.state.displacement)
      for (unsigned int d = 0; d < dim; ++d)
        u[d] += uniform(random);
    for (FaceState &state : body.topology.face_states)
      if (random() % 8 == 0)
        state = FaceState::released;
  }

  void
  expect_equal(const DiscreteBody   &body,
               const ContactSurface &x,
               const ContactSurface &y)
  {
    ASSERT_EQ(x.cells(), y.cells());
    for (const CellIndex cell : x.cells())
      {
        const ContactCell a = x.describe(body.state, cell, 0),
                          b = y.describe(body.state, cell, 0);
        EXPECT_EQ(a.groups, b.groups);
        EXPECT_EQ(a.behind, b.behind);
        EXPECT_EQ(a.is_held, b.is_held);
        EXPECT_EQ(a.positions, b.positions);
      }
  }
} // namespace

TEST(ContactSurface, GoesOnBetweenTwoLooks)
{
  std::mt19937   random(1);
  DiscreteBody   body = loose_cube();
  ContactSurface surface(body.topology, opening, FaceState::released);
  const auto     at_start = surface.cells();
  crack(body, random, .03 * opening * edge);
  EXPECT_GT(surface.look(body.state, 1).size(), 20u);
  EXPECT_GT(surface.cells().size(), at_start.size());

  // Faces that are released now are held until the next look.
  crack(body, random, .3 * opening * edge);
  Archive archive;
  surface.save(archive);
  ContactSurface other(body.topology, opening, FaceState::released);
  other.load(body.state, archive);
  expect_equal(body, surface, other);

  const auto news = surface.look(body.state, 2);
  EXPECT_GT(news.size(), 20u);
  EXPECT_EQ(other.look(body.state, 2), news);
  expect_equal(body, surface, other);
}

TEST(ContactSurface, KeepsCellsBehindOthers)
{
  const DiscreteBody body = discretize(make_box({{4, 4, 4}}, edge), {1});
  ContactSurface     surface(body.topology, opening, FaceState::released);
  const auto         outer = surface.cells();
  const auto         news  = surface.include_behind(outer[0]);
  EXPECT_FALSE(news.empty());
  EXPECT_TRUE(surface.include_behind(outer[0]).empty());
  EXPECT_EQ(surface.cells().size(), outer.size() + news.size());

  Archive archive;
  surface.save(archive);
  ContactSurface other(body.topology, opening, FaceState::released);
  other.load(body.state, archive);
  expect_equal(body, surface, other);
}
