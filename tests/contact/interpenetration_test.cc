// Cells that lie in each other, on any number of ranks: against all pairs.

#include <rift/contact/contact_surface.h>
#include <rift/contact/interpenetration.h>

#include "../support/distributed_body.h"
#include "../support/random_cuts.h"
#include "../support/single_pair.h"
#include <gtest/gtest.h>

#include <random>

using namespace rift;
using namespace rift::test;

namespace
{
  /** Two boxes of irregular cells, the second moved by `shift`. */
  Body
  two_boxes(const Vector3<double> &shift, const unsigned int seed)
  {
    Body       body   = make_box({{3, 2, 2}}, .3, .1, seed);
    const Body second = make_box({{2, 3, 2}}, .25, .1, seed + 1);
    const auto n      = static_cast<VertexIndex>(body.vertices.size());
    for (const Vector3<double> &x : second.vertices)
      body.vertices.push_back(x + shift);
    for (LocalCell cell : second.cells)
      {
        for (VertexIndex &v : cell.vertices)
          v += n;
        body.cells.push_back(cell);
      }
    order(body);
    return body;
  }

  struct Expected
  {
    std::uint64_t n_pairs = 0;
    double        largest = 0;
  };

  /** Whether a cell has a face on the outer surface. */
  bool
  is_outer(const Topology &topology, const CellIndex cell)
  {
    const auto &faces = topology.cell_faces[cell];
    return !topology.is_padding(cell) &&
           std::count(faces.begin(), faces.end(), invalid_index) > 0;
  }

  /** All pairs of outer cells without a common node, one by one. */
  Expected
  brute_force(const DiscreteBody &whole)
  {
    const Topology &t = whole.topology;
    Expected        result;
    for (CellIndex a = 0; a < t.n_cell_slots(); ++a)
      for (CellIndex b = a + 1; b < t.n_cell_slots(); ++b)
        {
          if (!is_outer(t, a) || !is_outer(t, b))
            continue;
          bool are_connected = false;
          for (unsigned int c = 0; c < n_corners; ++c)
            for (unsigned int d = 0; d < n_corners; ++d)
              are_connected |= t.node(a, c) == t.node(b, d);
          if (are_connected)
            continue;
          const double part = overlap(motion_of(t, whole.state, a).positions,
                                      motion_of(t, whole.state, b).positions)
                                .volume_fraction;
          result.n_pairs += part > .1 ? 1 : 0;
          result.largest = std::max(result.largest, part);
        }
    return result;
  }

  Interpenetration
  find(const Body &body, const Communicator &all, const unsigned int seed)
  {
    std::mt19937 random(seed);
    const auto   owners = random_owners(body.cells.size(), all.size(), random);
    const DiscreteBody local =
      discretize(part_of(body, owners, all.rank()), {1000});
    return find_interpenetration(local.topology, local.state, all);
  }
} // namespace

TEST(Interpenetration, IsThatOfAllPairs)
{
  const Communicator all(MPI_COMM_WORLD);
  for (unsigned int seed = 1; seed <= 10; ++seed)
    {
      const Body     body     = two_boxes({{.55 + .03 * seed, .1, .1}}, seed);
      const Expected expected = brute_force(discretize_ordered(body, {1000}));
      const auto     found    = find(body, all, seed);
      EXPECT_EQ(found.n_pairs, expected.n_pairs) << "seed " << seed;
      EXPECT_EQ(found.largest_part, expected.largest) << "seed " << seed;
      EXPECT_GT(found.n_pairs, 5u);
    }
}

TEST(Interpenetration, IsNoneOfBodiesThatTouchNothing)
{
  const Communicator all(MPI_COMM_WORLD);
  const auto         found = find(two_boxes({{.91, 0, 0}}, 1), all, 1);
  EXPECT_EQ(found.n_pairs, 0u);
  EXPECT_EQ(found.largest_part, 0);
}

namespace
{
  /** Cuts a bar at x = 1 and pushes what lies behind into the other half. */
  void
  push_halves_into_each_other(DiscreteBody &body, const FaceState face_state)
  {
    Topology  &topology = body.topology;
    const auto faces    = faces_in_plane(body, 1);
    body.state.grow(split_nodes(topology, faces));
    for (const FaceIndex face : faces)
      topology.face_states[face] = face_state;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      {
        double centre = 0;
        for (unsigned int c = 0; c < n_corners; ++c)
          centre += .25 * body.state.reference[topology.node(cell, c)][0];
        for (unsigned int c = 0; c < n_corners && centre > 1; ++c)
          body.state.displacement[topology.node(cell, c)][0] = -.15;
      }
  }
} // namespace

TEST(Interpenetration, CountsPairsAcrossFacesThatHaveFailedAlone)
{
  const Communicator all(MPI_COMM_WORLD);
  Body               bar = make_box({{4, 1, 1}}, .5);
  order(bar);
  std::mt19937 random(3);
  const auto   owners = random_owners(bar.cells.size(), all.size(), random);

  std::array<std::uint64_t, 2> n_pairs{};
  for (const FaceState face_state : {FaceState::cut, FaceState::failed})
    {
      DiscreteBody body = discretize(part_of(bar, owners, all.rank()), {1000});
      push_halves_into_each_other(body, face_state);
      n_pairs[face_state == FaceState::failed ? 1 : 0] =
        find_interpenetration(body.topology, body.state, all).n_pairs;
    }
  DiscreteBody whole = discretize_ordered(bar, {1000});
  push_halves_into_each_other(whole, FaceState::failed);
  EXPECT_EQ(n_pairs[1], brute_force(whole).n_pairs);
  // Two faces lie in the plane.
  EXPECT_EQ(n_pairs[0], n_pairs[1] - 2);
}
