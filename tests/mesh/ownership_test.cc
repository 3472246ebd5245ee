// Who owns what, over random partitions of random bodies.

#include "../support/divided_body.h"

using namespace rift;
using namespace rift::test;

namespace
{
  /** All ranks' views of one body. */
  struct AllParts
  {
    explicit AllParts(const unsigned int seed)
      : random(seed)
    {
      body = random_body(random);
      order(body);
      const int n_ranks = 1 + static_cast<int>(random() % 5);
      owners            = random_owners(body.cells.size(), n_ranks, random);
      for (int rank = 0; rank < n_ranks; ++rank)
        {
          parts.push_back(part_of(body, owners, rank));
          bodies.push_back(discretize(parts.back(), densities));
        }
    }

    std::mt19937              random;
    Body                      body;
    std::vector<int>          owners;
    std::vector<BodyPart>     parts;
    std::vector<DiscreteBody> bodies;
  };

  class Ownership : public testing::TestWithParam<unsigned int>
  {
  };
} // namespace

TEST_P(Ownership, EachCellHasOneOwner)
{
  const AllParts   divided(GetParam());
  std::vector<int> n_owners(divided.body.cells.size(), 0);
  for (std::size_t rank = 0; rank < divided.parts.size(); ++rank)
    {
      const Topology &topology = divided.bodies[rank].topology;
      std::size_t     n_owned  = 0;
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        {
          const GlobalCellIndex global = topology.cell_global_indices[cell];
          EXPECT_EQ(topology.cell_owners[cell],
                    global == invalid_index ? -1 : divided.owners[global]);
          if (topology.owns_cell(cell))
            {
              ++n_owned;
              ++n_owners[global];
            }
        }
      EXPECT_EQ(topology.n_owned_cells(), n_owned);
    }
  EXPECT_EQ(n_owners, std::vector<int>(n_owners.size(), 1));
}

TEST_P(Ownership, EachNodeHasOneOwner)
{
  // Each of the nodes at a vertex, with nothing cut and with much.
  AllParts           divided(GetParam());
  DiscreteBody       whole = discretize(divided.body, densities);
  std::set<Triangle> cuts;
  for (FaceIndex face = 0; face < whole.topology.faces.size(); ++face)
    if (divided.random() % 2 == 0)
      cuts.insert(triangle_of(whole.topology, face));

  const auto n_owned = [&] {
    std::size_t n = 0;
    for (const DiscreteBody &part : divided.bodies)
      n += part.topology.n_owned_nodes();
    return n;
  };
  EXPECT_EQ(n_owned(), whole.topology.n_nodes());

  for (std::size_t rank = 0; rank < divided.parts.size(); ++rank)
    {
      Topology &topology = divided.bodies[rank].topology;
      split_nodes(
        topology,
        faces_at(topology, cuts, divided.parts[rank].global_vertices));
    }
  split_nodes(
    whole.topology,
    faces_at(whole.topology, cuts, identity(whole.topology.n_vertices())));
  EXPECT_EQ(n_owned(), whole.topology.n_nodes());
}

TEST_P(Ownership, EachFaceHasOneOwnerWhichSeesBothSides)
{
  const AllParts          divided(GetParam());
  const DiscreteBody      whole = discretize(divided.body, densities);
  std::map<Triangle, int> n_owners;
  for (FaceIndex face = 0; face < whole.topology.faces.size(); ++face)
    n_owners[triangle_of(whole.topology, face)] = 0;
  for (std::size_t rank = 0; rank < divided.parts.size(); ++rank)
    {
      const Topology &topology = divided.bodies[rank].topology;
      for (FaceIndex face = 0; face < topology.faces.size(); ++face)
        {
          const Triangle t =
            global_triangle(topology,
                            face,
                            divided.parts[rank].global_vertices);
          ASSERT_EQ(n_owners.count(t), 1u);
          n_owners[t] += topology.owns_face(face);
        }
    }
  for (const auto &[triangle, n] : n_owners)
    EXPECT_EQ(n, 1);
}

TEST_P(Ownership, CompleteVerticesHaveAllTheirCells)
{
  const AllParts     divided(GetParam());
  const DiscreteBody whole = discretize(divided.body, densities);
  std::vector<int>   n_complete(whole.topology.n_vertices(), 0);
  for (std::size_t rank = 0; rank < divided.parts.size(); ++rank)
    {
      const DiscreteBody &part     = divided.bodies[rank];
      const Topology     &topology = part.topology;
      for (VertexIndex v = 0; v < topology.n_vertices(); ++v)
        {
          if (!topology.is_complete(v))
            continue;
          const VertexIndex global = divided.parts[rank].global_vertices[v];
          ++n_complete[global];
          const auto global_cells = [](const Topology &t, VertexIndex vertex) {
            std::vector<GlobalCellIndex> cells;
            for (auto c = t.vertex_cells_first(vertex);
                 c != t.vertex_cells_last(vertex);
                 ++c)
              cells.push_back(t.cell_global_indices[*c]);
            return cells;
          };
          EXPECT_EQ(global_cells(topology, v),
                    global_cells(whole.topology, global));
          EXPECT_EQ(part.state.mass[v], whole.state.mass[global]);
        }
    }
  for (const int n : n_complete)
    EXPECT_GE(n, 1);
}

INSTANTIATE_TEST_SUITE_P(Random, Ownership, testing::Range(0u, 30u));
