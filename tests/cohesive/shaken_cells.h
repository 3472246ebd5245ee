#ifndef rift_tests_cohesive_shaken_cells_h
#define rift_tests_cohesive_shaken_cells_h

#include <gtest/gtest.h>

#include "breaking_body.h"

// Cohesive elements that open, close and slide at random for a hundred
// thousand steps at the time step that a simulation chooses by itself.
namespace rift::test
{
  using Vector = Vector3<double>;

  constexpr double       edge     = 1e-3;
  constexpr unsigned int n_shakes = 100000;

  /** Two cells that share a face. */
  inline Body
  two_cells()
  {
    Body body;
    body.vertices = {{{0, 0, 0}},
                     {{edge, 0, 0}},
                     {{.2 * edge, edge, 0}},
                     {{.3 * edge, .3 * edge, .9 * edge}},
                     {{.4 * edge, .3 * edge, -.8 * edge}}};
    body.cells    = {{0, {{0, 1, 2, 3}}, 0}, {0, {{0, 2, 1, 4}}, 0}};
    return body;
  }

  /** A cell with another one at each of its faces. */
  inline Body
  five_cells()
  {
    Body body;
    body.vertices = {{{edge, edge, edge}},
                     {{edge, 0, 0}},
                     {{0, edge, 0}},
                     {{0, 0, edge}}};
    body.cells    = {{0, {{0, 1, 2, 3}}, 0}};
    const auto &x = body.vertices;
    if (signed_volume(x[0], x[1], x[2], x[3]) < 0)
      std::swap(body.cells[0].vertices[2], body.cells[0].vertices[3]);
    const LocalCell inner = body.cells[0];
    for (unsigned int f = 0; f < n_corners; ++f)
      {
        // The corner opposite to the face, mirrored at its middle.
        Vector apex = {{0, 0, 0}};
        for (const unsigned int c : face_corners[f])
          apex += (2. / 3) * body.vertices[inner.vertices[c]];
        apex -= body.vertices[inner.vertices[f]];
        LocalCell outer = inner;
        std::swap(outer.vertices[(f + 1) % 4], outer.vertices[(f + 2) % 4]);
        outer.vertices[f] = body.vertices.size();
        body.vertices.push_back(apex);
        body.cells.push_back(outer);
      }
    return body;
  }

  /** A slowly varying random motion: a sum of sines that starts at rest. */
  struct Wandering
  {
    Wandering(std::mt19937 &random, const double reach, const double period)
    {
      std::normal_distribution<double>       amplitude(0, reach / 2);
      std::uniform_real_distribution<double> factor(1, 10);
      for (auto &wave : waves)
        {
          wave.rate = 2 * M_PI / (period * factor(random));
          for (unsigned int d = 0; d < dim; ++d)
            wave.amplitude[d] = amplitude(random);
        }
    }

    Vector
    velocity(const double time) const
    {
      Vector v = {{0, 0, 0}};
      for (const auto &wave : waves)
        v += (wave.rate * std::sin(wave.rate * time)) * wave.amplitude;
      return v;
    }

    struct Wave
    {
      double rate;
      Vector amplitude;
    };
    std::array<Wave, 4> waves;
  };

  inline CellIndex
  most_surrounded_cell(const Topology &topology)
  {
    CellIndex      result = 0;
    std::ptrdiff_t n_most = 0;
    for (CellIndex cell = 0; cell < topology.n_cells(); ++cell)
      {
        const auto &faces = topology.cell_faces[cell];
        const auto  n =
          n_corners - std::count(faces.begin(), faces.end(), invalid_index);
        if (n > n_most)
          {
            result = cell;
            n_most = n;
          }
      }
    return result;
  }

  /** What one history has come to. */
  struct Outcome
  {
    EnergyLedger ledger;

    /** Largest energy that can come back, in the two halves of the time, J. */
    double largest_energy[2] = {0, 0};
    double area              = 0;

    /** Dissipated by fracture before a face is released, to which what is left
     * in its elastic branch counts, J. */
    double fracture = 0;

    std::size_t  n_failed    = 0;
    unsigned int n_reversals = 0;
  };

