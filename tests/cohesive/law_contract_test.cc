#include <rift/cohesive/cohesive_parameters.h>
#include <rift/cohesive/laws/all.h>

#include <gtest/gtest.h>

#include "law_specimen.h"

#include <random>

using namespace rift;
using namespace rift::test;

// What every cohesive law that a scene can choose has to do.
namespace
{
  template <typename List>
  struct TypesOf;

  template <typename... Laws>
  struct TypesOf<LawList<Laws...>>
  {
    using type = ::testing::Types<Laws...>;
  };

  template <typename Law>
  constexpr bool is_extrinsic = Law::model == CohesiveModel::extrinsic;

  using Random = std::mt19937;

  Vector
  random_vector(Random &random, const double size)
  {
    std::uniform_real_distribution<double> value(-size, size);
    return {{value(random), value(random), value(random)}};
  }

  /** Random tractions that nodes may have had between them, Pa. */
  Vector
  random_traction(Random &random)
  {
    Vector t = random_vector(random, 1);
    t[0] *= (t[0] > 0 ? 2 : 5) * strength.tensile_strength;
    t[1] *= 2 * strength.cohesion;
    t[2] *= 2 * strength.cohesion;
    return t;
  }

  /** Elastic energy of a point that is at its strength, J/m^2. */
  const double elastic_size =
    .5 * strength.cohesion * strength.cohesion / stiffness;
} // namespace

template <typename Law>
class LawContract : public ::testing::Test
{
public:
  using Specimen = LawSpecimen<Law>;
};

// Where the scene chooses none.
TEST(CohesiveLaw, FollowsFromTheModel)
{
  CohesiveParameters parameters;
  parameters.model = CohesiveModel::extrinsic;
  EXPECT_EQ(parameters.chosen_law(), CohesiveParameters::bonds);
  parameters.model = CohesiveModel::intrinsic;
  EXPECT_EQ(parameters.chosen_law(), "faces");
  parameters.law = "linear";
  EXPECT_EQ(parameters.chosen_law(), "linear");
}

TYPED_TEST_SUITE(LawContract, TypesOf<CohesiveLaws>::type, );

// The work of the elastic branch may come on top of it: that of a stiff one is
// small.
TYPED_TEST(LawContract, SeparationTakesTheFractureEnergy)
{
  for (const bool opens : {true, false})
    {
      LawSpecimen<TypeParam> specimen(100 * stiffness);
      const double           energy =
        opens ? strength.fracture_energy_1 : strength.fracture_energy_2;
      const Vector path = opens ?
                            Vector{{1.2 * full_opening, 0, 0}} :
                            Vector{{0, .72 * full_slip, -.96 * full_slip}};
      specimen.go_to(path, 40000);
      EXPECT_TRUE(TypeParam::has_failed(specimen.point));
      EXPECT_NEAR(norm(specimen.point.traction), 0, 1e-6);
      EXPECT_NEAR(specimen.work, energy, 1e-3 * energy);
      EXPECT_NEAR(specimen.fracture, energy, 1e-3 * energy);
      EXPECT_NEAR(specimen.friction, 0, 1e-9 * energy);
      const auto damage = TypeParam::damage(specimen.point);
      EXPECT_GE(opens ? damage.opening : damage.slip, 1);
      EXPECT_EQ(opens ? damage.slip : damage.opening, 0);
    }
}

TYPED_TEST(LawContract, ClosedCyclesYieldNoEnergy)
{
  Random       random(3);
  unsigned int n_damaged = 0, n_failed = 0;
  for (unsigned int sample = 0; sample < 100; ++sample)
    {
      LawSpecimen<TypeParam> specimen;
      const double reach = full_slip * std::pow(10, -1.5 * (sample % 10) / 10.);
      for (unsigned int leg = 0; leg < 6; ++leg)
        specimen.go_to(Vector{{.3 * reach, 0, 0}} +
                         random_vector(random, reach),
                       10000);
      specimen.go_to({{0, 0, 0}}, 10000);
      EXPECT_GE(specimen.work, -1e-6 * elastic_size) << "sample " << sample;
      const bool has_failed = TypeParam::has_failed(specimen.point);
      const auto damage     = TypeParam::damage(specimen.point);
      n_failed += has_failed;
      n_damaged += !has_failed && std::hypot(damage.opening, damage.slip) > .1;
    }
  EXPECT_GT(n_damaged, 10u);
  EXPECT_GT(n_failed, 10u);
}

