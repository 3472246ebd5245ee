#include "../cohesive/shaken_cells.h"
#include "../support/random_cuts.h"
#include "bonded_body.h"

using namespace rift;
using namespace rift::test;

namespace
{
  /** A block that is cut at random while random forces shake it. */
  struct ShakenBlock
  {
    explicit ShakenBlock(const unsigned int seed)
      : random(seed)
      , body(make_box({{2, 1, 1}}, edge, .1, seed))
      , faces(shuffled_faces(body.topology, random))
    {
      for (CellIndex cell = 0; cell < body.topology.n_cells(); ++cell)
        motions.emplace_back(random, 1e-4, 1000 * dt);
    }

    /** Work of the forces before and after the kick; `after` once it has been. */
    double
    work(const std::vector<Vector> &force) const
    {
      double sum = 0;
      for (NodeIndex node = 0; node < body.state.n_nodes(); ++node)
        sum += .5 * dt * dot(force[node], body.state.velocity[node].vector());
      return sum;
    }

    /** Cells are drawn to places that wander about. */
    std::vector<Vector>
    forces() const
    {
      constexpr double    rate = 2e5;
      std::vector<Vector> result(body.state.n_nodes(), {{0, 0, 0}});
      for (CellIndex cell = 0; cell < body.topology.n_cells(); ++cell)
        for (unsigned int c = 0; c < n_corners; ++c)
          {
            const NodeIndex node = body.topology.node(cell, c);
            const double    mass = .25 * body.materials[0].density *
                                body.discrete.reference[cell / batch_size]
                                  .volume[cell % batch_size];
            result[node] +=
              (rate * mass) *
              (motions[cell].velocity(body.state.time) -
               (.1 * rate) * body.state.displacement[node].vector());
          }
      return result;
    }

    static constexpr double dt = 2e-8;
    std::mt19937            random;
    BondedBody              body;
    std::vector<FaceIndex>  faces;
    std::vector<Wandering>  motions;
  };
} // namespace

TEST(ShakenBonds, EnergiesAreKeptOver100000Steps)
{
  ShakenBlock  block(3);
  BondedBody  &body = block.body;
  EnergyLedger ledger;
  double       loads = 0, unexplained = 0, largest[2] = {0, 0};
  std::normal_distribution<double> value;
  for (unsigned int step = 0; step < n_shakes; ++step)
    {
      if (step % 500 == 100 && !block.faces.empty())
        {
          const Vector m = {
            {value(block.random), value(block.random), value(block.random)}};
          body.split({block.faces.back()}, (1 / norm(m)) * m, block.dt);
          block.faces.pop_back();
        }
      ASSERT_TRUE(body.sum_forces()) << "a cell has failed at step " << step;
      const auto force = block.forces();
      for (NodeIndex node = 0; node < body.state.n_nodes(); ++node)
        for (unsigned int d = 0; d < dim; ++d)
          body.state.force[node][d] += force[node][d];
      body.hold(block.dt);
      loads += block.work(force);
      const Energies energies = body.energies(block.dt, loads);
      ledger.enter(energies);
      double &most = largest[step < n_shakes / 2 ? 0 : 1];
      most         = std::max(most, energies["kinetic"] + energies["strain"]);
      body.kick_and_drift(block.dt);
      unexplained = std::max(unexplained, std::abs(body.unexplained_energy()));
      loads += block.work(force);
    }
  const BondEnergy used = body.used();
  EXPECT_TRUE(block.faces.empty());
  EXPECT_LT(ledger.largest_relative_residual(), 1e-6);
  // Rounding of the work of all nodes in all steps.
  EXPECT_LT(unexplained, 1e-7 * (used.fracture + used.friction));
  EXPECT_GT(used.fracture, 0);
  EXPECT_GT(used.friction, 0);
  EXPECT_GT(largest[1], 0);
  EXPECT_LT(largest[1], 10 * largest[0]);
}