  /**
   * All cells but the one with the most neighbours are moved at random as
   * rigid bodies, each by itself, by about `reach`. Of that one only the corner
   * that is at no face, if there is one, is moved.
   */
  inline Outcome
  shake(const Body        &shape,
        const double       reach,
        const unsigned int seed,
        const std::string &law)
  {
    CohesiveParameters parameters = parameters_of(CohesiveModel::extrinsic);
    parameters.law                = law;
    std::mt19937 random(seed);
    BreakingBody body(shape, {granite()}, .25, parameters);
    State       &state = body.state;
    const double dt    = .7 * body.critical.time_step;
    // Cells are loose from the start, with nothing between them yet.
    body.split(body.all_faces());
    body.sum_forces();
    body.start_openings();

    const CellIndex        loose = most_surrounded_cell(body.topology);
    std::vector<Wandering> motions;
    for (CellIndex cell = 0; cell < body.topology.n_cells(); ++cell)
      motions.emplace_back(random, reach, 400 * dt);

    const auto is_gripped = [&](const CellIndex cell, const NodeIndex node) {
      const auto v = body.topology.node_vertices[node];
      return cell != loose || body.topology.vertex_cells_last(v) ==
                                body.topology.vertex_cells_first(v) + 1;
    };

    const FaceQuadrature quadrature;
    Outcome              outcome;
    double               work = 0, half = 0;
    double               last_opening = 0;
    for (unsigned int step = 0; step < n_shakes; ++step)
      {
        if (!body.sum_forces())
          {
            ADD_FAILURE() << "a cell has failed at step " << step;
            return outcome;
          }
        // Grips: the force that makes a node move as prescribed, whose work is
        // counted half before and half after the kick, as the ledger wants.
        double now = 0, next = 0;
        for (CellIndex cell = 0; cell < body.topology.n_cells(); ++cell)
          for (unsigned int c = 0; c < n_corners; ++c)
            {
              const NodeIndex node = body.topology.node(cell, c);
              if (!is_gripped(cell, node))
                continue;
              const Vector before = state.velocity[node].vector();
              const Vector after = motions[cell].velocity(state.time + .5 * dt);
              const Vector force = (state.mass[node] / dt) * (after - before);
              const Vector grip  = force - state.force[node].vector();
              now += .5 * dt * dot(grip, before);
              next += .5 * dt * dot(grip, after);
              for (unsigned int d = 0; d < dim; ++d)
                state.force[node][d] = force[d];
            }
        work += half + now;
        half = next;

        Energies energies    = body.energies(dt);
        energies.at("loads") = work;
        outcome.ledger.enter(energies);
        const auto &states = body.topology.face_states;
        if (std::find(states.begin(), states.end(), FaceState::released) ==
            states.end())
          outcome.fracture = energies["fracture"];
        double &largest = outcome.largest_energy[step < n_shakes / 2 ? 0 : 1];
        largest         = std::max(largest,
                           energies["kinetic"] + energies["strain"] +
                             energies["cohesive"]);
        const FaceKinematics kinematics(body.force.faces().batches[0], state);
        const double         opening = kinematics.jump_at(quadrature, 0)[0][0];
        outcome.n_reversals += opening * last_opening < 0;
        last_opening = opening;
        body.move(dt);
      }
    for (const CohesiveBatch &batch : body.force.faces().batches)
      for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
        {
          Vector edges[2];
          for (unsigned int e = 0; e < 2; ++e)
            for (unsigned int d = 0; d < dim; ++d)
              edges[e][d] = batch.edges[e][d][lane];
          outcome.area += .5 * norm(cross(edges[0], edges[1]));
        }
    outcome.n_failed = body.force.count_faces(Communicator()).failed;
    return outcome;
  }

  /**
   * @param reach of the random motion, m; full separation takes 7e-5.
   * @param tolerance of the ledger, of the largest energy in play. What is
   *   left is the penalty of failed faces, which begins and ends within steps.
   */
  inline Outcome
  check_shaken(const Body        &shape,
               const double       reach,
               const double       tolerance,
               const std::string &law)
  {
    const Outcome   outcome  = shake(shape, reach, 2, law);
    const Energies &energies = outcome.ledger.energies();
    const auto      strength = granite_strength();
    EXPECT_LT(outcome.ledger.largest_relative_residual(), tolerance);

    // The motion is the same all the time: so must be the energies.
    EXPECT_LT(outcome.largest_energy[1], 3 * outcome.largest_energy[0]);

    // No path of mixed modes takes more than this, besides what the elastic
    // branch has up to its peak.
    EXPECT_GT(outcome.fracture, 0);
    EXPECT_LT(
      outcome.fracture,
      1.1 * outcome.area *
        std::hypot(strength.fracture_energy_1, strength.fracture_energy_2));
    EXPECT_GE(energies["friction"], 0);
    return outcome;
  }
} // namespace rift::test

#endif
