#include "../support/distributed_body.h"
#include "breaking_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

// Bodies that break in the same way whoever owns their cells.
namespace
{
  using Vector = Vector3<double>;

  constexpr double       h       = 1e-3;
  constexpr unsigned int n_steps = 60;

  /** Breaks through within the few steps of the test. */
  MaterialParameters
  brittle_granite(const double weibull_modulus)
  {
    MaterialParameters material = granite();
    material.weibull_modulus    = weibull_modulus;
    material.fracture_energy_1  = 4;
    material.fracture_energy_2  = 6;
    return material;
  }

  /** A face by the names that it has on all ranks. */
  struct NamedCut
  {
    GlobalCellIndex cell;
    unsigned int    local_face;
  };

  /** What happens to a body, whoever computes it. */
  struct Story
  {
    Body                               whole;
    std::vector<Vector>                displacements, velocities;
    std::vector<std::vector<NamedCut>> cuts;
    double                             weibull_modulus;
  };

  Story
  random_story(const unsigned int seed)
  {
    std::mt19937 random(seed);
    Story        story;
    story.whole = make_box({3, 3, 2}, h, .2, seed);
    order(story.whole);
    story.weibull_modulus = seed % 2 == 0 ? 0 : 5;

    // Strains of about a thousandth, above the strength, and speeds that tear
    // the body to pieces.
    std::uniform_real_distribution<double> value(-1, 1);
    for (std::size_t v = 0; v < story.whole.vertices.size(); ++v)
      {
        story.displacements.emplace_back();
        story.velocities.emplace_back();
        for (unsigned int d = 0; d < dim; ++d)
          {
            story.displacements.back()[d] = 1e-4 * h * value(random);
            story.velocities.back()[d] =
              5 * value(random) + 2e4 * story.whole.vertices[v][d];
          }
      }
    story.cuts.resize(n_steps);
    for (auto &cuts : story.cuts)
      for (unsigned int i = 0; i < random() % 6; ++i)
        cuts.push_back(
          {static_cast<GlobalCellIndex>(random() % story.whole.cells.size()),
           static_cast<unsigned int>(random() % n_corners)});
    return story;
  }

  /** A body, or what a rank has of it, and what moves it. */
  struct Actor
  {
    template <typename AnyBody>
    Actor(const Story                    &story,
          const AnyBody                  &body,
          const std::vector<VertexIndex> &global_vertices,
          const Communicator             &communicator)
      : body(body,
             {brittle_granite(story.weibull_modulus)},
             .25,
             parameters_of(CohesiveModel::extrinsic),
             communicator)
      , exchange(communicator, this->body.topology)
      , dt(.6 * this->body.critical.time_step)
    {
      for (NodeIndex i = 0; i < this->body.state.n_nodes(); ++i)
        {
          const VertexIndex v =
            global_vertices[this->body.topology.node_vertices[i]];
          for (unsigned int d = 0; d < dim; ++d)
            {
              this->body.state.displacement[i][d] = story.displacements[v][d];
              this->body.state.velocity[i][d]     = story.velocities[v][d];
            }
        }
    }

    void
    step(const std::vector<NamedCut> &cuts)
    {
      const Topology        &topology = body.topology;
      std::vector<FaceIndex> faces =
        body.insertion.find_faces(body.state, body.internal_force.hot_cells());
      for (const NamedCut &cut : cuts)
        {
          const CellIndex cell = topology.find_cell(cut.cell);
          if (cell == invalid_index)
            continue;
          const FaceIndex face = topology.cell_faces[cell][cut.local_face];
          if (face != invalid_index &&
              topology.face_states[face] == FaceState::intact)
            faces.push_back(face);
        }
      std::sort(faces.begin(), faces.end());
      faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
      const auto change = body.split(faces);

      ASSERT_TRUE(body.sum_forces());
      advance(body.state, body.activity, dt);
      exchange.send(topology, body.state, change.splits, body.openings);
      const auto news =
        exchange.receive(body.topology, body.state, body.activity);
      body.force.update_nodes(news.vertices);
      body.openings.insert(body.openings.end(),
                           news.openings.begin(),
                           news.openings.end());
      body.start_openings();
    }

    BreakingBody  body;
    GhostExchange exchange;
    double        dt;
  };

