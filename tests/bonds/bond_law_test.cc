#include <rift/bonds/bond_law.h>

#include <gtest/gtest.h>

#include <random>

// The closed forms are those of doc/theory.md, eq. 41 to 43a.
using namespace rift;

namespace
{
  using Vector = Vector3<double>;

  constexpr Vector normal = {{0, 0, 1}};

  FaceStrength
  granite(const double ratio)
  {
    return {15e6, 36.7e6, std::tan(50 * M_PI / 180), .6, 400, 400 * ratio};
  }

  BondLaw::Traction
  borne(const FaceStrength      &strength,
        const BondLaw::Memory   &memory,
        const BondLaw::Traction &trial,
        const double             closing)
  {
    const auto part = BondLaw::bear(BondLaw::envelope(strength, memory),
                                    trial.normal,
                                    dot(trial.shear, trial.shear),
                                    closing);
    return {part.normal, part.shear_factor * trial.shear};
  }

  struct Result
  {
    /** Work, J/m^2, and largest traction, Pa. */
    double work = 0, peak = 0;
  };

  /** A bond that is moved as prescribed, under a pressure if there is one. A
   * trial traction far out along the motion is what keeps it together. */
  struct Specimen
  {
    explicit Specimen(const FaceStrength &strength)
      : strength(strength)
    {
    }

    BondLaw::Traction
    move(const double opening, const Vector &slip, const double pressure = 0)
    {
      constexpr double        stiff = 1e18;
      const BondLaw::Traction trial = {traction.normal + stiff * opening -
                                         pressure,
                                       traction.shear + stiff * slip};
      return take(trial, opening, slip);
    }

    BondLaw::Traction
    take(const BondLaw::Traction &trial,
         const double             opening,
         const Vector            &slip)
    {
      const BondLaw::Traction next =
        borne(strength, memory, trial, trial.normal);
      work += .5 * ((traction.normal + next.normal) * opening +
                    dot(traction.shear + next.shear, slip));
      law.soften(strength, memory, next, opening, slip);
      traction = next;
      return next;
    }

    BondLaw           law;
    FaceStrength      strength;
    BondLaw::Memory   memory;
    BondLaw::Traction traction = {0, {{0, 0, 0}}};
    double            work     = 0;
  };

  /** Along a straight path in a number of steps; in units of the separation of
   * pure opening or sliding it ends where the damage is 1. */
  Result
  straight(const FaceStrength &s, const double angle)
  {
    Specimen     bond(s);
    Result       result;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    // The traction keeps the direction of the motion.
    const double peak =
      std::min(cosine > 0 ? s.tensile_strength / cosine : 1e300,
               s.cohesion / (sine + s.tan_friction_angle * cosine));
    const double energy = 1 / (cosine * cosine / s.fracture_energy_1 +
                               sine * sine / s.fracture_energy_2);
    const double length = energy / (Softening::integral * peak);
    for (unsigned int i = 0; i < 1100; ++i)
      {
        const double step = length / 1000;
        // The first traction has the direction of the motion, as all do.
        bond.move(step * cosine, {{step * sine, 0, 0}});
        result.peak =
          std::max(result.peak,
                   std::hypot(bond.traction.normal, norm(bond.traction.shear)));
      }
    EXPECT_DOUBLE_EQ(bond.memory.damage, 1);
    result.work = bond.work;
    EXPECT_NEAR(result.work, energy, .005 * energy);
    EXPECT_NEAR(result.peak, peak, 1e-6 * peak);
    return result;
  }
} // namespace

TEST(BondLaw, WorkAndPeakOfStraightPathsAreClosedForms)
{
  for (const double ratio : {1., 4.})
    for (const double degrees : {0., 30., 45., 60., 90.})
      {
        SCOPED_TRACE(degrees);
        straight(granite(ratio), degrees * M_PI / 180);
      }
}

