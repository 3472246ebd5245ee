#include <rift/bonds/node_star.h>
#include <rift/loading/absorbing_boundaries.h>
#include <rift/mesh/mesh_data.h>

#include <gtest/gtest.h>

#include "bonded_body.h"

using namespace rift;
using namespace rift::test;

namespace
{
  using Vector = Vector3<double>;

  constexpr double edge = 1e-3, time_step = 2e-8;
  constexpr Vector across = {{1, 0, 0}};

  /** Two cubes of cells. */
  Body
  bar()
  {
    return make_box({{2, 1, 1}}, edge);
  }

  /** Stretches the body: the crack stays where it is, both ends move. */
  void
  stretch(BondedBody &body, const double speed, const Vector &along)
  {
    for (NodeIndex node = 0; node < body.state.n_nodes(); ++node)
      for (unsigned int d = 0; d < dim; ++d)
        body.state.velocity[node][d] +=
          (body.state.reference[node][0] / edge - 1) * speed * along[d];
  }

  /** Some steps. In each the bonds use what their forces take. */
  void
  run(BondedBody &body, const unsigned int n_steps)
  {
    double largest = 0;
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        ASSERT_TRUE(body.sum_forces());
        body.hold(time_step);
        body.kick_and_drift(time_step);
        largest = std::max(largest, std::abs(body.unexplained_energy()));
      }
    EXPECT_LT(largest, 1e-12 * 400 * edge * edge);
  }

  double
  largest_damage(const BondedBody &body)
  {
    double result = 0;
    for (const VertexBonds &group : body.bonds.vertices())
      for (const BondHistory &history : group.histories)
        result = std::max(result, history.memory.damage);
    return result;
  }

  void
  set_random_velocities(BondedBody &body, const double speed)
  {
    for (NodeIndex node = 0; node < body.state.n_nodes(); ++node)
      {
        // The same for all parts of a vertex.
        std::mt19937 random(body.topology.node_vertices[node] + 1);
        std::uniform_real_distribution<double> value(-speed, speed);
        for (unsigned int d = 0; d < dim; ++d)
          body.state.velocity[node][d] = value(random);
      }
  }
} // namespace

namespace
{
  /** The largest displacement of a body, and of its difference from another whose
   * cells are the same. */
  std::pair<double, double>
  largest_and_difference(const BondedBody &body, const BondedBody &other)
  {
    double largest = 0, difference = 0;
    for (CellIndex cell = 0; cell < body.topology.n_cells(); ++cell)
      for (unsigned int c = 0; c < n_corners; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double a =
              body.state.displacement[body.topology.node(cell, c)][d];
            const double b =
              other.state.displacement[other.topology.node(cell, c)][d];
            largest    = std::max(largest, std::abs(b));
            difference = std::max(difference, std::abs(a - b));
          }
    return {largest, difference};
  }
} // namespace

TEST(Bonds, NodesHeldTogetherMoveAsOne)
{
  BondedBody cut(bar()), whole(bar());
  set_random_velocities(cut, .05);
  set_random_velocities(whole, .05);
  cut.split(cut.faces_in_plane(0, edge), across, time_step);
  ASSERT_EQ(cut.state.n_nodes(), whole.state.n_nodes() + 4);
  run(cut, 1000);
  run(whole, 1000);
  EXPECT_EQ(largest_damage(cut), 0);
  const auto [largest, difference] = largest_and_difference(cut, whole);
  EXPECT_GT(largest, 1e-7);
  EXPECT_LT(difference, 1e-11 * largest);
}

// Also where dashpots act on them, of which each has another share of the mass.
TEST(Bonds, NodesHeldTogetherAreDampedAsOne)
{
  BondedBody cut(bar()), whole(bar());
  for (BondedBody *const body : {&cut, &whole})
    {
      set_random_velocities(*body, .05);
      Surface side;
      for (CellIndex cell = 0; cell < body->topology.n_cells(); ++cell)
        for (std::uint8_t f = 0; f < n_corners; ++f)
          {
            double height = 0;
            for (const unsigned int c : face_corners[f])
              height += body->state.reference[body->topology.node(cell, c)][1];
            if (height < 1e-9)
              side.push_back({cell, f});
          }
      AbsorbingBoundaries boundary(
        body->topology,
        body->discrete.reference,
        {{"side", side}},
        [](std::uint16_t, const Vector &normal) {
          constexpr double across_it = 1.1e7, along_it = 7e6;
          Matrix3<double>  result{};
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              result[i][j] = (i == j ? along_it : 0) +
                             (across_it - along_it) * normal[i] * normal[j];
          return result;
        });
      if (body == &cut)
        cut.split(cut.faces_in_plane(0, edge), across, time_step);
      boundary.update_nodes();
      for (unsigned int i = 0; i < 300; ++i)
        {
          std::vector<std::vector<NodeIndex>> held;
          for (NodeIndex node = 0; node < body->state.n_nodes(); ++node)
            held.push_back(body->bonds.nodes_held_with(node));
          ASSERT_TRUE(body->sum_forces());
          boundary.add_to_held(body->state, time_step, held, {});
          body->bonds.hold(body->state, time_step, {});
          boundary.add_to_others(body->state, time_step, {});
          advance(body->state, body->activity, time_step);
        }
    }
  EXPECT_EQ(largest_damage(cut), 0);
  const auto [largest, difference] = largest_and_difference(cut, whole);
  EXPECT_GT(largest, 1e-8);
  EXPECT_LT(difference, 1e-11 * largest);
}

