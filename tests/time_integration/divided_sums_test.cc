// Energies, works and the safe time step of a body that is divided among the
// ranks: the same to the last bit as of the whole body.

#include <rift/loading/body_force.h>
#include <rift/loading/prescribed_motion.h>
#include <rift/loading/surface_load.h>
#include <rift/solid/damping.h>
#include <rift/time_integration/central_difference.h>
#include <rift/time_integration/energy_ledger.h>

#include "../support/distributed_body.h"
#include "../support/elastic_body.h"
#include "../support/random_cuts.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  constexpr double time_step = 1e-5;

  std::vector<MaterialParameters>
  materials_of(Random &random)
  {
    std::vector<MaterialParameters> materials = {granite(),
                                                 random_anisotropic(random)};
    for (unsigned int i = 0; i < 2; ++i)
      materials[i].density = densities[i];
    return materials;
  }

  std::vector<Elasticity>
  laws_of(const std::vector<MaterialParameters> &materials)
  {
    std::vector<Elasticity> laws;
    for (const MaterialParameters &material : materials)
      laws.push_back(make_elasticity(material));
    return laws;
  }

  BoundaryParameters
  boundary()
  {
    BoundaryParameters result;
    result.name     = "all";
    result.pressure = "1e5*(1+t)";
    result.traction = {{"2e5", "", "3e5*t"}};
    result.velocity = {{"", "1e-2*(1+t)", ""}};
    return result;
  }

  /** A body, or a part of one, with everything that does work on it. */
  struct LoadedBody
  {
    LoadedBody(DiscreteBody                           body,
               const Surface                         &surface,
               const std::vector<MaterialParameters> &materials)
      : body(std::move(body))
      , force(topology(), this->body.reference, laws_of(materials))
      , activity(topology())
      , gravity(Vector3<double>{{1, 2, -9.81}})
      , load(topology(), surface, boundary())
      , motion(topology(), {{surface, boundary()}})
      , damping(topology(), this->body.reference, {3e5, 0})
    {
      activity.wake_all(topology());
    }

    const Topology &
    topology() const
    {
      return body.topology;
    }

    /** The energies after a step with this state of the whole body. */
    Energies
    step(const State &state, const Communicator &communicator)
    {
      const double time = body.state.time;
      body.state        = state;
      body.state.time   = time;
      load.add_to(body.state, activity, time_step);
      damping.add_to(body.state, activity);
      motion.impose(body.state, activity, time_step);
      load.count_work(body.state, time_step);
      damping.count_work(body.state, time_step);
      body.state.time += time_step;

      EnergyTable sums;
      sums["kinetic"]  = kinetic_energy(topology(), body.state, time_step);
      sums["strain"]   = force.strain_energy(body.state);
      sums["cohesive"] = load.work().sum();
      sums["fracture"] = motion.work().sum();
      sums["friction"] = gravity.work(topology(), body.state);
      sums["damping"]  = damping.work().sum();
      return sums.total(communicator);
    }

    Archive
    archive()
    {
      Archive result;
      load.work().save("load", result);
      motion.work().save("motion", result);
      damping.work().save("damping", result);
      return result;
    }

    /** Goes on where another has stopped, as after a restart: rank 0 holds the
     * sums of all. */
    void
    go_on_from(LoadedBody &other, const Communicator &communicator)
    {
      body.state.time        = other.body.state.time;
      const Archive of_other = other.archive();
      Archive       of_all;
      for (const auto &[name, entry] : of_other.entries())
        for (const std::string &bytes : communicator.all_gather(entry.bytes))
          of_all.merge(name, {entry.kind, entry.item_size, bytes});
      if (!communicator.is_root())
        of_all.clear_sums();
      load.work().load("load", of_all);
      motion.work().load("motion", of_all);
      damping.work().load("damping", of_all);
    }

    DiscreteBody     body;
    InternalForce    force;
    Activity         activity;
    BodyForce        gravity;
    SurfaceLoad      load;
    PrescribedMotion motion;
    Damping          damping;
  };

  State
  random_state(State state, Random &random)
  {
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      {
        const auto numbers = random_matrix(random);
        for (unsigned int d = 0; d < 3; ++d)
          {
            state.displacement[i][d] = .1 * numbers[0][d];
            state.velocity[i][d]     = numbers[1][d];
            state.force[i][d]        = 1e6 * numbers[2][d];
          }
      }
    return state;
  }

  /**
   * What a rank knows of the state of the whole body: of nodes at incomplete
   * vertices neither mass nor force.
   */
  State
  part_of(const State &whole, const BodyPart &part, const Topology &topology)
  {
    State state;
    state.resize(topology.n_nodes());
    for (NodeIndex i = 0; i < topology.n_nodes(); ++i)
      {
        const VertexIndex global = part.global_vertices[i];
        state.reference[i]       = whole.reference[global];
        state.displacement[i]    = whole.displacement[global];
        state.velocity[i]        = whole.velocity[global];
        state.force[i]           = whole.force[global];
        state.mass[i]            = whole.mass[global];
        if (topology.is_complete(i))
          continue;
        state.mass[i]     = std::numeric_limits<double>::infinity();
        state.force[i][0] = state.force[i][1] = state.force[i][2] =
          std::numeric_limits<double>::quiet_NaN();
      }
    return state;
  }

  Surface
  part_of(const Surface  &surface,
          const Topology &whole,
          const Topology &topology)
  {
    Surface result;
    for (const CellFace &face : surface)
      {
        const CellIndex cell =
          topology.find_cell(whole.cell_global_indices[face.cell]);
        if (cell != invalid_index)
          result.push_back({cell, face.local_face});
      }
    return result;
  }

  void
  expect_equal(const Energies &a, const Energies &b)
  {
    EXPECT_EQ(a["kinetic"], b["kinetic"]);
    EXPECT_EQ(a["strain"], b["strain"]);
    EXPECT_EQ(a["cohesive"], b["cohesive"]);
    EXPECT_EQ(a["fracture"], b["fracture"]);
    EXPECT_EQ(a["friction"], b["friction"]);
    EXPECT_EQ(a["damping"], b["damping"]);
  }

  class DividedSums : public testing::TestWithParam<unsigned int>
  {
  protected:
    const Communicator all{MPI_COMM_WORLD};
  };
} // namespace

