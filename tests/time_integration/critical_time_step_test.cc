// The safe time step: stable up to it, and not much beyond it.

#include <rift/solid/damping.h>
#include <rift/time_integration/central_difference.h>

#include "../support/single_cell.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  /**
   * How many times its first size the displacement of a body grows to. It
   * starts from random displacements, in which all modes are present, so small
   * that the body stays linear.
   */
  double
  growth(const Body               &of,
         const MaterialParameters &material,
         const double              viscosity,
         const double              share_of_bound,
         const unsigned int        n_steps)
  {
    ElasticBody  body(of, material);
    const double dt = share_of_bound * body.critical_step(viscosity);
    Damping      damping(body.topology, body.discrete.reference, {viscosity});
    constexpr double size = 1e-12;
    Random           random(5);
    for (auto &u : body.state.displacement)
      for (unsigned int d = 0; d < 3; ++d)
        u[d] = size * random_matrix(random)[0][0];
    double result = 0;
    for (unsigned int n = 0; n < n_steps && result < 1e4; ++n)
      {
        EXPECT_FALSE(body.force.add_to(body.state, body.activity));
        if (viscosity > 0)
          damping.add_to(body.state, body.activity);
        advance(body.state, body.activity, dt);
        for (const auto &u : body.state.displacement)
          result = std::max(result, norm(u.vector()) / size);
      }
    return result;
  }

  /** The viscosity of which a material of no Poisson's ratio has this share
   * of critical damping at the highest frequency of a cell. */
  double
  viscosity_of(const Body               &body,
               const MaterialParameters &material,
               const double              share)
  {
    // eta d and E e are proportional, so that 2 xi omega = omega^2 eta / E.
    const double omega = 2 / ElasticBody(body, material).critical_step();
    return 2 * share * material.youngs_modulus / omega;
  }

  constexpr double       stable = 100, unstable = 1e4;
  constexpr unsigned int many_steps = 2000;
} // namespace

TEST(CriticalTimeStep, LooseCellIsStableUpToIt)
{
  Random random(1);
  for (unsigned int n = 0; n < 20; ++n)
    {
      const Body body = make_random_cell(random);
      for (const auto &material : {granite(), random_anisotropic(random)})
        {
          EXPECT_LT(growth(body, material, 0, .99, many_steps), stable);
          EXPECT_GT(growth(body, material, 0, 1.03, many_steps), unstable);
        }
    }
}

TEST(CriticalTimeStep, WithViscosity)
{
  // Without Poisson's ratio the same mode has the largest frequency and the
  // largest rate of decay, and the bound is sharp.
  MaterialParameters material = granite();
  material.poissons_ratio     = 0;
  Random random(2);
  for (unsigned int n = 0; n < 8; ++n)
    {
      const Body body = make_random_cell(random);
      for (const double share : {.05, .3, 1., 3.})
        {
          const double eta = viscosity_of(body, material, share);
          EXPECT_LT(growth(body, material, eta, .99, many_steps), stable)
            << share;
          EXPECT_GT(growth(body, material, eta, 1.05, many_steps), unstable)
            << share;
          // In general it is safe.
          for (const auto &other : {granite(), random_anisotropic(random)})
            EXPECT_LT(growth(body, other, eta, .99, many_steps), stable)
              << share;
        }
    }
}

TEST(CriticalTimeStep, BodyIsStableAtThatOfItsCells)
{
  Random random(3);
  for (unsigned int n = 0; n < 4; ++n)
    for (const auto &material : {granite(), random_anisotropic(random)})
      {
        const Body box = make_box({{3, 3, 3}}, 1, .15, n);
        EXPECT_LT(growth(box, material, 0, .99, many_steps), stable);
        // Cells hold each other, but not by a factor of three.
        EXPECT_GT(growth(box, material, 0, 3, many_steps), unstable);
      }
}

TEST(CriticalTimeStep, CohesiveStiffnessShortensIt)
{
  const DiscreteBody body = discretize(make_regular_cell(), {2641});
  const auto         of   = [&](const double factor, const double eta) {
    return critical_time_step(body.topology,
                              body.reference,
                              {{"granite",
                                stiffness_matrix(make_elasticity(granite())),
                                2641,
                                eta,
                                factor}},
                              Communicator());
  };
  const CriticalTimeStep plain = of(0, 0);
  EXPECT_EQ(plain.limited_by, "cell 0 of granite");
  // The table of the regular tetrahedron: dt c_p / h = sqrt(1/2), at most
  // 1.5 % less by the bound.
  const double c_p   = std::sqrt(40.6e9 * .8 / (1.2 * .6) / 2641);
  const double exact = std::sqrt(.5) * std::sqrt(2. / 3) / c_p;
  EXPECT_LE(plain.time_step, exact * (1 + 1e-12));
  EXPECT_GE(plain.time_step, exact / 1.015);

  // Three faces at each corner, each with this share of the stiffness.
  EXPECT_NEAR(of(1, 0).time_step, plain.time_step / 2, 1e-12 * exact);
  EXPECT_EQ(of(1, 0).limited_by,
            "cell 0 of granite, with room for cracks or contact");
  EXPECT_LT(of(0, 1e5).time_step, plain.time_step);
  EXPECT_EQ(of(0, 1e5).limited_by, "cell 0 of granite, viscosity included");
}

TEST(CriticalTimeStep, NamesTheCellThatLimits)
{
  // Steel above granite, where one cell is flattened.
  Body box = make_box({{2, 2, 4}});
  for (LocalCell &cell : box.cells)
    cell.material = box.vertices[cell.vertices[0]][2] < 2 ? 0 : 1;
  const DiscreteBody body  = discretize(box, {2641, 7850});
  MaterialParameters steel = granite();
  steel.youngs_modulus     = 206e9;
  const auto stiff_granite = stiffness_matrix(make_elasticity(granite()));
  const auto stiff_steel   = stiffness_matrix(make_elasticity(steel));
  const auto of_both       = critical_time_step(
    body.topology,
    body.reference,
    {{"granite", stiff_granite, 2641}, {"steel", stiff_steel, 7850}},
    Communicator());
  unsigned int cell = 0;
  ASSERT_EQ(std::sscanf(of_both.limited_by.c_str(), "cell %u of steel", &cell),
            1);
  EXPECT_EQ(body.topology.material(body.topology.find_cell(cell)), 1);
  // All cells are alike, so that steps are as the wave speeds.
  const auto of_granite = critical_time_step(
    body.topology,
    body.reference,
    {{"granite", stiff_granite, 2641}, {"g", stiff_granite, 2641}},
    Communicator());
  EXPECT_NEAR(of_granite.time_step / of_both.time_step,
              std::sqrt(206e9 / 7850 / (40.6e9 / 2641)),
              1e-12);
}
