// The filter that finds cells near their strength never misses one.

#include "../support/single_cell.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  /** Directions over half a sphere, evenly spread. */
  std::vector<Vector3<double>>
  directions(const unsigned int n)
  {
    std::vector<Vector3<double>> result;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double z = (i + .5) / n, r = std::sqrt(1 - z * z);
        const double angle = i * M_PI * (3 - std::sqrt(5.));
        result.push_back({{r * std::cos(angle), r * std::sin(angle), z}});
      }
    return result;
  }

  /** Strengths that a stress just reaches on some plane. */
  struct Reached
  {
    double tension, cohesion;
  };

  double
  tension_on(const Matrix3<double> &sigma, const Vector3<double> &n)
  {
    return dot(sigma * n, n);
  }

  double
  shear_less_friction_on(const Matrix3<double> &sigma,
                         const Vector3<double> &n,
                         const double           tan_friction)
  {
    const Vector3<double> traction = sigma * n;
    const double          normal   = dot(traction, n);
    return norm(traction - normal * n) + tan_friction * std::min(normal, 0.);
  }

  /** Largest value over all given directions, then by steps around the best. */
  template <typename Function>
  double
  maximise(const Function &f, const std::vector<Vector3<double>> &normals)
  {
    Vector3<double> best  = normals[0];
    double          value = f(best);
    const auto      look  = [&](const Vector3<double> &n) {
      const double candidate = f(n);
      if (candidate <= value)
        return false;
      value = candidate;
      best  = n;
      return true;
    };
    for (const auto &n : normals)
      look(n);
    for (double step = .1; step > 1e-4;)
      {
        bool is_better = false;
        for (const auto &e : unit_matrix)
          for (const double sign : {-1., 1.})
            {
              const Vector3<double> n = best + (sign * step) * e;
              is_better |= look((1 / norm(n)) * n);
            }
        if (!is_better)
          step /= 2;
      }
    return value;
  }

  Reached
  reached_strengths(const Matrix3<double>              &sigma,
                    const double                        tan_friction,
                    const std::vector<Vector3<double>> &normals)
  {
    return {
      maximise([&](const auto &n) { return tension_on(sigma, n); }, normals),
      maximise(
        [&](const auto &n) {
          return shear_less_friction_on(sigma, n, tan_friction);
        },
        normals)};
  }

  /** One cell whose gradient is prescribed. */
  struct WatchedCell
  {
    explicit WatchedCell(const MaterialParameters &material)
      : body(make_regular_cell(), material)
    {
    }

    bool
    is_hot(const StressBound &bound)
    {
      bounds.materials = {bound};
      body.force.watch(bounds);
      EXPECT_FALSE(body.force.add_to(body.state, body.activity));
      const auto &hot = body.force.hot_cells();
      EXPECT_LE(hot.size(), 1u);
      EXPECT_TRUE(hot.empty() || hot[0] == 0);
      return !hot.empty();
    }

    /**
     * Largest tangent of the friction angle for which a plane under pressure
     * is at its strength, by the definition: with the nominal traction
     * resolved along the current normal.
     *
     * @param n normal of the plane in the undeformed body.
     */
    double
    friction_at_strength(const Matrix3<double> &h,
                         const double           cohesion,
                         const Vector3<double> &n) const
    {
      const auto     &stress = current_stress.first;
      Vector3<double> traction{};
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int d = 0; d < 3; ++d)
          traction[i] += stress[i][d][0] * n[d];
      const Vector3<double> a      = cross(n, unit_matrix[std::abs(n[0]) > .5]);
      const Vector3<double> b      = cross(n, a);
      Vector3<double>       normal = cross(a + h * a, b + h * b);
      normal                       = (1 / norm(normal)) * normal;
      const double sigma           = dot(traction, normal);
      const double tau             = norm(traction - sigma * normal);
      return sigma < 0 ? (tau - cohesion) / -sigma : 0;
    }

    void
    deform(const Matrix3<double> &h)
    {
      impose_gradient(body.state, h);
      current_stress = body.force.stress(body.state, 0);
    }

    ElasticBody                body;
    InternalForce::BatchStress current_stress;
    StressBounds               bounds;
  };

  constexpr double never = 1e30;

  StressBound
  bound_of(const double tension, const double cohesion, const double tan)
  {
    return {tension, cohesion, tan};
  }

  /** A strain of any shape, with a part that is more or less volumetric. */
  Matrix3<double>
  random_gradient(Random &random, const double size)
  {
    std::uniform_real_distribution<double> share(-1, 1);
    Matrix3<double>                        h = random_matrix(random);
    const double mean       = (h[0][0] + h[1][1] + h[2][2]) / 3;
    const double volumetric = 2 * share(random);
    for (unsigned int i = 0; i < 3; ++i)
      h[i][i] += volumetric - mean;
    double square = 0;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        square += std::pow((h[i][j] + h[j][i]) / 2, 2);
    for (auto &row : h)
      row = (size / std::sqrt(square)) * row;
    return h;
  }

  /** Compression by `size`, its deviator `share` of all. */
  Matrix3<double>
  compressed_gradient(Random &random, const double size, const double share)
  {
    Matrix3<double> h = random_matrix(random);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < i; ++j)
        h[j][i] = h[i][j];
    const double mean   = (h[0][0] + h[1][1] + h[2][2]) / 3;
    double       square = 0;
    for (unsigned int i = 0; i < 3; ++i)
      {
        h[i][i] -= mean;
        square += dot(h[i], h[i]);
      }
    for (unsigned int i = 0; i < 3; ++i)
      {
        h[i] = (size * share / std::sqrt(square)) * h[i];
        h[i][i] -= size * std::sqrt((1 - share * share) / 3);
      }
    return h;
  }

  /** No Poisson effect: each strain has its own stress. */
  constexpr double stiffnesses[6] = {60e9, 40e9, 30e9, 15e9, 18e9, 20e9};

  MaterialParameters
  orthotropic_rock()
  {
    MaterialParameters material;
    material.name       = "orthotropic";
    material.density    = 2600;
    material.elasticity = MaterialParameters::Elasticity::anisotropic;
    for (unsigned int i = 0, k = 0; i < 6; k += 6 - i, ++i)
      material.stiffness[k] = stiffnesses[i];
    return material;
  }

  /** Strain of about `size` in this rock with a stress that is nearly a
   * pressure: its deviator is `share` of it. */
  Matrix3<double>
  orthotropic_gradient(Random &random, const double size, const double share)
  {
    Matrix3<double> h      = compressed_gradient(random, 1, share);
    double          square = 0;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          h[i][j] /= stiffnesses[place(i, j)] * (i == j ? 1 : 2);
          square += h[i][j] * h[i][j];
        }
    for (auto &row : h)
      row = (size / std::sqrt(square)) * row;
    return h;
  }

  /**
   * Number of misses of cells that reach 1/0.9 of the bound, for strains whose
   * norm is up to `largest_strain`.
   */
  unsigned int
  count_misses(const MaterialParameters &material,
               const Tensor4            &tensor,
               const double              largest_strain,
               const unsigned int        n_samples,
               Random                   &random)
  {
    const auto                             normals = directions(100);
    std::uniform_real_distribution<double> unit(0, 1);
    WatchedCell                            cell(material);
    unsigned int                           n_misses = 0;
    for (unsigned int n = 0; n < n_samples; ++n)
      {
        const double size = largest_strain * std::pow(10, -4 * unit(random));
        const auto   h =
          rotated(random_rotation(random), random_gradient(random, size));
        const double tan     = std::tan(unit(random) * M_PI / 3);
        const auto   sigma   = stresses_of(tensor, h).cauchy;
        const auto   reached = reached_strengths(sigma, tan, normals);
        impose_gradient(cell.body.state, h);
        const double margin = .9 * (1 - 1e-9);
        if (reached.tension > 0 &&
            !cell.is_hot(bound_of(margin * reached.tension, never, tan)))
          ++n_misses;
        if (reached.cohesion > 0 &&
            !cell.is_hot(bound_of(never, margin * reached.cohesion, tan)))
          ++n_misses;
      }
    return n_misses;
  }
} // namespace