TEST_P(DividedSums, EnergiesAreThoseOfTheWhole)
{
  Random     random(GetParam());
  const auto materials = materials_of(random);
  Body       body      = random_body(random);
  order(body);
  LoadedBody     whole(discretize(body, densities),
                   whole_surface(discretize(body, densities).topology),
                   materials);
  const BodyPart part =
    part_of(body,
            random_owners(body.cells.size(), all.size(), random),
            all.rank());
  const DiscreteBody discrete = discretize(part, densities);
  const Surface      surface  = part_of(whole_surface(whole.topology()),
                                  whole.topology(),
                                  discrete.topology);
  LoadedBody         own(discrete, surface, materials);
  LoadedBody         restarted(discrete, surface, materials);

  for (unsigned int n = 0; n < 4; ++n)
    {
      const State    state    = random_state(whole.body.state, random);
      const Energies expected = whole.step(state, Communicator());
      if (n == 3)
        restarted.go_on_from(own, all);
      LoadedBody &own_now = n < 3 ? own : restarted;
      expect_equal(own_now.step(part_of(state, part, own.topology()), all),
                   expected);
      // All of it is in play.
      for (const double energy : {expected["kinetic"],
                                  expected["strain"],
                                  expected["cohesive"],
                                  expected["fracture"],
                                  expected["friction"]})
        EXPECT_GT(std::abs(energy), 0);
    }
}

TEST_P(DividedSums, TimeStepIsThatOfTheWhole)
{
  Random     random(GetParam());
  const auto materials = materials_of(random);
  // Of a body and of one in which many cells are alike.
  for (Body body : {random_body(random), make_box({{2, 3, 4}})})
    {
      order(body);
      const BodyPart part =
        part_of(body,
                random_owners(body.cells.size(), all.size(), random),
                all.rank());
      const DiscreteBody whole = discretize(body, densities);
      const DiscreteBody own   = discretize(part, densities);
      for (const double viscosity : {0., 1e-300, 1e4, 1e7})
        {
          std::vector<MaterialLimits> limits;
          for (const MaterialParameters &material : materials)
            limits.push_back({material.name,
                              stiffness_matrix(make_elasticity(material)),
                              material.density,
                              limits.empty() ? viscosity : 0,
                              .25});
          const CriticalTimeStep expected = critical_time_step(whole.topology,
                                                               whole.reference,
                                                               limits,
                                                               Communicator());
          const CriticalTimeStep found =
            critical_time_step(own.topology, own.reference, limits, all);
          EXPECT_EQ(found.time_step, expected.time_step);
          EXPECT_EQ(found.frequency_squared, expected.frequency_squared);
          EXPECT_EQ(found.limited_by, expected.limited_by);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Random, DividedSums, testing::Range(0u, 20u));
