#include "breaking_body.h"
#include <gtest/gtest.h>

#include <cstring>

using namespace rift;
using namespace rift::test;

namespace
{
  constexpr double edge = 1e-3;

  /** What 500 steps of a swinging body end in. */
  struct End
  {
    State       state;
    std::size_t n_hot = 0, n_cut = 0;
  };

  End
  swing(const bool may_break, const MaterialParameters &material)
  {
    BreakingBody body(make_box({4, 3, 3}, edge, .2), {material});
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-2e-4 * edge, 2e-4 * edge);
    for (NodalVector &u : body.state.displacement)
      for (unsigned int d = 0; d < dim; ++d)
        u[d] = value(random);
    const StressBounds none{{std::nullopt}, {}};
    if (!may_break)
      body.internal_force.watch(none);

    End end;
    for (unsigned int i = 0; i < 500; ++i)
      {
        if (may_break)
          {
            const auto &hot = body.internal_force.hot_cells();
            end.n_hot += hot.size();
            const auto faces = body.insertion.find_faces(body.state, hot);
            end.n_cut += faces.size();
            if (!faces.empty())
              body.split(faces);
          }
        EXPECT_FALSE(body.internal_force.add_to(body.state, body.activity));
        if (may_break)
          {
            body.force.add_to(body.state, body.activity);
          }
        advance(body.state, body.activity, .7 * body.critical.time_step);
      }
    end.state = body.state;
    return end;
  }

  bool
  equal(const std::vector<NodalVector> &a, const std::vector<NodalVector> &b)
  {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), a.size() * sizeof(NodalVector)) == 0;
  }
} // namespace

TEST(NoInsertion, IsPlainElasticityToTheLastBit)
{
  // Stresses come above the bound that makes cells hot but not to the strength
  // of a face, which takes the mean of two cells.
  MaterialParameters strong = granite();
  strong.tensile_strength   = 60e6;
  strong.cohesion           = 60e6;
  const End with            = swing(true, strong);
  const End without         = swing(false, strong);
  EXPECT_GT(with.n_hot, 0u);
  EXPECT_EQ(with.n_cut, 0u);
  EXPECT_TRUE(equal(with.state.displacement, without.state.displacement));
  EXPECT_TRUE(equal(with.state.velocity, without.state.velocity));

  // The comparison sees a difference where there is one.
  const End broken = swing(true, granite());
  EXPECT_GT(broken.n_cut, 0u);
  EXPECT_FALSE(equal(broken.state.displacement, without.state.displacement));
}
