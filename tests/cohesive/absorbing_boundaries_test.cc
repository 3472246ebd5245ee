// Dashpots of absorbing boundaries where sides, prescribed components and
// cracks meet.

#include <rift/loading/absorbing_boundaries.h>
#include <rift/material/wave_speeds.h>

#include "breaking_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  using Vector = Vector3<double>;

  constexpr double h = 1e-3, dt = 2e-7;

  /** Impedances of the size of those of rock, with all components, which
   * depend on the normal. */
  Matrix3<double>
  full_impedance(const std::uint16_t, const Vector &n)
  {
    Matrix3<double> z = {
      {{{9e6, 2e6, -1e6}}, {{2e6, 7e6, 1.5e6}}, {{-1e6, 1.5e6, 8e6}}}};
    for (unsigned int d = 0; d < dim; ++d)
      for (unsigned int e = 0; e < dim; ++e)
        z[d][e] += 5e6 * n[d] * n[e];
    return z;
  }

  using Boundaries = std::vector<AbsorbingBoundaries::Boundary>;

  /** The sides of a box at x = 0 and z = 0, which meet at an edge. */
  Boundaries
  two_sides(const DiscreteBody &body)
  {
    Boundaries      sides;
    const Topology &topology = body.topology;
    for (const unsigned int d : {0, 2})
      {
        sides.push_back({"side", {}});
        for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
          for (std::uint8_t f = 0; f < n_corners; ++f)
            {
              bool is_in_plane = !topology.is_padding(cell);
              for (unsigned int c = 0; c < 3 && is_in_plane; ++c)
                is_in_plane =
                  body.state.reference[face_nodes(topology, {cell, f})[c]][d] ==
                  0;
              if (is_in_plane)
                sides.back().surface.push_back({cell, f});
            }
      }
    return sides;
  }

  /** The dashpot of each node, by the definition. */
  std::vector<Matrix3<double>>
  dashpots_of(const DiscreteBody &body, const Boundaries &boundaries)
  {
    std::vector<Matrix3<double>> result(body.state.n_nodes());
    for (const auto &[name, surface] : boundaries)
      for (const CellFace &face : surface)
        {
          std::array<Vector, 3> x;
          const auto            nodes = face_nodes(body.topology, face);
          for (unsigned int c = 0; c < 3; ++c)
            x[c] = body.state.reference[nodes[c]].vector();
          const Vector area = .5 * cross(x[1] - x[0], x[2] - x[0]);
          const auto   z    = full_impedance(0, (1 / norm(area)) * area);
          for (const NodeIndex node : nodes)
            for (unsigned int d = 0; d < dim; ++d)
              result[node][d] += (norm(area) / 3) * z[d];
        }
    return result;
  }

  class Random
  {
  public:
    Vector
    vector()
    {
      return {{value(engine), value(engine), value(engine)}};
    }

  private:
    std::mt19937                           engine{7};
    std::uniform_real_distribution<double> value{-1, 1};
  };

  void
  move_at_random(State &state)
  {
    Random random;
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      {
        const Vector v = random.vector(), a = random.vector();
        const Vector u = 1e-5 * h * random.vector();
        for (unsigned int d = 0; d < dim; ++d)
          {
            state.displacement[i][d] = u[d];
            state.velocity[i][d]     = v[d];
            state.force[i][d]        = state.mass[i] / dt * a[d];
          }
      }
  }

  /** Compares the forces on all nodes, and their work, with dashpots that act
   * with the mean velocity of the step.
   * @param before forces without the dashpots, where those count. */
  void
  expect_exact_work(AbsorbingBoundaries            &boundaries,
                    const DiscreteBody             &body,
                    const Boundaries               &sides,
                    const PrescribedAcceleration   &prescribed,
                    const std::vector<NodalVector> &before)
  {
    const State &state    = body.state;
    const auto   dashpots = dashpots_of(body, sides);
    double       expected = 0;
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      {
        const Vector mean = state.velocity[i].vector() +
                            (.5 * dt / state.mass[i]) * state.force[i].vector();
        const Vector force = -1. * (dashpots[i] * mean);
        expected -= dt * dot(mean, force);
        for (unsigned int d = 0; d < dim; ++d)
          if (!(prescribed && prescribed(i, d)))
            {
              EXPECT_NEAR(state.force[i][d] - before[i][d],
                          force[d],
                          1e-12 * state.mass[i] / dt);
            }
      }
    boundaries.count_work(state, dt);
    boundaries.work().begin_step();
    EXPECT_GT(expected, 0);
    EXPECT_NEAR(boundaries.work().sum().value(), expected, 1e-12 * expected);
  }
} // namespace

