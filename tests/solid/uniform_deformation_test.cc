// Bodies under linear displacement fields: the patch test and rotations.

#include "../support/elastic_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  Body
  random_box(Random &random)
  {
    return make_box({{3, 3, 3}}, 1, .12, random());
  }

  Matrix3<double>
  cauchy(const ElasticBody &body, const CellIndex cell)
  {
    const auto      sigma = body.force.cauchy_stress(body.state, cell);
    Matrix3<double> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        result[i][j] = sigma[place(i, j)];
    return result;
  }

  double
  largest_stress(const ElasticBody &body)
  {
    double result = 0;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      if (!body.topology.is_padding(cell))
        result = std::max(result, largest(cauchy(body, cell)));
    return result;
  }

  /** Largest forces on nodes inside and on the surface. */
  struct LargestForces
  {
    double inside, at_surface;
  };

  LargestForces
  largest_forces(const ElasticBody &body)
  {
    const auto surface =
      surface_nodes(body.topology, whole_surface(body.topology));
    LargestForces result{0, 0};
    for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
      {
        const bool is_at_surface =
          std::binary_search(surface.begin(), surface.end(), i);
        double &entry = is_at_surface ? result.at_surface : result.inside;
        entry         = std::max(entry, norm(body.state.force[i].vector()));
      }
    EXPECT_LT(surface.size(), body.state.n_nodes());
    return result;
  }

  /** What output and probes can have of a Cauchy stress. */
  void
  test_fields(const ElasticBody     &body,
              const Matrix3<double> &expected,
              const double           tolerance)
  {
    FieldList fields(body.state, 0);
    InternalForce::declare_fields(fields, &body.force);
    const auto value = [&](const char *name) {
      Vector3<double> values{};
      fields.find(name, FieldLocation::cell)->values(0, values.data());
      return values;
    };
    double trace = 0, square = 0;
    for (unsigned int i = 0; i < 3; ++i)
      {
        trace += expected[i][i];
        square += dot(expected[i], expected[i]);
      }
    EXPECT_NEAR(value("pressure")[0], -trace / 3, tolerance);

    // Their invariants are those of the stress.
    const Vector3<double> principal = value("principal stress");
    EXPECT_GE(principal[0], principal[1]);
    EXPECT_GE(principal[1], principal[2]);
    const double size = std::sqrt(square);
    EXPECT_NEAR(principal[0] + principal[1] + principal[2], trace, tolerance);
    EXPECT_NEAR(dot(principal, principal), square, tolerance * size);
    EXPECT_NEAR(principal[0] * principal[1] * principal[2],
                determinant(expected),
                tolerance * size * size);
  }

  void
  test_patch(const MaterialParameters &material,
             const Tensor4            &tensor,
             const Matrix3<double>    &h,
             Random                   &random)
  {
    ElasticBody body(random_box(random), material);
    impose_gradient(body.state, h);
    EXPECT_FALSE(body.force.add_to(body.state, body.activity));

    const Matrix3<double> expected  = stresses_of(tensor, h).cauchy;
    const double          tolerance = 1e-12 * largest(expected);
    ASSERT_GT(tolerance, 0);
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      if (!body.topology.is_padding(cell))
        {
          const Matrix3<double> sigma = cauchy(body, cell);
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              EXPECT_NEAR(sigma[i][j], expected[i][j], tolerance);
        }
    test_fields(body, expected, 10 * tolerance);
    const LargestForces forces = largest_forces(body);
    EXPECT_LT(forces.inside, 1e-12 * forces.at_surface);
  }

  Matrix3<double>
  scaled(const double factor, Matrix3<double> a)
  {
    for (auto &row : a)
      row = factor * row;
    return a;
  }
} // namespace

TEST(PatchTest, AnisotropicSmallAndFinite)
{
  Random random(1);
  for (const double size : {1e-7, 1e-3, .15})
    for (unsigned int n = 0; n < 15; ++n)
      {
        const MaterialParameters material = random_anisotropic(random);
        test_patch(material,
                   stiffness_tensor(material),
                   scaled(size, random_matrix(random)),
                   random);
      }
}

TEST(PatchTest, AnisotropicAfterLargeRotation)
{
  Random random(2);
  for (unsigned int n = 0; n < 15; ++n)
    {
      const MaterialParameters material = random_anisotropic(random);
      test_patch(
        material,
        stiffness_tensor(material),
        rotated(random_rotation(random), scaled(.1, random_matrix(random))),
        random);
    }
}

TEST(PatchTest, Isotropic)
{
  // The isotropic tensor as an anisotropic material in any frame.
  Random                random(3);
  MaterialParameters    as_anisotropic = random_anisotropic(random);
  const StiffnessMatrix c = stiffness_matrix(make_elasticity(granite()));
  unsigned int          k = 0;
  for (unsigned int i = 0; i < 6; ++i)
    for (unsigned int j = i; j < 6; ++j, ++k)
      as_anisotropic.stiffness[k] = c[i][j];
  const Tensor4 tensor = stiffness_tensor(as_anisotropic);
  for (const double size : {1e-7, 1e-3, .15})
    for (unsigned int n = 0; n < 10; ++n)
      {
        const auto h = scaled(size, random_matrix(random));
        test_patch(granite(), tensor, h, random);
        test_patch(as_anisotropic, tensor, h, random);
      }
}

TEST(RigidRotation, GivesNoStress)
{
  Random                   random(4);
  const MaterialParameters anisotropic = random_anisotropic(random);
  double                   stiffest    = 0;
  for (const double entry : anisotropic.stiffness)
    stiffest = std::max(stiffest, entry);

  for (const auto &[material, modulus] :
       {std::make_pair(granite(), 40.6e9),
        std::make_pair(anisotropic, stiffest)})
    {
      ElasticBody body(random_box(random), material);
      for (unsigned int n = 0; n < 100; ++n)
        {
          // Angles of a full turn, a half turn and a nearly half turn too.
          const double angle = n < 10 ? M_PI :
                               n < 20 ? M_PI + 1e-8 * (n - 15.) :
                                        2 * M_PI * (n - 20) / 79;
          impose_gradient(
            body.state,
            rotated(rotation(random_direction(random), angle), {}),
            {{.3, -.2, .5}});
          EXPECT_LT(largest_stress(body), 1e-12 * modulus) << angle;
        }
    }
}
