// How pairs start and end: found in time or too late, released by a crack with
// an overlap, forgotten and found again.

#include <rift/base/exceptions.h>
#include <rift/mesh/node_splitter.h>

#include "../support/single_pair.h"
#include "contact_interface.h"
#include <gtest/gtest.h>

#include <set>

using namespace rift;
using namespace rift::test;

namespace
{
  constexpr double edge = 1e-3, density = 2700;

  /** A body whose second material moves along z, by a step each time. */
  class Mover
  {
  public:
    explicit Mover(const Body &mesh)
      : body(discretize(mesh, {density, density}))
      , force(body.topology, alone, contact_interface(body, density))
      , activity(body.topology)
    {
      activity.wake_all(body.topology);
    }

    /** Takes a step to a depth below the place at the start, m. */
    void
    go_to(const double depth)
    {
      drift_to(depth);
      add_forces();
    }

    /** The first half of a step. */
    void
    drift_to(const double depth)
    {
      ++body.state.step;
      place(depth);
      force.follow(body.state, activity, 1);
    }

    /** The other half. */
    void
    add_forces()
    {
      std::fill(body.state.force.begin(),
                body.state.force.end(),
                NodalVector());
      force.add_to(body.state, activity, 0);
    }

    /** Goes on at this depth from what another one has saved. */
    void
    go_on(const Mover &other, const double depth)
    {
      Archive archive;
      other.force.save(archive);
      body.state.step = other.body.state.step;
      place(depth);
      force.load(body.state, archive);
      add_forces();
    }

    /** Cuts all faces between the materials and leaves them to contact. */
    void
    release()
    {
      std::vector<FaceIndex>   cuts;
      std::vector<VertexIndex> vertices;
      for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
        {
          const auto &cells = body.topology.faces[face].cells;
          if (body.topology.material(cells[0]) ==
              body.topology.material(cells[1]))
            continue;
          cuts.push_back(face);
          for (const VertexIndex vertex : vertices_of(body.topology, face))
            vertices.push_back(vertex);
        }
      body.state.grow(split_nodes(body.topology, cuts));
      for (const FaceIndex face : cuts)
        body.topology.face_states[face] = FaceState::released;
      force.update_nodes(vertices);
    }

    /** Force along z on what moves, N. */
    double
    resistance() const
    {
      double sum = 0;
      for (const NodeIndex node : moving_nodes())
        sum += body.state.force[node][2];
      return sum;
    }

  private:
    std::set<NodeIndex>
    moving_nodes() const
    {
      const Topology     &topology = body.topology;
      std::set<NodeIndex> nodes;
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < n_corners; ++c)
          if (!topology.is_padding(cell) && topology.material(cell) == 1)
            nodes.insert(topology.node(cell, c));
      return nodes;
    }

    void
    place(const double depth)
    {
      for (const NodeIndex node : moving_nodes())
        {
          double &u                    = body.state.displacement[node][2];
          body.state.velocity[node][2] = -depth - u;
          u                            = -depth;
        }
    }

    Communicator alone;