// At random jumps that grow until all has failed, pressure included.
TYPED_TEST(LawContract, RandomStepsStayStableAndBalanced)
{
  Random                 random(5);
  LawSpecimen<TypeParam> specimen;
  double                 last_damage = 0;
  const double           largest =
    (1 + strength.tan_friction_angle) * stiffness * full_opening +
    2 * strength.cohesion;
  for (unsigned int i = 0; i < 100000; ++i)
    {
      // Drawn back to the middle.
      Vector target =
        specimen.jump + random_vector(random, 1e-3 * full_opening);
      target = (1 - 3e-5) * target;
      specimen.step_to(target);
      const auto [opening, slip] = TypeParam::damage(specimen.point);
      const double damage        = std::hypot(opening, slip);
      ASSERT_GE(damage, last_damage);
      last_damage = damage;
      ASSERT_LT(norm(specimen.point.traction), largest);
      ASSERT_GE(specimen.fracture, -1e-9 * elastic_size);
      ASSERT_GE(specimen.friction, -1e-9 * elastic_size);
    }
  EXPECT_GT(last_damage, .3);
  EXPECT_GT(specimen.friction, elastic_size);
  EXPECT_NEAR(specimen.work,
              specimen.fracture + specimen.friction + specimen.elastic_energy(),
              2e-3 * specimen.work);
}

// From the start and at any time later, when more corners of a face part.
TYPED_TEST(LawContract, StartsWithTheTractionThatHeldTheNodes)
{
  if constexpr (is_extrinsic<TypeParam>)
    {
      Random random(7);
      for (unsigned int sample = 0; sample < 1000; ++sample)
        {
          LawSpecimen<TypeParam> specimen;
          const unsigned int     n_corrections = sample % 3;
          for (unsigned int i = 0; i <= n_corrections; ++i)
            {
              const Vector before = specimen.point.traction;
              const Vector more   = random_traction(random);
              specimen.hold(more);
              for (unsigned int d = 0; d < dim; ++d)
                ASSERT_EQ(specimen.point.traction[d], before[d] + more[d]);
              const Vector held = specimen.point.traction;
              specimen.step_to(specimen.jump);
              for (unsigned int d = 0; d < dim; ++d)
                ASSERT_NEAR(specimen.point.traction[d],
                            held[d],
                            1e-9 * strength.cohesion);
              specimen.go_to(specimen.jump +
                               random_vector(random, .2 * full_opening),
                             100);
            }
        }
    }
}

// A start at the strength takes the fracture energy, too: what it is given in
// its elastic branch comes on top.
TYPED_TEST(LawContract, StartAtTheStrengthTakesTheFractureEnergy)
{
  if constexpr (is_extrinsic<TypeParam>)
    for (const double share : {.5, 1., 1.3})
      {
        LawSpecimen<TypeParam> opening(100 * stiffness),
          sliding(100 * stiffness);
        opening.hold({{share * strength.tensile_strength, 0, 0}});
        sliding.hold({{0, share * strength.cohesion, 0}});
        for (const auto *specimen : {&opening, &sliding})
          EXPECT_NEAR(specimen->given.cohesive + specimen->given.frictional,
                      specimen->elastic_energy(),
                      1e-9 * elastic_size);
        opening.go_to({{1.2 * full_opening, 0, 0}}, 40000);
        sliding.go_to({{0, 1.2 * full_slip, 0}}, 40000);
        EXPECT_TRUE(TypeParam::has_failed(opening.point));
        EXPECT_TRUE(TypeParam::has_failed(sliding.point));
        EXPECT_NEAR(opening.work,
                    strength.fracture_energy_1,
                    1e-3 * strength.fracture_energy_1);
        EXPECT_NEAR(sliding.work,
                    strength.fracture_energy_2,
                    1e-3 * strength.fracture_energy_2);
        EXPECT_NEAR(opening.fracture - opening.given.cohesive,
                    opening.work,
                    1e-9 * opening.work);
        EXPECT_NEAR(sliding.fracture - sliding.given.cohesive,
                    sliding.work,
                    1e-9 * sliding.work);
      }
}