// As the bar breaks in tension and shear, with turning halves.
TEST(Bonds, ForcesOfAVertexBalance)
{
  BondedBody body(bar());
  set_random_velocities(body, 1);
  body.split(body.faces_in_plane(0, edge), across, time_step);
  stretch(body, 40, {{.8, .6, 0}});
  double largest = 0, largest_size = 0;
  for (unsigned int i = 0; i < 200; ++i)
    {
      Vector sum = {{0, 0, 0}};
      ASSERT_TRUE(body.sum_forces());
      const auto before = body.state.force;
      body.bonds.hold(body.state, time_step, {});
      double size = 0;
      for (NodeIndex node = 0; node < body.state.n_nodes(); ++node)
        {
          const Vector force =
            body.state.force[node].vector() - before[node].vector();
          sum += force;
          size += norm(force);
        }
      largest      = std::max(largest, norm(sum));
      largest_size = std::max(largest_size, size);
      advance(body.state, body.activity, time_step);
    }
  EXPECT_LT(largest, 1e-13 * largest_size);
  EXPECT_GT(largest_damage(body), .1);
}

TEST(Bonds, OpeningAndClosingAgainBalance)
{
  BondedBody body(bar());
  body.split(body.faces_in_plane(0, edge), across, time_step);
  stretch(body, 8, {{.8, .6, 0}});
  for (unsigned int turn = 0; turn < 10; ++turn)
    {
      run(body, 40);
      // Both halves come back. The kick that is half done goes on with it.
      body.bond_work = body.work_until_now;
      for (auto &v : body.state.velocity)
        for (unsigned int d = 0; d < dim; ++d)
          v[d] *= -1;
      body.add_bond_work(time_step);
    }
  const BondEnergy used = body.used();
  EXPECT_GT(used.fracture, 0);
  EXPECT_GT(largest_damage(body), .01);
  EXPECT_GT(used.closing, 0);
}

// A bond that has opened and not failed takes no pressure before it is closed.
TEST(Bonds, OpenBondsCloseFreely)
{
  BondedBody body(bar());
  body.split(body.faces_in_plane(0, edge), across, time_step);
  stretch(body, 40, across);
  while (largest_damage(body) < .1)
    run(body, 1);
  EXPECT_LT(largest_damage(body), 1);
  // Both halves come back. The kick that is half done goes on with it.
  body.bond_work = body.work_until_now;
  for (auto &v : body.state.velocity)
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = 0;
  stretch(body, -5, across);
  body.add_bond_work(time_step);
  unsigned int n_open = 0, n_pressed = 0;
  for (unsigned int i = 0; i < 4000; ++i)
    {
      std::map<VertexIndex, double> gaps;
      for (const VertexBonds &group : body.bonds.vertices())
        gaps[group.vertex] = dot(jump_of(group, group.bonds[0], body.state),
                                 group.bonds[0].normal);
      run(body, 1);
      for (const VertexBonds &group : body.bonds.vertices())
        {
          const Bond  &bond    = group.bonds[0];
          const double tension = dot(bond.traction, bond.normal);
          // Farther than anything moves in a step.
          if (gaps[group.vertex] > 1e-6)
            {
              ++n_open;
              EXPECT_GE(tension, -1e-6);
            }
          n_pressed += tension < -1e6 ? 1 : 0;
        }
    }
  EXPECT_GT(n_open, 10u);
  EXPECT_GT(n_pressed, 10u);
}

