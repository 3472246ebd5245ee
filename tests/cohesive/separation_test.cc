#include "breaking_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

// Bars of tetrahedra that are cut across a plane of faces and pulled or
// sheared apart.
namespace
{
  using Vector = Vector3<double>;

  constexpr double edge = 1e-3;

  /** Faces cross a section of 2 x 2 cubes. */
  constexpr double section = 4 * edge * edge;

  struct CutBar
  {
    explicit CutBar(const double              stiffness_factor = .25,
                    const unsigned int        length           = 2,
                    const Vector             &strain           = {{0, 0, 0}},
                    const MaterialParameters &material         = granite())
      : body(make_box({length, 2, 2}, edge), {material}, stiffness_factor)
    {
      // Before the cut, so that there is something between the halves.
      for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          body.state.displacement[i][d] =
            body.state.reference[i][0] * strain[d];
      body.split(body.faces_in_plane(0, .5 * length * edge));
      body.sum_forces();
      body.start_openings();
      EXPECT_EQ(body.force.faces().size(), 8u);
      is_plus.resize(body.state.n_nodes(), false);
      for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < 4 && !body.topology.is_padding(cell); ++c)
          {
            double centre = 0;
            for (unsigned int i = 0; i < 4; ++i)
              centre +=
                .25 * body.state.reference[body.topology.node(cell, i)][0];
            if (centre > .5 * length * edge)
              is_plus[body.topology.node(cell, c)] = true;
          }
    }

    /** Force on the half that moves, N. */
    Vector
    force_on_plus() const
    {
      Vector sum = {{0, 0, 0}};
      for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
        if (is_plus[i])
          sum += body.state.force[i].vector();
      return sum;
    }

    /** Work to move one half as a rigid body in n steps, J. */
    double
    separate(const Vector &path, const unsigned int n)
    {
      double work = 0;
      body.sum_forces();
      for (unsigned int i = 0; i < n; ++i)
        {
          const Vector before = force_on_plus();
          for (NodeIndex node = 0; node < body.state.n_nodes(); ++node)
            if (is_plus[node])
              for (unsigned int d = 0; d < dim; ++d)
                body.state.displacement[node][d] += path[d] / n;
          body.sum_forces();
          work -= .5 / n * dot(before + force_on_plus(), path);
        }
      return work;
    }

    BreakingBody      body;
    std::vector<bool> is_plus;
  };

  /** Friction times what the cohesion carries of the shear, over the slope:
   * what sliding of the present elastic branches will give to friction, J. */
  double
  friction_of_branches(BreakingBody &body)
  {
    const FaceQuadrature quadrature;
    const CohesiveFaces &faces    = body.force.faces();
    const auto          &elements = elements_of<ExtrinsicLaw>(body.force);
    double               sum      = 0;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (unsigned int q = 0; q < n_face_points; ++q)
        {
          const CohesiveBatch &batch = faces.batches[i / batch_size];
          const unsigned int   lane  = i % batch_size;
          const Vector         t     = elements.point(i, q).traction;
          const double         friction =
            granite_strength().tan_friction_angle * std::max(-t[0], 0.);
          sum += quadrature.weight[q] * batch.area[lane] * friction *
                 std::max(std::hypot(t[1], t[2]) - friction, 0.) /
                 elements.constants(i).stiffness;
        }
    return sum;
  }

  /** Work of the way to a peak traction in all faces, J. */
  double
  rising_work(BreakingBody &body, const double peak)
  {
    const CohesiveFaces &faces    = body.force.faces();
    const auto          &elements = elements_of<ExtrinsicLaw>(body.force);
    double               sum      = 0;
    for (std::size_t i = 0; i < faces.size(); ++i)
      sum += faces.batches[i / batch_size].area[i % batch_size] * peak * peak /
             (2 * elements.constants(i).stiffness);
    return sum;
  }

  double
  full_opening()
  {
    return granite_strength().fracture_energy_1 /
           (Softening::integral * granite_strength().tensile_strength);
  }

  double
  full_slip()
  {
    return granite_strength().fracture_energy_2 /
           (Softening::integral * granite_strength().cohesion);
  }

  void
  expect_separation(CutBar       &bar,
                    const Vector &path,
                    const double  energy,
                    const double  peak,
                    const int     n_steps)
  {
    const double expected = energy * section + rising_work(bar.body, peak);
    const double work     = bar.separate(path, n_steps);
    EXPECT_NEAR(work, expected, 1e-3 * expected);
    EXPECT_EQ(bar.body.force.count_faces(Communicator()).failed, 8u);
    for (const CohesiveFaceInfo &info : bar.body.force.faces().infos)
      EXPECT_EQ(bar.body.topology.face_states[info.face], FaceState::failed);
    const CohesiveEnergy ledger = bar.body.force.energy(bar.body.state);
    EXPECT_NEAR(ledger.fracture.value(), work, 1e-9 * work);
    EXPECT_NEAR(ledger.recoverable.value(), 0, 1e-9 * work);
    EXPECT_NEAR(ledger.friction.value(), 0, 1e-9 * work);
  }
} // namespace

TEST(Separation, OpeningUsesUpTheFractureEnergyOfTheArea)
{
  CutBar bar;
  expect_separation(bar,
                    {{1.1 * full_opening(), 0, 0}},
                    granite_strength().fracture_energy_1,
                    granite_strength().tensile_strength,
                    5000);
}

