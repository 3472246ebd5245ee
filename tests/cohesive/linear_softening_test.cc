#include <rift/cohesive/laws/linear_softening.h>

#include "law_specimen.h"
#include "shaken_cells.h"

// The law against its formulas (doc/theory.md, eqs. 14d to 14g).
namespace
{
  using namespace rift;
  using namespace rift::test;

  using Linear = LawSpecimen<LinearSoftening>;

  /** The jumps over which a rigid branch would separate, m. */
  const double whole_opening =
    2 * test::strength.fracture_energy_1 / test::strength.tensile_strength;
  const double whole_slip =
    2 * test::strength.fracture_energy_2 / test::strength.cohesion;

  /** The effective traction at an effective jump, for that at the strength. */
  double
  effective_traction(const double jump, const double at_strength)
  {
    return jump < at_strength ? jump / at_strength :
                                std::max(0., (1 - jump) / (1 - at_strength));
  }

  Vector
  path(const double angle, const double effective_jump)
  {
    return {{effective_jump * std::cos(angle) * whole_opening,
             .6 * effective_jump * std::sin(angle) * whole_slip,
             -.8 * effective_jump * std::sin(angle) * whole_slip}};
  }
} // namespace

// Up the branch and down the line.
TEST(LinearSoftening, ModesFollowTheLine)
{
  const auto   c                = Linear().constants;
  const double opening_strength = test::strength.tensile_strength;
  const double sliding_strength = test::strength.cohesion;
  EXPECT_NEAR(c.opening_compliance * whole_opening * stiffness,
              opening_strength,
              1e-9 * opening_strength);
  EXPECT_NEAR(c.sliding_compliance * whole_slip * stiffness,
              sliding_strength,
              1e-9 * sliding_strength);
  Linear opening, sliding;
  for (unsigned int i = 1; i <= 1200; ++i)
    {
      const double jump = i / 1000.;
      opening.step_to(path(0, jump));
      sliding.step_to(path(M_PI / 2, jump));
      ASSERT_NEAR(opening.point.traction[0],
                  effective_traction(jump, c.opening_compliance) *
                    opening_strength,
                  1e-9 * opening_strength);
      ASSERT_NEAR(opening.shear(), 0, 1e-9 * opening_strength);
      const double shear =
        effective_traction(jump, c.sliding_compliance) * sliding_strength;
      ASSERT_NEAR(sliding.point.traction[1],
                  .6 * shear,
                  1e-9 * sliding_strength);
      ASSERT_NEAR(sliding.point.traction[2],
                  -.8 * shear,
                  1e-9 * sliding_strength);
      const auto expect_damage = [jump](const double damage, const double a) {
        ASSERT_NEAR(damage, std::clamp((jump - a) / (1 - a), 0., 1.), 1e-9);
      };
      expect_damage(LinearSoftening::damage(opening.point).opening,
                    c.opening_compliance);
      expect_damage(LinearSoftening::damage(sliding.point).slip,
                    c.sliding_compliance);
    }
  EXPECT_TRUE(LinearSoftening::has_failed(opening.point));
  EXPECT_TRUE(LinearSoftening::has_failed(sliding.point));
}

// With a stiff branch the irreversible jump is the whole.
TEST(LinearSoftening, MixedModeFollowsTheDirectionOfTheJump)
{
  for (const double angle : {.3, .8, 1.2})
    {
      Linear specimen(1000 * stiffness);
      for (unsigned int i = 1; i <= 1200; ++i)
        {
          const double jump = i / 1000.;
          specimen.step_to(path(angle, jump));
          // At the start the elastic jump is not small beside the whole.
          if (jump < .05)
            continue;
          const double effective = std::max(0., 1 - jump);
          const auto  &t         = specimen.point.traction;
          const auto  &strength  = test::strength;
          ASSERT_NEAR(t[0],
                      effective * std::cos(angle) * strength.tensile_strength,
                      2e-3 * strength.cohesion);
          ASSERT_NEAR(t[1],
                      .6 * effective * std::sin(angle) * strength.cohesion,
                      2e-3 * strength.cohesion);
          ASSERT_NEAR(t[2],
                      -.8 * effective * std::sin(angle) * strength.cohesion,
                      2e-3 * strength.cohesion);
          const auto damage = LinearSoftening::damage(specimen.point);
          ASSERT_NEAR(damage.opening,
                      std::min(jump, 1.) * std::cos(angle),
                      2e-3);
          ASSERT_NEAR(damage.slip, std::min(jump, 1.) * std::sin(angle), 2e-3);
        }
      EXPECT_TRUE(LinearSoftening::has_failed(specimen.point));
    }
}

TEST(LinearSoftening, MixedModeTakesTheMeanOfTheEnergies)
{
  for (const double angle : {.2, .6, M_PI / 4, 1., 1.4})
    {
      Linear specimen(100 * stiffness);
      specimen.go_to(path(angle, 1.1), 40000);
      const double energy =
        std::pow(std::cos(angle), 2) * test::strength.fracture_energy_1 +
        std::pow(std::sin(angle), 2) * test::strength.fracture_energy_2;
      EXPECT_NEAR(specimen.work, energy, 1e-3 * energy);
      EXPECT_NEAR(specimen.fracture, energy, 1e-3 * energy);
    }
}