// W_I/G_I + W_II/G_II = 1 on any path.
TEST(BondLaw, SharesOfOpeningAndSlidingAddUp)
{
  const FaceStrength s = granite(4);
  for (const double share : {.2, .5, .8})
    {
      Specimen bond(s);
      double   opening_work = 0, slip_work = 0;
      double   last = 0;
      while (bond.memory.damage < 1)
        {
          const bool   opens = bond.memory.damage < share;
          const double o     = opens ? 5e-8 : 0;
          const Vector slip  = {{0, opens ? 0 : 5e-8, 0}};
          last               = bond.work;
          // What the bond bore in the other direction is gone.
          bond.traction =
            opens ? bond.traction : BondLaw::Traction{0, bond.traction.shear};
          bond.move(o, slip);
          (opens ? opening_work : slip_work) += bond.work - last;
        }
      EXPECT_GT(opening_work, .1 * s.fracture_energy_1);
      EXPECT_NEAR(opening_work / s.fracture_energy_1 +
                    slip_work / s.fracture_energy_2,
                  1,
                  .005);
    }
}

// The friction that fades while the bond softens is paid as well.
TEST(BondLaw, SlidingUnderPressure)
{
  const FaceStrength s = granite(1);
  for (const double pressure : {5e7, 2e8})
    {
      Specimen     bond(s);
      const double slip =
        s.fracture_energy_2 / (Softening::integral * s.cohesion);
      double peak = 0;
      for (unsigned int i = 0; i < 1000; ++i)
        {
          constexpr double stiff = 1e18;
          const double     step  = slip / 1000;
          bond.take(
            {-pressure, bond.traction.shear + Vector{{stiff * step, 0, 0}}},
            0,
            {{step, 0, 0}});
          peak = std::max(peak, norm(bond.traction.shear));
        }
      EXPECT_NEAR(bond.memory.damage, 1, 1e-9);
      const double residual = s.residual_friction * pressure * slip;
      const double expected =
        s.fracture_energy_2 *
        (1 +
         (s.tan_friction_angle - s.residual_friction) * pressure / s.cohesion);
      EXPECT_NEAR(peak, s.cohesion + s.tan_friction_angle * pressure, 1);
      EXPECT_NEAR(bond.work - residual, expected, .005 * expected);
    }
}

// Below the envelope a bond takes nothing away and is not damaged unless it
// moves.
TEST(BondLaw, BearsWhatIsBelowTheEnvelope)
{
  const FaceStrength    s = granite(1);
  const BondLaw::Memory memory;
  const auto            t = borne(s, memory, {7e6, {{3e6, 0, 0}}}, 0);
  EXPECT_EQ(t.normal, 7e6);
  EXPECT_EQ(t.shear[0], 3e6);
  // An open bond takes no pressure until it is closed.
  EXPECT_EQ(borne(s, memory, {-7e6, {{3e6, 0, 0}}}, 2e6).normal, 0);
  EXPECT_EQ(borne(s, memory, {-7e6, {{3e6, 0, 0}}}, -2e6).normal, -2e6);
}

TEST(BondLaw, ExcessIsWorkedOff)
{
  const FaceStrength s = granite(1);
  Specimen           bond(s);
  bond.memory.excess = .5;
  const double opening =
    s.fracture_energy_1 / (Softening::integral * s.tensile_strength);
  EXPECT_NEAR(bond.move(1e-5 * opening, {{0, 0, 0}}).normal,
              1.5 * s.tensile_strength,
              1);
  // From 0.5 at a rate of 1/0.01 of the damage.
  while (bond.memory.damage < .004)
    bond.move(1e-5 * opening, {{0, 0, 0}});
  EXPECT_NEAR(bond.memory.excess, .1, .01);
  while (bond.memory.damage < .0051)
    bond.move(1e-5 * opening, {{0, 0, 0}});
  EXPECT_EQ(bond.memory.excess, 0);
}