  /** That all corners of the cells of a part are where the whole has them. */
  void
  expect_same(const Actor &part, const Actor &whole)
  {
    const Topology &here = part.body.topology, &there = whole.body.topology;
    for (CellIndex cell = 0; cell < here.n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < n_corners && !here.is_padding(cell); ++c)
        {
          const CellIndex same =
            there.find_cell(here.cell_global_indices[cell]);
          const NodeIndex a = here.node(cell, c), b = there.node(same, c);
          for (unsigned int d = 0; d < dim; ++d)
            {
              ASSERT_EQ(part.body.state.displacement[a][d],
                        whole.body.state.displacement[b][d]);
              if (here.is_complete(here.node_vertices[a]))
                {
                  ASSERT_EQ(part.body.state.velocity[a][d],
                            whole.body.state.velocity[b][d]);
                }
            }
        }
  }

  std::int64_t
  n_owned_open_faces(const BreakingBody &body)
  {
    std::int64_t n = 0;
    for (const CohesiveFaceInfo &info : body.force.faces().infos)
      n += body.topology.owns_face(info.face) ? 1 : 0;
    return n;
  }
} // namespace

// Which cells are looked at before faces break must not depend on the rank,
// though only one of them has the weakest face of all, and a rank does not see
// all faces of its ghosts.
TEST(DividedCracks, AllRanksLookAtTheSameCells)
{
  const Communicator communicator(MPI_COMM_WORLD);
  MaterialParameters material = granite();
  material.tensile_strength   = {15e6, 10e6, 5e6};
  material.weibull_modulus    = 3;
  std::int64_t n_unseen       = 0;
  for (unsigned int seed = 1; seed <= 5; ++seed)
    {
      Body whole = make_box({6, 3, 3}, h, .2, seed);
      order(whole);
      std::vector<int> owners(whole.cells.size());
      for (std::size_t i = 0; i < owners.size(); ++i)
        owners[i] = i * communicator.size() / owners.size();
      const BodyPart     part = part_of(whole, owners, communicator.rank());
      const BreakingBody here(part,
                              {material},
                              .25,
                              parameters_of(CohesiveModel::extrinsic),
                              communicator);
      const BreakingBody there(whole, {material});
      const auto        &a = here.bounds.materials[0];
      const auto        &b = there.bounds.materials[0];
      EXPECT_EQ(a->tensile_strength, b->tensile_strength);
      EXPECT_EQ(a->cohesion, b->cohesion);
      for (CellIndex cell = 0; cell < here.topology.n_cell_slots(); ++cell)
        {
          if (here.topology.is_padding(cell))
            continue;
          const CellIndex same =
            there.topology.find_cell(here.topology.cell_global_indices[cell]);
          EXPECT_EQ(here.bounds.factors[cell / batch_size][cell % batch_size],
                    there.bounds.factors[same / batch_size][same % batch_size]);
          for (unsigned int f = 0; f < n_corners; ++f)
            n_unseen += here.topology.cell_faces[cell][f] == invalid_index &&
                        there.topology.cell_faces[same][f] != invalid_index;
        }
    }
  EXPECT_GT(communicator.sum(n_unseen), 10);
}

TEST(DividedCracks, AreTheSameForAnyPartition)
{
  const Communicator communicator(MPI_COMM_WORLD);
  std::size_t        n_failed = 0;
  for (unsigned int seed = 1; seed <= 50; ++seed)
    {
      const Story  story = random_story(seed);
      std::mt19937 random(1000 + seed);
      const auto   owners =
        random_owners(story.whole.cells.size(), communicator.size(), random);

      std::vector<VertexIndex> identity(story.whole.vertices.size());
      std::iota(identity.begin(), identity.end(), 0u);
      BodyPart all{story.whole, 0, identity};
      for (LocalCell &cell : all.body.cells)
        cell.owner = 0;
      Actor          whole(story, all, identity, Communicator());
      const BodyPart own_part =
        part_of(story.whole, owners, communicator.rank());
      Actor part(story, own_part, own_part.global_vertices, communicator);
      ASSERT_EQ(part.dt, whole.dt);
      for (const auto &cuts : story.cuts)
        {
          whole.step(cuts);
          part.step(cuts);
          expect_same(part, whole);
          ASSERT_FALSE(communicator.any(HasFatalFailure())) << "seed " << seed;
        }
      EXPECT_EQ(communicator.sum(n_owned_open_faces(part.body)),
                static_cast<std::int64_t>(whole.body.force.faces().size()));
      EXPECT_GT(whole.body.force.faces().size(), 100u);
      n_failed += whole.body.force.count_faces(Communicator()).failed;
    }
  EXPECT_GT(n_failed, 1000u);
}
