// What was known of the states of faces, and what has changed since.

#include <rift/contact/known_face_states.h>

#include "../support/random_cuts.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

TEST(KnownFaceStates, SeeEachChangeOnce)
{
  Topology   topology = discretize(make_box({{5, 5, 5}}), {1}).topology;
  const auto last     = static_cast<FaceIndex>(topology.faces.size() - 1);
  // More than two blocks.
  ASSERT_GT(last, 1024u);
  KnownFaceStates known(topology);
  EXPECT_TRUE(known.look().empty());

  const std::vector<FaceIndex> faces = {0, 1, 511, 512, last};
  for (const FaceIndex face : faces)
    topology.face_states[face] = FaceState::cut;
  EXPECT_EQ(known[0], FaceState::intact);
  const auto changes = known.look();
  ASSERT_EQ(changes.size(), faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    {
      EXPECT_EQ(changes[i].face, faces[i]);
      EXPECT_EQ(changes[i].before, FaceState::intact);
      EXPECT_EQ(changes[i].now, FaceState::cut);
      EXPECT_EQ(known[faces[i]], FaceState::cut);
    }
  EXPECT_EQ(known[2], FaceState::intact);
  EXPECT_TRUE(known.look().empty());

  topology.face_states[512] = FaceState::released;
  const auto later          = known.look();
  ASSERT_EQ(later.size(), 1u);
  EXPECT_EQ(later[0].face, 512u);
  EXPECT_EQ(later[0].before, FaceState::cut);
  EXPECT_EQ(later[0].now, FaceState::released);
}

TEST(KnownFaceStates, AreAsTheyAreSet)
{
  Topology        topology = discretize(make_box({{1, 1, 1}}), {1}).topology;
  KnownFaceStates known(topology);
  topology.face_states[3] = FaceState::released;
  known.look();
  known.set(3, FaceState::intact);
  EXPECT_EQ(known[3], FaceState::intact);
  const auto changes = known.look();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].face, 3u);
  EXPECT_EQ(changes[0].before, FaceState::intact);
}

TEST(KnownFaceStates, VerticesOfAFaceAreThoseOfBothCells)
{
  const Topology topology = discretize(make_box({{2, 1, 1}}), {1}).topology;
  for (FaceIndex face = 0; face < topology.faces.size(); ++face)
    for (const VertexIndex vertex : vertices_of(topology, face))
      for (const CellIndex cell : topology.faces[face].cells)
        {
          unsigned int n = 0;
          for (unsigned int c = 0; c < n_corners; ++c)
            n += topology.vertex(cell, c) == vertex;
          EXPECT_EQ(n, 1u);
        }
}
