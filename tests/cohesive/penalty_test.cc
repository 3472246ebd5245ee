#include <rift/cohesive/cohesive_force.h>
#include <rift/time_integration/critical_time_step.h>

#include <gtest/gtest.h>

#include "../support/test_body.h"
#include "breaking_body.h"

using namespace rift;
using namespace rift::test;

namespace
{
  /** A jittered box of granite of the intrinsic model, unbreakably strong. */
  struct IntrinsicBox
  {
    IntrinsicBox(const Penalty &penalty, const unsigned int seed)
      : IntrinsicBox(penalty, make_box({{2, 2, 2}}, 1e-3, .2, seed))
    {
    }

    IntrinsicBox(const Penalty &penalty, const Body &cells)
      : body(discretize(cells, {2641}, {true}))
      , activity(body.topology)
      , strengths(body.topology, body.reference, {strong_granite()}, {})
      , slopes(body.topology,
               body.reference,
               body.state,
               penalty,
               {granite()},
               stiffnesses_of({granite()}))
      , internal_force(body.topology, body.reference, laws_of({granite()}))
      , force(body.topology,
              body.reference,
              strengths,
              parameters_of(CohesiveModel::intrinsic),
              slopes)
    {
      activity.wake_all(body.topology);
      force.start_all(body.state);
    }

    static MaterialParameters
    strong_granite()
    {
      MaterialParameters result = granite();
      result.tensile_strength = result.cohesion = 1e15;
      result.fracture_energy_1 = result.fracture_energy_2 = 1e15;
      return result;
    }

    /** Square of the largest frequency of the body, by power iteration. */
    double
    largest_frequency_squared()
    {
      State                                 &state = body.state;
      std::mt19937                           random(3);
      std::uniform_real_distribution<double> value(-1, 1);
      for (NodalVector &u : state.displacement)
        for (unsigned int d = 0; d < dim; ++d)
          u[d] = value(random);
      double rate = 0;
      for (unsigned int iteration = 0; iteration < 2000; ++iteration)
        {
          // So small that everything is linear.
          double square = 0;
          for (const NodalVector &u : state.displacement)
            square += dot(u.vector(), u.vector());
          for (NodalVector &u : state.displacement)
            u.row() *= 1e-10 / std::sqrt(square);
          state.force.assign(state.n_nodes(), NodalVector());
          EXPECT_FALSE(internal_force.add_to(state, activity));
          force.add_to(state, activity);
          double above = 0, below = 0;
          for (NodeIndex node = 0; node < state.n_nodes(); ++node)
            {
              NodalVector &u = state.displacement[node];
              above -= dot(u.vector(), state.force[node].vector());
              below += state.mass[node] * dot(u.vector(), u.vector());
              for (unsigned int d = 0; d < dim; ++d)
                u[d] = -state.force[node][d] / state.mass[node];
            }
          rate = above / below;
        }
      return rate;
    }

    DiscreteBody     body;
    Activity         activity;
    FaceStrengths    strengths;
    IntrinsicPenalty slopes;
    InternalForce    internal_force;
    CohesiveForce    force;
  };
} // namespace

TEST(Penalty, IsOverTheShortestEdge)
{
  const IntrinsicBox of_modulus({10, true}, 1), in_pascal({3e11, false}, 1);
  const Topology    &topology = of_modulus.body.topology;
  for (FaceIndex face = 0; face < topology.faces.size(); ++face)
    {
      const Face     &f = topology.faces[face];
      Vector3<double> x[3];
      for (unsigned int c = 0; c < 3; ++c)
        x[c] = of_modulus.body.state
                 .reference[topology.node(f.cells[0],
                                          face_corners[f.local_faces[0]][c])]
                 .vector();
      const double shortest =
        std::min({norm(x[1] - x[0]), norm(x[2] - x[1]), norm(x[0] - x[2])});
      EXPECT_NEAR(of_modulus.slopes(face) * shortest, 10 * 40.6e9, 1);
      EXPECT_NEAR(in_pascal.slopes(face) * shortest, 3e11, 1);
    }
}