  public:
    DiscreteBody body;
    ContactForce force;
    Activity     activity;
  };

  constexpr double gap = .5 * edge;

  /** Two cubes of six cells, a gap apart. */
  Body
  two_cubes()
  {
    Body       body  = make_box({{1, 1, 1}}, edge);
    const Body upper = body;
    const auto n     = static_cast<VertexIndex>(body.vertices.size());
    for (const Vector3<double> &x : upper.vertices)
      body.vertices.push_back(
        x + Vector3<double>{{.3 * edge, .2 * edge, edge + gap}});
    for (LocalCell cell : upper.cells)
      {
        cell.material = 1;
        for (VertexIndex &v : cell.vertices)
          v += n;
        body.cells.push_back(cell);
      }
    return body;
  }

  /** Force of cubes that approach in small steps until they overlap by
   * `depth`, N. */
  double
  force_of_approach(const double depth)
  {
    Mover cubes(two_cubes());
    for (unsigned int i = 0; i <= 100; ++i)
      cubes.go_to((gap + depth) * i / 100);
    return cubes.resistance();
  }

  /** Two tetrahedra with a common face, the second one above. */
  Body
  two_cells()
  {
    Body body;
    body.vertices          = {{{0, 0, edge}},
                              {{edge, 0, edge}},
                              {{0, edge, edge}},
                              {{.2 * edge, .3 * edge, 0}},
                              {{.3 * edge, .2 * edge, 2 * edge}}};
    body.cells             = {{0, {{3, 0, 1, 2}}, 0}, {0, {{0, 1, 2, 4}}, 0}};
    body.cells[1].material = 1;
    return body;
  }

  /** What the cells have in common, m^3. */
  double
  potential(const Mover &cells)
  {
    const DiscreteBody &body  = cells.body;
    const CellIndex     upper = body.topology.material(0) == 1 ? 0 : batch_size;
    return overlap(positions_of(body.topology, body.state, upper),
                   positions_of(body.topology, body.state, batch_size - upper))
      .potential;
  }

  constexpr double depth = .02 * edge;
} // namespace

/** As if they had been found before they met. */
TEST(ContactForce, PairsFoundTooLateResistFully)
{
  Mover cubes(two_cubes());
  cubes.go_to(0);
  EXPECT_EQ(cubes.resistance(), 0);
  // By more than the margins of both, in one step.
  cubes.go_to(gap + depth);
  EXPECT_GT(cubes.resistance(), 0);
  EXPECT_EQ(cubes.resistance(), force_of_approach(depth));
}

TEST(ContactForce, OverlapsAtTheStartResistAndAreRefused)
{
  Mover cubes(two_cubes());
  cubes.go_to(gap + depth);
  EXPECT_EQ(cubes.resistance(), force_of_approach(depth));

  Mover others(two_cubes());
  others.drift_to(gap + depth);
  MaterialParameters material;
  material.name = "rock";
  EXPECT_THROW(
    others.force.refuse_overlaps(others.body.state, {material, material}),
    InputError);
}

TEST(ContactForce, PairsAreForgottenAndFoundAgain)
{
  const double expected = force_of_approach(depth);
  EXPECT_GT(expected, 0);
  Mover cubes(two_cubes());
  for (unsigned int i = 0; i <= 100; ++i)
    cubes.go_to((gap + depth) * i / 100);
  EXPECT_EQ(cubes.resistance(), expected);
  for (unsigned int i = 0; i <= 100; ++i)
    cubes.go_to(gap + depth - .05 * edge * i);
  EXPECT_EQ(cubes.resistance(), 0);
  for (unsigned int i = 0; i <= 100; ++i)
    cubes.go_to(gap + depth - .05 * edge * (100 - i));
  EXPECT_EQ(cubes.resistance(), expected);
}

TEST(ContactForce, ReleasedPairsStartWithoutForce)
{
  Mover cells(two_cells());
  cells.go_to(0);
  cells.release();
  for (unsigned int i = 2; i < ContactForce::look_interval; ++i)
    cells.go_to(depth);
  // Held until contact looks.
  EXPECT_EQ(cells.resistance(), 0);
  cells.drift_to(depth);
  const double initial = potential(cells);
  ASSERT_GT(initial, 0);

  // A checkpoint has what has just been found.
  Mover other(two_cells());
  other.release();
  other.go_on(cells, depth);
  cells.add_forces();
  EXPECT_NEAR(cells.resistance(), 0, 1e-12 * depth);
  EXPECT_EQ(other.resistance(), cells.resistance());

  cells.go_to(2 * depth);
  other.go_to(2 * depth);
  const double share = 1 - std::sqrt(initial / potential(cells));
  const double first = cells.resistance();
  EXPECT_GT(first, 0);
  EXPECT_EQ(other.resistance(), first);

  // Once they have been apart, the whole overlap resists (eq. 26).
  cells.go_to(-depth);
  cells.go_to(2 * depth);
  EXPECT_NEAR(first, share * cells.resistance(), 1e-10 * first);
}