// A failed bond that slides under pressure leaves all of it to contact, whether
// or not normals are turned in the same steps.
TEST(Bonds, PressureOfSlidingBondsIsLeftToContact)
{
  for (const bool has_contact : {false, true})
    {
      BondedBody body(bar());
      if (has_contact)
        body.bonds.leave_to_contact();
      body.split(body.faces_in_plane(0, edge), across, time_step);
      double before = 0, behind = 0;
      for (unsigned int i = 0; i < 1000; ++i)
        {
          // Both ends are moved.
          for (NodeIndex node = 0; node < body.state.n_nodes(); ++node)
            if (const double side = body.state.reference[node][0] / edge - 1;
                std::abs(side) > .5)
              {
                body.state.velocity[node][0] = -.5 * side;
                body.state.velocity[node][1] = 20 * side;
              }
          for (const VertexBonds &group : body.bonds.vertices())
            {
              const Bond        &bond    = group.bonds[0];
              const BondHistory &history = group.histories[0];
              if (history.memory.damage < 1)
                continue;
              const double pressure = -dot(bond.traction, bond.normal);
              const Vector jump     = jump_of(group, bond, body.state);
              const double slip =
                norm(jump - dot(jump, bond.normal) * bond.normal) /
                history.size;
              if (slip < slip_to_contact)
                before = std::max(before, pressure);
              // The traction is that of the step before.
              else if (slip > 1.1 * (slip_to_contact + slip_of_fading))
                behind = std::max(behind, pressure);
            }
          run(body, 1);
          body.state.step += 1;
        }
      EXPECT_GT(before, 1e6);
      if (has_contact)
        {
          EXPECT_EQ(behind, 0);
        }
      else
        {
          EXPECT_GT(behind, 1e6);
        }
    }
}

// The energy of a whole break is that of its projected area.
TEST(Bonds, BreakingTakesTheFractureEnergy)
{
  BondedBody body(bar());
  body.split(body.faces_in_plane(0, edge), across, time_step);
  stretch(body, 40, across);
  run(body, 1000);
  for (const VertexBonds &group : body.bonds.vertices())
    for (const BondHistory &history : group.histories)
      EXPECT_EQ(history.memory.damage, 1);
  // Damage lags by a step, of some forty.
  EXPECT_NEAR(body.used().fracture / (400 * edge * edge), 1, .05);
}

// A node whose motion is prescribed takes the others along.
TEST(Bonds, PrescribedNodesHoldTheOthers)
{
  BondedBody body(bar());
  body.split(body.faces_in_plane(0, edge), across, time_step);
  set_random_velocities(body, .01);
  for (const VertexBonds &group : body.bonds.vertices())
    for (const VertexBonds::Part &part : group.parts)
      for (unsigned int d = 0; d < dim; ++d)
        body.state.velocity[part.node][d] = 0;
  std::set<NodeIndex> held;
  for (const VertexBonds &group : body.bonds.vertices())
    held.insert(group.parts[0].node);
  constexpr double             acceleration[3] = {1e4, -2e4, 5e3};
  const PrescribedAcceleration prescribed =
    [&](const NodeIndex    node,
        const unsigned int component) -> std::optional<double> {
    if (held.count(node) == 0 || component == 1)
      return {};
    return acceleration[component];
  };
  for (unsigned int i = 0; i < 100; ++i)
    {
      body.sum_forces();
      body.bonds.hold(body.state, time_step, prescribed);
      for (const NodeIndex node : held)
        for (unsigned int d = 0; d < dim; ++d)
          if (const auto a = prescribed(node, d))
            body.state.force[node][d] = body.state.mass[node] * *a;
      advance(body.state, body.activity, time_step);
      for (const VertexBonds &group : body.bonds.vertices())
        for (const auto &[node, root, mass] : group.parts)
          {
            const double v = time_step * (i + 1);
            EXPECT_NEAR(body.state.velocity[node][0],
                        v * acceleration[0],
                        1e-11 * v * acceleration[0]);
            EXPECT_NEAR(body.state.velocity[node][2],
                        v * acceleration[2],
                        1e-11 * v * acceleration[2]);
            EXPECT_NEAR(body.state.velocity[node][1],
                        body.state.velocity[group.parts[0].node][1],
                        1e-11);
          }
    }
  EXPECT_LT(largest_damage(body), 1e-15);
}

// The bonds of nodes that split again go on as they were.
namespace
{
  /** Whether the cells of a node lie at X_1 > `place`. */
  bool
  cells_are_behind(const BondedBody &body,
                   const NodeIndex   node,
                   const double      place)
  {
    const StarCell cell = cells_at_node(body.topology, node)[0];
    double         sum  = 0;
    for (unsigned int c = 0; c < n_corners; ++c)
      sum += body.state.reference[body.topology.node(cell.cell, c)][1] - place;
    return sum > 0;
  }
} // namespace