// Of two materials the softer one decides; beside one that does not break there
// is nothing.
TEST(Penalty, BetweenTwoMaterials)
{
  Body box = make_box({{2, 2, 2}}, 1e-3, .2, 1);
  for (std::size_t i = box.cells.size() / 2; i < box.cells.size(); ++i)
    box.cells[i].material = 1;
  MaterialParameters steel = granite();
  steel.youngs_modulus     = 210e9;
  for (const bool breaks : {true, false})
    for (const bool steel_first : {true, false})
      {
        steel.breakable         = breaks;
        const DiscreteBody body = discretize(box, {2641, 7850}, {});
        const auto materials    = steel_first ? std::vector{steel, granite()} :
                                                std::vector{granite(), steel};
        const IntrinsicPenalty both(body.topology,
                                    body.reference,
                                    body.state,
                                    {10, true},
                                    materials,
                                    stiffnesses_of(materials));
        const IntrinsicPenalty unit(body.topology,
                                    body.reference,
                                    body.state,
                                    {1, false},
                                    {granite(), granite()},
                                    stiffnesses_of(materials));
        const std::uint16_t    of_steel = steel_first ? 0 : 1;
        unsigned int           n_mixed  = 0;
        for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
          {
            unsigned int n_steel = 0;
            for (const CellIndex cell : body.topology.faces[face].cells)
              n_steel += body.topology.material(cell) == of_steel;
            n_mixed += n_steel == 1;
            const double modulus = n_steel == 2 ? 210e9 : 40.6e9;
            const double factor  = n_steel > 0 && !breaks ? 0 : 10 * modulus;
            EXPECT_NEAR(both(face) / unit(face), factor, 1e-9 * 10 * modulus);
          }
        EXPECT_GT(n_mixed, 5U);
      }
}

// Two equal cells that swing against each other on one stiff face come near the
// bound: a part of it that is forgotten shows.
TEST(Penalty, BoundOfTheTimeStepIsSharpForTwoCells)
{
  Body pair;
  pair.vertices = {{{0, 0, 0}},
                   {{1e-3, 0, 0}},
                   {{0, 1e-3, 0}},
                   {{0, 0, 1e-3}},
                   {{2e-3 / 3, 2e-3 / 3, 2e-3 / 3}}};
  pair.cells    = {{0, {{0, 1, 2, 3}}, 0}, {1, {{4, 1, 3, 2}}, 0}};
  IntrinsicBox box({1e4, true}, std::move(pair));
  EXPECT_EQ(box.body.topology.faces.size(), 1U);
  double bound = 0;
  for (const CellIndex cell : {0, 1})
    bound = std::max(bound, box.slopes.frequency_squared(cell));
  const double exact = box.largest_frequency_squared();
  EXPECT_LE(exact, 1.001 * bound);
  EXPECT_GE(exact, .95 * bound);
}

// No frequency of the body is above the bound, and it is not far above them.
TEST(Penalty, BoundOfTheTimeStepIsSafeAndFairlySharp)
{
  for (const double penalty : {.1, 1., 10., 1000.})
    for (const unsigned int seed : {1, 2})
      {
        IntrinsicBox box({penalty, true}, seed);
        const auto   bound =
          critical_time_step(box.body.topology,
                             box.body.reference,
                             {{"granite",
                               stiffness_matrix(make_elasticity(granite())),
                               2641,
                               0,
                               0}},
                             Communicator(),
                             [&box](const CellIndex cell) {
                               return box.slopes.frequency_squared(cell);
                             });
        const double exact = box.largest_frequency_squared();
        EXPECT_LE(exact, bound.frequency_squared);
        EXPECT_GE(exact, .5 * bound.frequency_squared)
          << penalty << " E, seed " << seed;
      }
}

TEST(Penalty, MeanYoungsModulusIsThatOfAnIsotropicMaterial)
{
  EXPECT_NEAR(mean_youngs_modulus(stiffness_matrix(make_elasticity(granite()))),
              40.6e9,
              1);
}