TEST(StressBound, NeverMissesSmallStrains)
{
  Random             random(1);
  MaterialParameters material = random_anisotropic(random);
  EXPECT_EQ(
    count_misses(material, stiffness_tensor(material), 1e-3, 25000, random),
    0u);
}

TEST(StressBound, NeverMissesFiniteStrains)
{
  Random             random(2);
  MaterialParameters material = random_anisotropic(random);
  EXPECT_EQ(
    count_misses(material, stiffness_tensor(material), 6e-2, 25000, random),
    0u);
}

// Here the tractions differ most from those of the second Piola-Kirchhoff
// stress, and the strength is a small difference of shear and friction. Strains
// reach the norm from which all cells are hot: pressures of 0.7 GPa in the
// orthotropic rock, and of 0.9 to 7 GPa in the isotropic ones.
TEST(StressBound, NeverMissesShearUnderStrongPressure)
{
  Random                                 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto                             normals  = directions(100);
  constexpr double                       cohesion = 1e5;
  unsigned int                           n_misses = 0, n_reached = 0;
  const auto look = [&](WatchedCell &cell, const Matrix3<double> &h) {
    cell.deform(h);
    const double tan =
      std::min(maximise(
                 [&](const auto &n) {
                   return cell.friction_at_strength(h, cohesion, n);
                 },
                 normals),
               std::tan(70 * M_PI / 180));
    if (tan <= 0)
      return;
    ++n_reached;
    const double margin = .9 * (1 - 1e-9);
    if (!cell.is_hot(bound_of(never, margin * cohesion, tan * (1 - 1e-9))))
      ++n_misses;
  };
  for (const double nu : {.1, .2, .3, .45})
    {
      MaterialParameters material = granite();
      material.poissons_ratio     = nu;
      WatchedCell cell(material);
      for (unsigned int n = 0; n < 2000; ++n)
        look(cell,
             compressed_gradient(random,
                                 .032 * unit(random),
                                 std::pow(unit(random), 2)));
    }
  WatchedCell cell(orthotropic_rock());
  for (unsigned int n = 0; n < 4000; ++n)
    look(cell,
         orthotropic_gradient(random,
                              .032 * unit(random),
                              .2 * std::pow(unit(random), 2)));
  EXPECT_EQ(n_misses, 0u);
  EXPECT_GT(n_reached, 10000u);
}