// Axis 1, 2 or 3 of the material along the bar: a cut across it takes what is
// given for planes across that axis.
TEST(Separation, FractureEnergyByDirection)
{
  const Vector       energies_1 = {{400, 300, 200}};
  const Vector       energies_2 = {{500, 900, 700}};
  MaterialParameters material   = granite();
  material.fracture_energy_1    = {energies_1[0], energies_1[1], energies_1[2]};
  material.fracture_energy_2    = {energies_2[0], energies_2[1], energies_2[2]};
  for (unsigned int axis = 0; axis < 3; ++axis)
    {
      material.axis_1 = material.axis_2 = {{0, 0, 0}};
      material.axis_1[(3 - axis) % 3]   = 1;
      material.axis_2[(4 - axis) % 3]   = 1;
      CutBar opening(.25, 2, {{0, 0, 0}}, material);
      expect_separation(opening,
                        {{1.1 * full_opening(), 0, 0}},
                        energies_1[axis],
                        granite_strength().tensile_strength,
                        5000);
      CutBar sliding(.25, 2, {{0, 0, 0}}, material);
      expect_separation(sliding,
                        {{0, 2 * full_slip(), 0}},
                        energies_2[axis],
                        granite_strength().cohesion,
                        5000);
    }
}

TEST(Separation, ShearingUsesUpTheFractureEnergyOfTheArea)
{
  CutBar bar;
  expect_separation(bar,
                    {{0, .6 * 1.3 * full_slip(), -.8 * 1.3 * full_slip()}},
                    granite_strength().fracture_energy_2,
                    granite_strength().cohesion,
                    5000);
}

// The closed form of mohr_coulomb_energy_test.cc, which on a straight path
// holds for stiff elastic branches.
TEST(Separation, MixedModeHasTheClosedForm)
{
  for (const double angle : {.4, 1.1})
    {
      CutBar bar(2000);
      expect_separation(bar,
                        {{1.01 * full_opening() * std::cos(angle),
                          0,
                          1.01 * full_slip() * std::sin(angle)}},
                        granite_strength().fracture_energy_1 * std::cos(angle) +
                          granite_strength().fracture_energy_2 *
                            std::sin(angle),
                        0,
                        50000);
    }
}

// The elastic branches start with a pressure and a shear at the envelope: what
// the faces were given is no fracture. Of the shear, friction uses up friction
// times cohesion over k.
TEST(Separation, SlidingUnderPressureUsesUpFractureEnergyAndFriction)
{
  for (const double pressure : {20e6, 60e6})
    {
      const double mu     = 40.6e9 / (2 * 1.2);
      const double lambda = 40.6e9 * .2 / (1.2 * .6);
      const double slope  = std::tan(granite().friction_angle);
      CutBar       bar(.25,
                 2,
                 {{-pressure / (lambda + 2 * mu),
                         (granite_strength().cohesion + slope * pressure) / mu,
                         0}});
      const double of_friction = friction_of_branches(bar.body);
      bar.body.sum_forces();
      const double         slip  = 1.3 * full_slip();
      const Vector         force = bar.force_on_plus();
      const double         work  = bar.separate({{0, slip, 0}}, 5000);
      const CohesiveEnergy end   = bar.body.force.energy(bar.body.state);
      EXPECT_EQ(bar.body.force.count_faces(Communicator()).failed, 8u);
      EXPECT_GT(force[0], pressure * section);
      // The free sides make stresses uneven: a few percent.
      EXPECT_NEAR(end.fracture.value() /
                    (granite_strength().fracture_energy_2 * section),
                  1,
                  .06);
      EXPECT_NEAR((end.friction.value() - of_friction) /
                    (slope * force[0] * slip),
                  1,
                  .02);
      EXPECT_NEAR(end.fracture.value() + end.friction.value() +
                    end.recoverable.value(),
                  work,
                  1e-6 * work);
    }
}

// Halves that fly apart: the faces open, break and leave elastic waves behind.
TEST(Separation, LedgerOfABreakingBarCloses)
{
  double residuals[2];
  for (unsigned int run = 0; run < 2; ++run)
    {
      CutBar       bar(.25, 4);
      State       &state = bar.body.state;
      const double dt    = (run == 0 ? .7 : .35) * bar.body.critical.time_step;
      for (NodeIndex i = 0; i < state.n_nodes(); ++i)
        state.velocity[i][0] = bar.is_plus[i] ? 15 : -15;

      EnergyLedger ledger;
      const auto   n_steps = static_cast<unsigned int>(8e-6 / dt);
      for (unsigned int i = 0; i < n_steps; ++i)
        {
          ASSERT_TRUE(bar.body.sum_forces());
          if (i == 0)
            start_velocities(state, dt);
          ledger.enter(bar.body.energies(dt));
          bar.body.move(dt);
        }
      EXPECT_EQ(bar.body.force.count_faces(Communicator()).failed, 8u);
      residuals[run] = ledger.largest_relative_residual();
      EXPECT_LT(residuals[run], 2e-3);
      // Mostly mode I; shear of the end faces takes part.
      EXPECT_NEAR(ledger.energies()["fracture"],
                  granite_strength().fracture_energy_1 * section,
                  .05 * granite_strength().fracture_energy_1 * section);
    }
  RecordProperty("residual", std::to_string(residuals[0]));
  EXPECT_LT(residuals[1], .4 * residuals[0]);
}