TYPED_TEST(LawContract, IntactPointsNeedNoMemory)
{
  if constexpr (!is_extrinsic<TypeParam>)
    {
      Random       random(12);
      unsigned int n_intact = 0;
      for (unsigned int i = 0; i < 10000; ++i)
        {
          LawSpecimen<TypeParam> specimen;
          const Vector           jump =
            random_vector(random, 3 * strength.cohesion / stiffness);
          bool         yields;
          const Vector traction =
            TypeParam::intact_traction(specimen.constants, jump, yields);
          if (yields)
            continue;
          ++n_intact;
          specimen.step_to(jump);
          for (unsigned int d = 0; d < dim; ++d)
            ASSERT_EQ(traction[d], specimen.point.traction[d]);
          ASSERT_EQ(TypeParam::intact_energy(specimen.constants, jump),
                    specimen.elastic_energy());
        }
      EXPECT_GT(n_intact, 1000u);
    }
}

// And the result of a lane has no bit from its neighbours.
TYPED_TEST(LawContract, LanesAreLikeNumbersAndDoNotFeelEachOther)
{
  using Points    = typename TypeParam::template Point<Simd>;
  using Constants = typename TypeParam::template Constants<Simd>;
  Random                              random(6);
  std::vector<LawSpecimen<TypeParam>> numbers;
  for (unsigned int l = 0; l < batch_size; ++l)
    {
      FaceStrength scattered = strength;
      scattered.tensile_strength *= .8 + .05 * l;
      scattered.cohesion *= .8 + .05 * l;
      scattered.residual_friction = .3;
      numbers.emplace_back(stiffness, scattered);
      if constexpr (is_extrinsic<TypeParam>)
        numbers.back().hold(random_traction(random));
    }
  // The same points once more, in other lanes.
  const auto other = [](const unsigned int l) {
    return (3 * l + 1) % batch_size;
  };
  Points    points{}, moved{};
  Constants constants{}, moved_constants{};
  for (unsigned int l = 0; l < batch_size; ++l)
    {
      set_lane(points, l, numbers[l].point);
      set_lane(constants, l, numbers[l].constants);
      set_lane(moved, other(l), numbers[l].point);
      set_lane(moved_constants, other(l), numbers[l].constants);
    }
  const TypeParam law;
  for (unsigned int i = 0; i < 20000; ++i)
    {
      Vector3<Simd> jump, moved_jump;
      for (unsigned int l = 0; l < batch_size; ++l)
        {
          // Every other point rests, most of the time.
          const double size = l % 2 == 0 || i % 50 == 0 ? 3e-3 : 0;
          numbers[l].step_to(numbers[l].jump +
                             random_vector(random, size * full_opening));
          for (unsigned int d = 0; d < dim; ++d)
            jump[d][l] = moved_jump[d][other(l)] = numbers[l].jump[d];
        }
      law.update(points, constants, jump);
      law.update(moved, moved_constants, moved_jump);
      for (unsigned int l = 0; l < batch_size; ++l)
        {
          using Numbers      = typename TypeParam::template Point<double>;
          auto        here   = get_lane<Numbers>(points, l);
          auto        there  = get_lane<Numbers>(moved, other(l));
          const auto &number = numbers[l].point;
          for_each_number(here, there, [](const double a, const double b) {
            ASSERT_EQ(a, b);
          });
          for (unsigned int d = 0; d < dim; ++d)
            ASSERT_NEAR(here.traction[d],
                        number.traction[d],
                        1e-8 * strength.cohesion);
          ASSERT_EQ(TypeParam::has_failed(here), TypeParam::has_failed(number));
        }
    }
  unsigned int n_failed = 0;
  for (const auto &number : numbers)
    n_failed += TypeParam::has_failed(number.point);
  EXPECT_GT(n_failed, 0u);
  EXPECT_LT(n_failed, batch_size);
}