TEST(StressBound, UniaxialTensionIsHotAtTheBound)
{
  WatchedCell  cell(granite());
  const double strain = 1e-6, tension = 40.6e9 * strain;
  for (const auto &r : {unit_matrix, rotation({{.6, 0, .8}}, 1.)})
    {
      const Matrix3<double> h = product(
        product(
          r,
          {{{{strain, 0, 0}}, {{0, -.2 * strain, 0}}, {{0, 0, -.2 * strain}}}}),
        transpose(r));
      impose_gradient(cell.body.state, h);
      EXPECT_TRUE(cell.is_hot(bound_of(.999 * tension, never, 1)));
      EXPECT_FALSE(cell.is_hot(bound_of(1.001 * tension, never, 1)));
      EXPECT_TRUE(cell.is_hot(bound_of(never, .4 * tension, 0)));
      EXPECT_FALSE(cell.is_hot(bound_of(never, .7 * tension, 0)));
    }
}

TEST(StressBound, PressureIsNeverHot)
{
  WatchedCell cell(granite());
  impose_gradient(cell.body.state,
                  {{{{-1e-3, 0, 0}}, {{0, -1e-3, 0}}, {{0, 0, -1e-3}}}});
  EXPECT_FALSE(cell.is_hot(bound_of(1, 1e6, .1)));
  impose_gradient(cell.body.state, {});
  EXPECT_FALSE(cell.is_hot(bound_of(1, 1, .1)));
}

TEST(StressBound, ListsCellsOfWatchedMaterialsInOrder)
{
  // Three slabs; the one in the middle is not watched.
  Body box = make_box({{2, 2, 6}});
  for (LocalCell &cell : box.cells)
    cell.material = box.vertices[cell.vertices[0]][2] < 2 ? 0 :
                    box.vertices[cell.vertices[0]][2] < 4 ? 1 :
                                                            2;
  DiscreteBody  body = discretize(box, {1, 1, 1});
  const auto    law  = make_elasticity(granite());
  InternalForce force(body.topology, body.reference, {law, law, law});
  Activity      activity(body.topology);
  activity.wake_all(body.topology);
  const StressBounds bounds{
    {bound_of(3e6, never, 1), {}, bound_of(4e6, never, 1)},
    {}};
  force.watch(bounds);

  // Tension grows along x.
  for (std::size_t i = 0; i < body.state.n_nodes(); ++i)
    body.state.displacement[i][0] =
      .5e-4 * std::pow(body.state.reference[i][0], 2);
  EXPECT_FALSE(force.add_to(body.state, activity));
  std::vector<CellIndex> expected;
  for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
    {
      const unsigned int material = body.topology.material(cell);
      if (body.topology.is_padding(cell) || material == 1)
        continue;
      const auto s = force.cauchy_stress(body.state, cell);
      // Tension alone counts here: largest principal stress within 1e-3.
      const Matrix3<double> sigma = {
        {{{s[0], s[5], s[4]}}, {{s[5], s[1], s[3]}}, {{s[4], s[3], s[2]}}}};
      const double tension =
        reached_strengths(sigma, 0, directions(100)).tension;
      const double limit = material == 0 ? 3e6 : 4e6;
      if (tension > limit)
        expected.push_back(cell);
    }
  ASSERT_GT(expected.size(), 20u);
  EXPECT_LT(expected.size(), body.topology.n_cells() / 2);
  // The filter may list a few more, but none of the middle, and in order.
  const auto &hot = force.hot_cells();
  EXPECT_TRUE(std::is_sorted(hot.begin(), hot.end()));
  EXPECT_TRUE(
    std::includes(hot.begin(), hot.end(), expected.begin(), expected.end()));
  for (const CellIndex cell : hot)
    EXPECT_NE(body.topology.material(cell), 1);
}
