// Contact of bodies that lie deep in each other, on any number of ranks: the
// cells behind their surfaces take part, so that the force does not fall to zero.

#include "../support/distributed_body.h"
#include "contact_interface.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  /** Edge of the cubes of six cells, m, and by how much one block goes down into
   * the other in a step. */
  constexpr double edge = 1e-3, step = .01 * edge;

  constexpr double density = 2700;

  /** A block stands on a larger one. */
  Body
  two_blocks(const unsigned int seed)
  {
    Body       body  = make_box({{4, 4, 3}}, edge, .2, seed);
    const Body upper = make_box({{2, 2, 3}}, edge, .2, seed + 1);
    const auto n     = static_cast<VertexIndex>(body.vertices.size());
    for (const Vector3<double> &x : upper.vertices)
      body.vertices.push_back(
        x + Vector3<double>{{.8 * edge, 1.3 * edge, 3 * edge}});
    for (LocalCell cell : upper.cells)
      {
        cell.material = 1;
        for (VertexIndex &v : cell.vertices)
          v += n;
        body.cells.push_back(cell);
      }
    order(body);
    return body;
  }

  /** What one rank sees of the upper block as it goes down. */
  class Descent
  {
  public:
    Descent(const test::BodyPart &part, const Communicator &communicator)
      : part(part)
      , body(discretize(part, {density, density}))
      , force(body.topology, communicator, contact_interface(body, density))
      , activity(body.topology)
    {
      activity.wake_all(body.topology);
    }

    void
    go_down()
    {
      ++body.state.step;
      place();
      force.follow(body.state, activity, 1);
      add_forces();
    }

    void
    add_forces()
    {
      std::fill(body.state.force.begin(),
                body.state.force.end(),
                NodalVector());
      force.add_to(body.state, activity, 0);
    }

    /** Goes on where another one is. */
    void
    go_on(const Descent &other)
    {
      Archive archive;
      other.force.save(archive);
      body.state.step = other.body.state.step;
      place();
      force.load(body.state, archive);
      add_forces();
    }

    /** Of the nodes of which this rank knows all cells, by vertex. */
    std::map<VertexIndex, std::array<double, 3>>
    forces() const
    {
      std::map<VertexIndex, std::array<double, 3>> result;
      for (NodeIndex node = 0; node < body.topology.n_nodes(); ++node)
        {
          const VertexIndex  v = body.topology.node_vertices[node];
          const NodalVector &f = body.state.force[node];
          if (body.topology.is_complete(v))
            result[part.global_vertices[v]] = {{f[0], f[1], f[2]}};
        }
      return result;
    }

    /** Force that resists, N. */
    double
    resistance() const
    {
      double sum = 0;
      for (NodeIndex node = 0; node < body.topology.n_nodes(); ++node)
        if (is_upper(node))
          sum += body.state.force[node][2];
      return sum;
    }

    const DiscreteBody &
    blocks() const
    {
      return body;
    }

    const ContactForce &
    contact() const
    {
      return force;
    }

  private:
    bool
    is_upper(const NodeIndex node) const
    {
      const Topology &topology = body.topology;
      return topology.material(
               *topology.vertex_cells_first(topology.node_vertices[node])) == 1;
    }

    void
    place()
    {
      for (NodeIndex node = 0; node < body.topology.n_nodes(); ++node)
        if (is_upper(node))
          {
            body.state.displacement[node][2] =
              -step * static_cast<double>(body.state.step);
            body.state.velocity[node][2] = -step;
          }
    }

    test::BodyPart part;
    DiscreteBody   body;
    ContactForce   force;
    Activity       activity;
  };

  test::BodyPart
  whole(const Body &body)
  {
    return part_of(body, std::vector<int>(body.cells.size(), 0), 0);
  }

  /** The least penalty at the surfaces, Pa. */
  double
  least_penalty(const DiscreteBody &body)
  {
    const ContactStiffnesses stiffnesses =
      contact_interface(body, density).stiffnesses;
    double least = 1e300;
    for (CellIndex cell = 0; cell < body.topology.n_cells(); ++cell)
      {
        const auto            &faces = body.topology.cell_faces[cell];
        const ContactStiffness of    = stiffnesses.of_cell(cell);
        if (std::count(faces.begin(), faces.end(), invalid_index) > 0)
          least = std::min(least, pair_penalty(of, of));
      }
    return least;
  }
} // namespace

TEST(DeepContact, ForceDoesNotFallToZero)
{
  for (unsigned int seed = 1; seed < 4; ++seed)
    {
      const Communicator alone;
      Descent            blocks(whole(two_blocks(seed)), alone);
      const double unit = least_penalty(blocks.blocks()) * 4 * edge * edge;
      double       work = 0;
      for (unsigned int i = 1; i <= 250; ++i)
        {
          blocks.go_down();
          work += step * blocks.resistance();
          // Where the layers of both meshes come to lie in each other it is
          // least.
          if (i >= 10)
            {
              EXPECT_GT(blocks.resistance(), .05 * unit) << i;
            }
        }
      EXPECT_GT(work, .2 * unit * 250 * step);
      EXPECT_TRUE(blocks.contact().deep_overlaps());
    }
}

TEST(DeepContact, IsTheSameOnAnyNumberOfRanks)
{
  const Communicator alone, all(MPI_COMM_WORLD);
  const Body         body = two_blocks(5);
  std::mt19937       random(2);
  Descent            blocks(whole(body), alone);
  Descent            part(part_of(body,
                       random_owners(body.cells.size(), all.size(), random),
                       all.rank()),
               all);
  for (unsigned int i = 1; i <= 120; ++i)
    {
      blocks.go_down();
      part.go_down();
      if (i % 10 != 0)
        continue;
      const auto expected = blocks.forces();
      for (const auto &[vertex, force] : part.forces())
        EXPECT_EQ(force, expected.at(vertex)) << i;
    }
  const auto of_blocks = blocks.contact().deep_overlaps(),
             of_part   = part.contact().deep_overlaps();
  ASSERT_TRUE(of_blocks && of_part);
  EXPECT_EQ(of_blocks->n_pairs, of_part->n_pairs);
  EXPECT_EQ(of_blocks->first.a, of_part->first.a);
  EXPECT_EQ(of_blocks->first.b, of_part->first.b);
  EXPECT_EQ(of_blocks->first.step, of_part->first.step);
}

TEST(DeepContact, GoesOnFromACheckpoint)
{
  const Communicator   alone;
  const test::BodyPart part = whole(two_blocks(6));
  Descent              blocks(part, alone), other(part, alone);
  for (unsigned int i = 1; i <= 70; ++i)
    blocks.go_down();
  other.go_on(blocks);
  for (unsigned int i = 1; i <= 50; ++i)
    {
      blocks.go_down();
      other.go_down();
      EXPECT_EQ(blocks.forces(), other.forces()) << i;
    }
  EXPECT_EQ(blocks.contact().deep_overlaps()->n_pairs,
            other.contact().deep_overlaps()->n_pairs);
}