TEST(LinearSoftening, UnloadingFollowsTheBranch)
{
  Linear specimen;
  specimen.go_to(path(.7, .5), 1000);
  const Vector jump = specimen.jump, traction = specimen.point.traction;
  const double fracture = specimen.fracture;
  const double back     = .5 * traction[0] / stiffness;
  for (const double way : {.25, 1., .5, 0., 4.})
    {
      specimen.step_to(jump - Vector{{way * back, 0, 0}});
      EXPECT_NEAR(specimen.point.traction[0],
                  traction[0] - way * back * stiffness,
                  1e-12 * test::strength.cohesion);
      for (unsigned int d = 1; d < dim; ++d)
        EXPECT_NEAR(specimen.point.traction[d],
                    traction[d],
                    1e-12 * test::strength.cohesion);
    }
  EXPECT_EQ(specimen.fracture, fracture);
}

// From the coefficient of the intact face to the residual one, with the damage.
TEST(LinearSoftening, FrictionIsCarriedBesidesTheCohesion)
{
  const double pressure = 20e6, residual = .5;
  FaceStrength strength      = test::strength;
  strength.residual_friction = residual;
  Linear specimen(stiffness, strength);
  specimen.step_to({{-pressure / stiffness, 0, 0}});
  const unsigned int n = 20000;
  for (unsigned int i = 1; i <= n; ++i)
    {
      specimen.step_to({{-pressure / stiffness, 0, 2. * i / n * whole_slip}});
      const double d    = LinearSoftening::damage(specimen.point).slip;
      const double peak = (1 - d) * strength.cohesion +
                          (strength.tan_friction_angle +
                           d * (residual - strength.tan_friction_angle)) *
                            pressure;
      ASSERT_LE(specimen.shear(), peak * (1 + 1e-9));
      if (d > 0)
        {
          ASSERT_NEAR(specimen.shear(), peak, 1e-9 * peak);
        }
    }
  EXPECT_TRUE(LinearSoftening::has_failed(specimen.point));
  EXPECT_NEAR(specimen.shear(), residual * pressure, 1e-9 * pressure);
  EXPECT_NEAR(specimen.work - .5 * pressure * pressure / stiffness,
              specimen.fracture + specimen.friction +
                .5 * std::pow(residual * pressure, 2) / stiffness,
              1e-6 * specimen.work);
  EXPECT_GT(specimen.friction, residual * pressure * whole_slip);
}

// Where nodes transmit more than the strength, the line starts there and is so
// much shorter, however often that happens.
TEST(LinearSoftening, LineStartsAtWhatIsHeld)
{
  for (const double share : {.7, 1., 1.4})
    for (const bool parts_in_two : {false, true})
      {
        Linear       specimen(100 * stiffness);
        const Vector traction = {{.8 * share * test::strength.tensile_strength,
                                  .6 * share * test::strength.cohesion,
                                  0}};
        const double energy   = .64 * test::strength.fracture_energy_1 +
                              .36 * test::strength.fracture_energy_2;
        for (unsigned int i = 0; i < (parts_in_two ? 2 : 1); ++i)
          specimen.hold((parts_in_two ? .5 : 1.) * traction);
        const double given = specimen.given.cohesive;
        EXPECT_NEAR(given,
                    .5 * dot(traction, traction) / (100 * stiffness),
                    1e-9 * energy);
        EXPECT_NEAR(specimen.given.frictional, 0, 1e-9 * energy);
        EXPECT_NEAR(specimen.point.strength, std::max(share, 1.), 1e-12);
        specimen.go_to({{.88 * whole_opening, .66 * whole_slip, 0}}, 20000);
        EXPECT_TRUE(LinearSoftening::has_failed(specimen.point));
        EXPECT_NEAR(specimen.work, energy, 1e-3 * energy);
        EXPECT_NEAR(specimen.fracture - given, energy, 1e-3 * energy);
      }
}

// A failed point that has to hold once more lets go within a few elastic jumps.
TEST(LinearSoftening, FailedPointHoldsOnceMore)
{
  Linear specimen;
  specimen.go_to({{1.1 * whole_opening, 0, 0}}, 1000);
  specimen.hold({{5e6, 0, 0}});
  const double opening = specimen.jump[0];
  specimen.step_to(specimen.jump);
  EXPECT_NEAR(specimen.point.traction[0], 5e6, 1e-3);
  const auto  &c = specimen.constants;
  const double reach =
    (2 * std::max(c.opening_compliance, c.sliding_compliance) -
     c.opening_compliance) *
    5e6 / test::strength.tensile_strength * whole_opening;
  specimen.go_to({{opening + .99 * reach, 0, 0}}, 100);
  EXPECT_GT(specimen.point.traction[0], 0);
  specimen.go_to({{opening + 1.01 * reach, 0, 0}}, 100);
  EXPECT_EQ(specimen.point.traction[0], 0);
  specimen.step_to({{-1e-8, 0, 0}});
  EXPECT_NEAR(specimen.point.traction[0],
              -stiffness * 1e-8,
              1e-9 * stiffness * 1e-8);
}

TEST(LinearSoftening, SoftBranchTakesMoreEnergy)
{
  const double peak     = test::strength.tensile_strength;
  FaceStrength strength = test::strength;
  strength.cohesion     = peak;
  for (const double share : {.7, 1.01})
    {
      const double soft = share * peak * peak / strength.fracture_energy_1;
      Linear       specimen(soft, strength);
      EXPECT_EQ(LinearSoftening::is_resolved(strength, specimen.constants),
                share > 1);
      specimen.go_to({{4 * whole_opening, 0, 0}}, 20000);
      const double energy =
        std::max(1., 1 / share) * strength.fracture_energy_1;
      EXPECT_NEAR(specimen.work, energy, 1e-3 * energy);
    }
}

TEST(LinearSoftening, ShakenCellsStayStable)
{
  EXPECT_EQ(check_shaken(two_cells(), 1e-5, 1e-4, "linear").n_failed, 0u);
  EXPECT_EQ(check_shaken(five_cells(), 5e-5, 1e-3, "linear").n_failed, 4u);
}
