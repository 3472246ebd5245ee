// Loads on faces whose pieces of the body have come off.

#include <rift/loading/surface_load.h>

#include "../support/elastic_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  /** A cube of two metres under a pressure on its top. */
  struct LoadedBox
  {
    explicit LoadedBox(const bool         acts_while_in_place,
                       const std::string &pressure = "3e6")
      : body(make_box({{2, 2, 2}}), granite())
      , load(body.topology,
             plane_surface(body.discrete, 2, 2),
             parameters(acts_while_in_place, pressure))
    {
    }

    static BoundaryParameters
    parameters(const bool acts_while_in_place, const std::string &pressure)
    {
      BoundaryParameters result;
      result.name                = "top";
      result.pressure            = pressure;
      result.acts_while_in_place = acts_while_in_place;
      return result;
    }

    /** The half of the cells at x < 1 has come off, as if it was as large as a
     * cube of 0.1 m, and has moved by `shift`. */
    std::vector<Warning>
    half_comes_off(const double shift)
    {
      Fragments fragments;
      fragments.list.resize(2);
      fragments.list[1].volume       = 1e-3;
      fragments.list[1].displacement = {{0, 0, shift}};
      for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
        {
          double x = 0;
          for (unsigned int c = 0; c < n_corners; ++c)
            x += .25 * body.state.reference[body.topology.node(cell, c)][0];
          fragments.of_cell.push_back(
            body.topology.is_padding(cell) ? invalid_index : (x < 1 ? 1 : 0));
        }
      return load.follow_fragments(fragments, Communicator());
    }

    /** Of the pressure, N. */
    double
    force()
    {
      for (auto &f : body.state.force)
        f = {};
      load.add_to(body.state, body.activity, 1e-6);
      double sum = 0;
      for (const auto &f : body.state.force)
        sum -= f[2];
      return sum;
    }

    ElasticBody body;
    SurfaceLoad load;
  };
} // namespace

TEST(LoadInPlace, EndsOnFacesThatHaveLeft)
{
  LoadedBox box(true);
  EXPECT_TRUE(box.load.needs_fragments());
  EXPECT_TRUE(box.half_comes_off(.099).empty());
  EXPECT_NEAR(box.force(), 12e6, 1e-6);
  EXPECT_TRUE(box.half_comes_off(-.101).empty());
  EXPECT_NEAR(box.force(), 6e6, 1e-6);
  // They bear no load again when they come back.
  box.half_comes_off(0);
  EXPECT_NEAR(box.force(), 6e6, 1e-6);
}

TEST(LoadInPlace, ActsEverywhereByDefault)
{
  LoadedBox box(false);
  EXPECT_FALSE(box.load.needs_fragments());
  EXPECT_NEAR(box.force(), 12e6, 1e-6);
  const auto warnings = box.half_comes_off(.101);
  EXPECT_NEAR(box.force(), 12e6, 1e-6);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].subject, "the load on boundary \"top\"");
  EXPECT_EQ(warnings[0].statement,
            " still acts on all of its 8 faces although the pieces of 4 have "
            "come off and moved by more than their size. Set \"Acts while in "
            "place = true\" in subsection \"Boundary top\" if it is to end "
            "there.");
}

TEST(LoadInPlace, WarnsOfWhatActsAlone)
{
  LoadedBox box(false, "t < 1e-3 ? 0 : 3e6");
  box.force();
  EXPECT_TRUE(box.half_comes_off(1).empty());
  box.body.state.time = 2e-3;
  box.force();
  EXPECT_TRUE(box.half_comes_off(.099).empty());
  EXPECT_EQ(box.half_comes_off(.101).size(), 1u);
}
