// Probes on several ranks.

#include <rift/base/exceptions.h>
#include <rift/io/probes.h>
#include <rift/solid/internal_force.h>

#include "../support/divided_body.h"
#include "../support/elastic_body.h"
#include "../temporary_directory.h"

using namespace rift;
using namespace rift::test;
using Component = ProbeParameters::Component;

namespace
{
  const Communicator this_rank_alone;

  MaterialParameters
  rock(const double density)
  {
    MaterialParameters material;
    material.density        = density;
    material.youngs_modulus = 40e9;
    material.poissons_ratio = .2;
    return material;
  }

  /** Values of probes of all kinds, at a point or over a boundary. */
  std::vector<double>
  values(const DiscreteBody    &body,
         const std::string     &boundary,
         const Vector3<double> &point,
         const Surface         &surface,
         const Communicator    &communicator)
  {
    const InternalForce force(body.topology,
                              body.reference,
                              {make_elasticity(rock(densities[0])),
                               make_elasticity(rock(densities[1]))});
    std::vector<Probe>  probes;
    for (const Component &component :
         {Component{"displacement", "m", FieldLocation::node, 0},
          Component{"velocity", "m/s", FieldLocation::node, 2},
          Component{"stress", "Pa", FieldLocation::cell, 4},
          Component{"pressure", "Pa", FieldLocation::cell, 0}})
      probes.emplace_back(body.topology,
                          body.reference,
                          body.state,
                          ProbeParameters{"p", component, "", boundary, point},
                          surface,
                          communicator);
    FieldList fields(body.state, 0);
    declare_nodal_fields(fields);
    InternalForce::declare_fields(fields, &force);
    return probe_values(probes, body.topology, fields, communicator);
  }

  /** Part of a box, undeformed, that this rank sees. */
  struct BoxPart
  {
    explicit BoxPart(const unsigned int seed)
    {
      body = make_box({3, 2, 2}, 1, 0);
      order(body);
      std::mt19937 random(seed);
      local =
        discretize(part_of(body,
                           random_owners(body.cells.size(), all.size(), random),
                           all.rank()),
                   densities);
    }

    /** Displacement x at a point. */
    double
    value_at(const Vector3<double> &point) const
    {
      return values(local, "", point, {}, all)[0];
    }

    const Communicator all{MPI_COMM_WORLD};
    Body               body;
    DiscreteBody       local{Topology({}, 0), {}, {}};
  };
} // namespace

TEST(Probes, AreTheSameToTheLastBitOnAnyNumberOfRanks)
{
  const Communicator all(MPI_COMM_WORLD);
  for (unsigned int seed = 0; seed < 40; ++seed)
    {
      DividedBody divided(seed, all);

      // At a vertex, on an edge, on a face and inside of a cell: at cuts, the
      // displacement tells which cell it is.
      std::mt19937 random(seed);
      const auto  &cell =
        divided.body.cells[random() % divided.body.cells.size()];
      Vector3<double> point = {{0, 0, 0}};
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          point += divided.body.vertices[cell.vertices[c]];
          const Vector3<double> mean = (1. / (c + 1)) * point;
          EXPECT_EQ(values(divided.local, "", mean, {}, all),
                    values(divided.whole, "", mean, {}, this_rank_alone))
            << "seed " << seed << ", " << c + 1 << " corners";
        }

      // Faces of ghosts that look free because not all is seen do no harm.
      EXPECT_EQ(values(divided.local,
                       "all",
                       {},
                       whole_surface(divided.local.topology),
                       all),
                values(divided.whole,
                       "all",
                       {},
                       whole_surface(divided.whole.topology),
                       this_rank_alone))
        << "seed " << seed;
    }
}

TEST(Probes, LinearFieldAtAPoint)
{
  BoxPart box(1);
  State  &state = box.local.state;
  for (NodeIndex node = 0; node < state.n_nodes(); ++node)
    state.displacement[node][0] = 1 + 2 * state.reference[node][0] +
                                  3 * state.reference[node][1] -
                                  state.reference[node][2];
  for (const Vector3<double> &point : {Vector3<double>{{0, 0, 0}},
                                       Vector3<double>{{1, 1, 1}},
                                       Vector3<double>{{2.3, 1.1, .4}},
                                       Vector3<double>{{3, 2, 1.5}}})
    EXPECT_NEAR(box.value_at(point),
                1 + 2 * point[0] + 3 * point[1] - point[2],
                1e-14);
}

TEST(Probes, LinearFieldOverABoundary)
{
  // The mean over x = 3 is the value in its middle.
  BoxPart box(2);
  State  &state = box.local.state;
  for (NodeIndex node = 0; node < state.n_nodes(); ++node)
    state.displacement[node][0] = state.reference[node][0] +
                                  5 * state.reference[node][1] +
                                  7 * state.reference[node][2];
  EXPECT_NEAR(
    values(box.local, "x_max", {}, plane_surface(box.local, 0, 3), box.all)[0],
    3 + 5 + 7,
    1e-14);
}

TEST(Probes, OfAFieldThatTheSceneDoesNotHave)
{
  BoxPart     box(4);
  const Probe probe(
    box.local.topology,
    box.local.reference,
    box.local.state,
    {"p", {"force", "N", FieldLocation::material, 0}, "a", "", {}},
    {},
    box.all);
  EXPECT_EQ(probe.header(), "p [N]");
  EXPECT_EQ(
    message_of<InputError>([&] { probe.sum(box.local.topology, FieldList()); }),
    "subsection \"Probe p\": nothing in this scene has the field "
    "\"force\".");
}

TEST(Probes, PointOutsideIsAnErrorOnAllRanks)
{
  BoxPart box(3);
  EXPECT_EQ(message_of<InputError>([&] {
              box.value_at({{3.001, 1, 1}});
            }),
            "the point (3.001, 1, 1) m of subsection \"Probe p\" lies in no "
            "cell of the mesh. Move it into the body; coordinates are in "
            "metres.");
}
