#include "../support/random_cuts.h"

using namespace rift;
using namespace rift::test;

// The cases of Fig. 3 of Fukuda et al. (2021): a node to be split inside of
// the mesh, on a surface, on an edge, and all three nodes on different edges;
// and a face cut alone with 0, 1, 2 and 3 edges on the surface.
namespace
{
  /** Number of nodes at the vertex that was at this place. */
  std::size_t
  n_nodes_at(const DiscreteBody &body, const Vector3<double> &place)
  {
    std::size_t n = 0;
    for (const NodalVector &x : body.state.reference)
      n += norm(x.vector() - place) < 1e-12;
    return n;
  }

  /**
   * Cuts the faces of the plane x = 1 that have a vertex, one after the other,
   * in a box of 2 x 2 x 2 cubes: the vertex must part at the last one.
   */
  void
  expect_fan_parts_at_last(const Vector3<double> &place)
  {
    DiscreteBody           body = discretize(make_box({2, 2, 2}), densities);
    std::vector<FaceIndex> fan;
    for (const FaceIndex face : faces_in_plane(body, 1))
      for (const VertexIndex v : triangle_of(body.topology, face))
        if (norm(body.state.reference[v].vector() - place) < 1e-12)
          fan.push_back(face);
    ASSERT_GE(fan.size(), 1u);
    for (const FaceIndex face : fan)
      {
        EXPECT_EQ(n_nodes_at(body, place), 1u);
        cut(body, {face});
      }
    EXPECT_EQ(n_nodes_at(body, place), 2u);
  }

  /** Two tetrahedra with a face in common. */
  Body
  two_cells()
  {
    Body body;
    body.vertices = {{{0, 0, 0}},
                     {{1, 0, 0}},
                     {{0, 1, 0}},
                     {{0, 0, 1}},
                     {{.3, .3, -1}}};
    body.cells    = {{0, {{0, 1, 2, 3}}, 0}, {0, {{0, 2, 1, 4}}, 0}};
    return body;
  }

  /**
   * Cuts each interior face alone. Expected is what the link of each corner
   * says: it splits where both edges of the face that meet there lie on the
   * surface of the body.
   *
   * @return how many faces had 0, 1, 2, 3 edges on the surface.
   */
  std::array<unsigned int, 4>
  check_isolated_faces(const Body &shape)
  {
    const DiscreteBody intact   = discretize(shape, densities);
    const Topology    &topology = intact.topology;
    std::set<std::pair<VertexIndex, VertexIndex>> surface_edges;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      for (unsigned int f = 0; f < 4 && !topology.is_padding(cell); ++f)
        if (topology.cell_faces[cell][f] == invalid_index)
          for (const unsigned int a : face_corners[f])
            for (const unsigned int b : face_corners[f])
              surface_edges.emplace(topology.vertex(cell, a),
                                    topology.vertex(cell, b));

    std::array<unsigned int, 4> n_faces{};
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      {
        const Triangle        t = triangle_of(topology, face);
        std::set<VertexIndex> expected;
        unsigned int          n_edges = 0;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const VertexIndex here = t[c], next = t[(c + 1) % 3],
                              last = t[(c + 2) % 3];
            n_edges += surface_edges.count({here, next});
            if (surface_edges.count({here, next}) > 0 &&
                surface_edges.count({here, last}) > 0)
              expected.insert(here);
          }
        ++n_faces[n_edges];
        EXPECT_EQ(expected.size(), n_edges < 2 ? 0 : 2 * n_edges - 3);

        DiscreteBody          body = intact;
        std::set<VertexIndex> split;
        for (const NodeSplit &s : cut(body, {face}).splits)
          {
            EXPECT_EQ(s.parts.size(), 2u);
            split.insert(body.topology.node_vertices[s.parts[0]]);
          }
        EXPECT_EQ(split, expected) << "face " << face;
      }
    return n_faces;
  }
} // namespace

TEST(NodeSplitter, IsolatedFaceSplitsBetweenEdgesOnTheSurface)
{
  const auto of_box = check_isolated_faces(make_box({3, 3, 3}));
  EXPECT_GT(of_box[0], 0u);
  EXPECT_GT(of_box[1], 0u);
  EXPECT_GT(of_box[2], 0u);
  // A face with all edges on the surface is free at once.
  const auto of_two = check_isolated_faces(two_cells());
  EXPECT_EQ(of_two, (std::array<unsigned int, 4>{{0, 0, 0, 1}}));
}

TEST(NodeSplitter, VertexInsideParts)
{
  expect_fan_parts_at_last({{1, 1, 1}});
}

TEST(NodeSplitter, VertexOnSurfaceParts)
{
  expect_fan_parts_at_last({{1, 0, 1}});
}

TEST(NodeSplitter, VertexOnEdgeParts)
{
  expect_fan_parts_at_last({{1, 0, 0}});
  expect_fan_parts_at_last({{1, 2, 0}});
}

TEST(NodeSplitter, ThreeVerticesOnDifferentEdgesPart)
{
  DiscreteBody body = discretize(two_cells(), densities);
  ASSERT_EQ(body.topology.faces.size(), 1u);
  const TopologyChange change = cut(body, {0});
  ASSERT_EQ(change.splits.size(), 3u);
  for (const NodeSplit &split : change.splits)
    EXPECT_EQ(split.parts.size(), 2u);
  EXPECT_EQ(body.topology.n_nodes(), 8u);
}

TEST(NodeSplitter, PlaneOfFacesPartsTheBody)
{
  DiscreteBody body = discretize(make_box({2, 3, 4}), densities);
  cut(body, faces_in_plane(body, 1));
  EXPECT_EQ(body.topology.n_nodes(), 3u * 4 * 5 + 4 * 5);
  for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
    {
      const Face &f = body.topology.faces[face];
      for (const unsigned int c : face_corners[f.local_faces[0]])
        {
          const VertexIndex  v = body.topology.vertex(f.cells[0], c);
          const unsigned int other =
            body.topology.corner_at_vertex(f.cells[1], v);
          EXPECT_EQ(body.topology.node(f.cells[0], c) ==
                      body.topology.node(f.cells[1], other),
                    body.topology.face_states[face] == FaceState::intact);
        }
    }
}