TEST(Bonds, ChildrenInheritWhatABondRemembers)
{
  // Cells in any order, so that parts change places when nodes split again.
  Body         cells = make_box({{2, 2, 1}}, edge);
  std::mt19937 random(1);
  std::shuffle(cells.cells.begin(), cells.cells.end(), random);
  for (std::size_t i = 0; i < cells.cells.size(); ++i)
    cells.cells[i].global_index = static_cast<GlobalCellIndex>(i);
  BondedBody body(discretize_ordered(cells, densities_of({granite()})),
                  {granite()});
  body.split(body.faces_in_plane(1, edge), {{0, 1, 0}}, time_step);
  for (NodeIndex node = 0; node < body.state.n_nodes(); ++node)
    body.state.velocity[node][1] =
      5 * (body.state.reference[node][1] / edge - 1);
  run(body, 20);
  std::map<VertexIndex, double> damages, tensions, planes;
  std::size_t                   n_before = 0;
  for (const VertexBonds &group : body.bonds.vertices())
    {
      ASSERT_EQ(group.bonds.size(), 1u);
      const Bond        &bond    = group.bonds[0];
      const BondHistory &history = group.histories[0];
      damages[group.vertex]      = history.memory.damage;
      tensions[group.vertex]     = dot(bond.traction, history.plane);
      planes[group.vertex]       = history.plane[1];
      EXPECT_GT(tensions[group.vertex], 0);
      ++n_before;
    }
  EXPECT_GT(largest_damage(body), .001);
  EXPECT_LT(largest_damage(body), 1);
  // Nothing moves in the half of the step that is counted before.
  for (auto &v : body.state.velocity)
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = 0;
  const BondEnergy before = body.used();
  body.split(body.faces_in_plane(0, edge), across, time_step);
  EXPECT_NEAR(body.used().fracture, before.fracture, 1e-14 * before.fracture);
  std::size_t n_children = 0, n_turned = 0;
  for (const VertexBonds &group : body.bonds.vertices())
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      {
        const Bond            &bond  = group.bonds[i];
        const Vector3<double> &plane = group.histories[i].plane;
        if (std::abs(plane[1]) < .9 || damages.count(group.vertex) == 0)
          continue;
        ++n_children;
        n_turned += plane[1] == -planes.at(group.vertex) ? 1 : 0;
        EXPECT_FALSE(bond.is_new);
        EXPECT_EQ(group.histories[i].memory.damage, damages.at(group.vertex));
        // From the first node to the second, also where these have changed
        // places.
        EXPECT_EQ(dot(bond.traction, plane), tensions.at(group.vertex));
        EXPECT_EQ(
          plane[1] > 0,
          cells_are_behind(body, group.parts[bond.parts[1]].node, edge));
      }
  EXPECT_GT(n_children, n_before);
  EXPECT_GT(n_turned, 0u);
}

// A body that has been turned far behaves as one that has not.
TEST(Bonds, TurnedBodyDoesTheSame)
{
  const auto turned = [c = std::cos(2.), s = std::sin(2.)](const Vector &v) {
    return Vector{{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]}};
  };
  BondedBody straight(bar()), oblique(bar());
  for (BondedBody *body : {&straight, &oblique})
    {
      body->split(body->faces_in_plane(0, edge), across, time_step);
      stretch(*body, 10, {{.8, .6, 0}});
    }
  for (NodeIndex node = 0; node < oblique.state.n_nodes(); ++node)
    {
      const Vector x = oblique.state.reference[node].vector();
      const Vector u = turned(x) - x;
      const Vector v = turned(oblique.state.velocity[node].vector());
      for (unsigned int d = 0; d < dim; ++d)
        {
          oblique.state.displacement[node][d] = u[d];
          oblique.state.velocity[node][d]     = v[d];
        }
    }
  run(straight, 100);
  run(oblique, 100);
  EXPECT_GT(largest_damage(straight), .01);
  EXPECT_NEAR(oblique.used().fracture,
              straight.used().fracture,
              1e-6 * straight.used().fracture);
  const auto &a = straight.bonds.vertices(), &b = oblique.bonds.vertices();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a[i].bonds.size(); ++k)
      EXPECT_LT(norm(turned(a[i].bonds[k].traction) - b[i].bonds[k].traction),
                1e-6 * 15e6);
}

// A body that spins while it breaks uses the same energy: it turns by some 0.02
// until then. An open gap does not turn with it.
TEST(Bonds, SpinningBodyUsesTheSameEnergy)
{
  double fracture[2];
  for (const unsigned int spins : {0, 1})
    {
      BondedBody body(bar());
      body.split(body.faces_in_plane(0, edge), across, time_step);
      stretch(body, 40, across);
      const double rate = 2e3 * spins;
      for (NodeIndex node = 0; node < body.state.n_nodes(); ++node)
        {
          const Vector x = body.state.reference[node].vector();
          body.state.velocity[node][0] -= rate * (x[1] - .5 * edge);
          body.state.velocity[node][1] += rate * (x[0] - edge);
        }
      run(body, 1000);
      for (const VertexBonds &group : body.bonds.vertices())
        for (const BondHistory &history : group.histories)
          EXPECT_EQ(history.memory.damage, 1);
      fracture[spins] = body.used().fracture;
    }
  EXPECT_NEAR(fracture[1], fracture[0], .02 * fracture[0]);
}