TEST(AbsorbingBoundaries, SurfacesThatMeetTakeTheWorkOfTheMeanVelocity)
{
  BreakingBody        body(make_box({{3, 3, 3}}, h, .1));
  const Boundaries    sides = two_sides(body.discrete);
  AbsorbingBoundaries boundaries(body.topology,
                                 body.discrete.reference,
                                 sides,
                                 full_impedance);
  move_at_random(body.state);
  const auto before = body.state.force;
  boundaries.add_to_held(body.state, dt, {}, {});
  boundaries.add_to_others(body.state, dt, {});
  expect_exact_work(boundaries, body.discrete, sides, {}, before);
}

TEST(AbsorbingBoundaries, PrescribedComponentsAreKnown)
{
  BreakingBody        body(make_box({{3, 3, 3}}, h, .1));
  State              &state = body.state;
  const Boundaries    sides = two_sides(body.discrete);
  AbsorbingBoundaries boundaries(body.topology,
                                 body.discrete.reference,
                                 sides,
                                 full_impedance);
  move_at_random(state);
  const auto                   before     = state.force;
  const PrescribedAcceleration prescribed = [](const NodeIndex    node,
                                               const unsigned int d) {
    return (node + d) % 3 == 0 ? std::optional<double>(3e5 * d - 2e5) :
                                 std::nullopt;
  };
  boundaries.add_to_held(state, dt, {}, prescribed);
  boundaries.add_to_others(state, dt, prescribed);
  for (NodeIndex i = 0; i < state.n_nodes(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      if (const auto a = prescribed(i, d))
        state.force[i][d] = state.mass[i] * *a;
  expect_exact_work(boundaries, body.discrete, sides, prescribed, before);
}

TEST(AbsorbingBoundaries, CrackThatReachesThemDoesNotJump)
{
  std::array<std::vector<Vector>, 2> accelerations;
  unsigned int                       n_parted = 0;
  for (const bool is_cut : {false, true})
    {
      BreakingBody        body(make_box({{3, 3, 3}}, h, .1));
      State              &state = body.state;
      const Boundaries    sides = two_sides(body.discrete);
      AbsorbingBoundaries boundaries(body.topology,
                                     body.discrete.reference,
                                     sides,
                                     full_impedance);
      move_at_random(state);
      TopologyChange change;
      if (is_cut)
        {
          change = body.split(body.all_faces());
          boundaries.update_nodes();
        }
      state.force.assign(state.n_nodes(), NodalVector());
      ASSERT_FALSE(body.internal_force.add_to(state, body.activity));
      const auto                          before = state.force;
      std::vector<std::vector<NodeIndex>> held;
      for (const NodeSplit &split : change.splits)
        held.push_back(split.parts);
      boundaries.add_to_held(state, dt, held, {});
      std::vector<NodalVector> of_dashpots = state.force;
      for (NodeIndex i = 0; i < state.n_nodes(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          of_dashpots[i][d] = state.force[i][d] - before[i][d];
      body.force.hold_partings(state, {});
      boundaries.add_to_others(state, dt, {});

      for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < 4 && !body.topology.is_padding(cell); ++c)
          {
            const NodeIndex node = body.topology.node(cell, c);
            accelerations[is_cut].push_back((1 / state.mass[node]) *
                                            state.force[node].vector());
          }
      // Each part bears what its own dashpot takes.
      const auto dashpots = dashpots_of(body.discrete, sides);
      for (const NodeSplit &split : change.splits)
        for (const NodeIndex i : split.parts)
          {
            n_parted += norm(of_dashpots[i].vector()) > 0 ? 1 : 0;
            const Vector mean =
              state.velocity[i].vector() +
              (.5 * dt / state.mass[i]) * state.force[i].vector();
            EXPECT_LT(norm(of_dashpots[i].vector() + dashpots[i] * mean),
                      1e-12 * state.mass[i] / dt);
          }
    }
  EXPECT_GT(n_parted, 100u);
  double largest = 0;
  for (const Vector &a : accelerations[0])
    largest = std::max(largest, norm(a));
  for (std::size_t i = 0; i < accelerations[0].size(); ++i)
    ASSERT_LT(norm(accelerations[1][i] - accelerations[0][i]), 1e-12 * largest);
}
