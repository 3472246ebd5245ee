#include "breaking_body.h"
#include <gtest/gtest.h>

using namespace rift;
using namespace rift::test;

namespace
{
  using Vector = Vector3<double>;
  using Matrix = Matrix3<double>;

  constexpr double edge = 1e-3;

  /** Displaces all nodes by a linear field, u = gradient X. */
  void
  strain(BreakingBody &body, const Matrix &gradient)
  {
    for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
      {
        const Vector u = gradient * body.state.reference[i].vector();
        for (unsigned int d = 0; d < dim; ++d)
          body.state.displacement[i][d] = u[d];
      }
  }

  /** What a simulation does to find the faces that break. */
  std::vector<FaceIndex>
  find_faces(BreakingBody &body)
  {
    body.state.force.assign(body.state.n_nodes(), NodalVector());
    EXPECT_FALSE(body.internal_force.add_to(body.state, body.activity));
    return body.insertion.find_faces(body.state,
                                     body.internal_force.hot_cells());
  }

  Matrix
  deformation_gradient(const BreakingBody &body, const CellIndex cell)
  {
    Matrix f = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        const Vector g = body.discrete.reference[cell / batch_size].gradient(
          c,
          cell % batch_size);
        const NodeIndex node = body.topology.node(cell, c);
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            f[i][d] += body.state.displacement[node][i] * g[d];
      }
    return f;
  }

  /** Second Piola-Kirchhoff stress of one isotropic cell, by textbook. */
  Matrix
  second_stress(const BreakingBody &body, const CellIndex cell)
  {
    const Matrix              f = deformation_gradient(body, cell);
    const MaterialParameters &m = body.materials[body.topology.material(cell)];
    const double mu = m.youngs_modulus / (2 * (1 + m.poissons_ratio));
    const double lambda =
      2 * mu * m.poissons_ratio / (1 - 2 * m.poissons_ratio);
    Matrix strain{}, s{};
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        {
          for (unsigned int k = 0; k < dim; ++k)
            strain[i][j] += .5 * f[k][i] * f[k][j];
          strain[i][j] -= .5 * (i == j);
        }
    const double trace = strain[0][0] + strain[1][1] + strain[2][2];
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        s[i][j] = 2 * mu * strain[i][j] + (i == j ? lambda * trace : 0);
    return s;
  }

  Matrix
  nominal_stress(const BreakingBody &body, const CellIndex cell)
  {
    return deformation_gradient(body, cell) * second_stress(body, cell);
  }

  /**
   * How near a face is to its strength, by the definition: the
   * larger of sigma_n - T and |tau| - c + min(sigma_n, 0) tan(phi), Pa.
   */
  double
  excess(const BreakingBody &body, const FaceIndex face)
  {
    const Face &f = body.topology.faces[face];
    Vector      x[3], reference[3];
    for (unsigned int c = 0; c < 3; ++c)
      {
        const NodeIndex node =
          body.topology.node(f.cells[0], face_corners[f.local_faces[0]][c]);
        x[c]         = body.state.position(node);
        reference[c] = body.state.reference[node].vector();
      }
    const auto unit_normal = [](const Vector *y) {
      const Vector n = cross(y[1] - y[0], y[2] - y[0]);
      return (1 / norm(n)) * n;
    };
    const Vector reference_normal = unit_normal(reference);
    const Vector normal           = unit_normal(x);
    const Vector traction =
      .5 * (nominal_stress(body, f.cells[0]) * reference_normal +
            nominal_stress(body, f.cells[1]) * reference_normal);
    const double       sigma = dot(traction, normal);
    const double       tau   = norm(traction - sigma * normal);
    const FaceStrength s     = body.strengths.strength(face);
    return std::max(sigma - s.tensile_strength,
                    tau - s.cohesion +
                      std::min(sigma, 0.) * s.tan_friction_angle);
  }

  std::vector<FaceIndex>
  brute_force(const BreakingBody &body)
  {
    std::vector<FaceIndex> faces;
    for (const FaceIndex face : body.all_faces())
      if (body.topology.face_states[face] == FaceState::intact &&
          body.strengths.is_breakable(face) && excess(body, face) >= 0)
        faces.push_back(face);
    return faces;
  }

  /** Lame's constants of granite(). */
  constexpr double mu = 40.6e9 / 2.4, lambda = 2 * mu * .2 / .6;

  /** A gradient that stretches along x and shears y and z against it, so that
   * the plane x = const has about this traction while all is small. */
  Matrix
  traction_on_x(const double normal, const double shear)
  {
    Matrix g{};
    g[0][0] = normal / (lambda + 2 * mu);
    g[1][0] = .6 * shear / mu;
    g[2][0] = .8 * shear / mu;
    return g;
  }

  /** Whether a face of the plane x = edge is found, and whether all are. */
  void
  expect_found(const double normal, const double shear, const bool is_found)
  {
    BreakingBody body(make_box({2, 1, 1}, edge));
    const auto   plane = body.faces_in_plane(0, edge);
    ASSERT_EQ(plane.size(), 2u);
    strain(body, traction_on_x(normal, shear));
    const auto found = find_faces(body);
    for (const FaceIndex face : plane)
      EXPECT_EQ(std::find(found.begin(), found.end(), face) != found.end(),
                is_found)
        << normal << " " << shear;
  }

  /**
   * Scales a traction until the face of the plane is at its strength by the
   * definition, and looks just below and above that.
   */
  void
  expect_threshold(const double normal, const double shear)
  {
    BreakingBody    body(make_box({2, 1, 1}, edge));
    const FaceIndex face = body.faces_in_plane(0, edge)[0];
    double          low = 0, high = 2;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle = .5 * (low + high);
        strain(body, traction_on_x(middle * normal, middle * shear));
        (excess(body, face) >= 0 ? high : low) = middle;
      }
    // Strains of 0.3 % leave the strength about where it is expected.
    EXPECT_NEAR(high, 1, 1e-2);
    expect_found(high * (1 - 1e-9) * normal, high * (1 - 1e-9) * shear, false);
    expect_found(high * (1 + 1e-9) * normal, high * (1 + 1e-9) * shear, true);
  }

  /** Of a rock that is stiffer or softer along x, Pa. */
  std::array<double, 21>
  stiffness_without_poisson_effect(const double along_x)
  {
    std::array<double, 21> stiffness{};
    const double diagonal[6] = {along_x, 40e9, 40e9, 20e9, 20e9, 20e9};
    for (unsigned int i = 0, k = 0; i < 6; k += 6 - i, ++i)
      stiffness[k] = diagonal[i];
    return stiffness;
  }

  /** Tangent of the friction angle for which a face under pressure is at its
   * strength, by the definition. */
  double
  friction_at_strength(const BreakingBody &body,
                       const FaceIndex     face,
                       const double        cohesion)
  {
    const Face  &f    = body.topology.faces[face];
    const Vector area = reference_area_vector(body.discrete.reference,
                                              f.cells[0],
                                              f.local_faces[0]);
    Vector       traction{};
    for (const CellIndex cell : f.cells)
      {
        const auto stress =
          body.internal_force.stress(body.state, cell / batch_size).first;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            traction[i] +=
              stress[i][d][cell % batch_size] * area[d] / (2 * norm(area));
      }
    const Vector normal = current_normal(body.topology, body.state, f);
    const double sigma  = dot(traction, normal);
    return (norm(traction - sigma * normal) - cohesion) / -sigma;
  }

  /** A random stress in each part of the body, strong in places. */
  void
  strain_at_random(BreakingBody &body, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> value(-1, 1);
    Matrix                                 gradient;
    for (auto &row : gradient)
      for (double &g : row)
        g = 1e-3 * value(random);
    strain(body, gradient);
    const double noise = edge * 4e-4 * (1 + value(random));
    for (NodalVector &u : body.state.displacement)
      for (unsigned int d = 0; d < dim; ++d)
        u[d] += noise * value(random);
  }
} // namespace

TEST(Insertion, TensionCutOff)
{
  const auto m = granite_strength();
  expect_threshold(m.tensile_strength, 0);
  expect_threshold(m.tensile_strength, .9 * m.cohesion);
}

TEST(Insertion, CohesionInTensionAndFrictionInCompression)
{
  const auto m = granite_strength();
  expect_threshold(0, m.cohesion);
  expect_threshold(.5 * m.tensile_strength, m.cohesion);
  const double pressure = 20e6;
  expect_threshold(-pressure, m.cohesion + m.tan_friction_angle * pressure);
  expect_found(-pressure, 0, false);
  expect_found(-10 * pressure, 0, false);
}

// The way by hot cells must find what looking at every face finds.
TEST(Insertion, AgreesWithBruteForce)
{
  std::mt19937 random(1);
  std::size_t  n_found = 0, n_missed = 0;
  auto         weak   = granite();
  weak.cohesion       = 10e6;
  weak.friction_angle = .2;
  for (unsigned int sample = 0; sample < 400; ++sample)
    {
      auto shape = make_box({2, 2, 2}, edge, .2, sample);
      for (LocalCell &cell : shape.cells)
        cell.material = random() % 2;
      auto other            = weak;
      other.weibull_modulus = sample % 2 ? 5 : 0;
      auto parameters       = parameters_of(CohesiveModel::extrinsic);
      parameters.seed       = sample;
      BreakingBody body(shape, {granite(), other}, .25, parameters);
      // Some faces are cut already.
      for (const FaceIndex face : body.all_faces())
        if (random() % 10 == 0)
          body.topology.face_states[face] = FaceState::cut;
      strain_at_random(body, random);

      const auto expected = brute_force(body);
      ASSERT_EQ(find_faces(body), expected) << "sample " << sample;
      n_found += expected.size();
      n_missed += body.all_faces().size() - expected.size();
    }
  EXPECT_GT(n_found, 1000u);
  EXPECT_GT(n_missed, 1000u);
}

// A body that has turned breaks at the same faces.
TEST(Insertion, DoesNotDependOnTheOrientation)
{
  for (const double angle : {.5, M_PI / 2, M_PI})
    {
      const auto found = [&](const double turn) {
        BreakingBody body(make_box({2, 2, 2}, edge, .2, 7));
        Matrix       gradient{};
        gradient[0][0] = -2. * 201.7e6 / 40.6e9;
        gradient[1][1] = gradient[2][2] = -.2 * gradient[0][0];
        strain(body, gradient);
        for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
          {
            const Vector x = body.state.position(i);
            const double c = std::cos(turn), s = std::sin(turn);
            const Vector turned = {
              {c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]}};
            for (unsigned int d = 0; d < dim; ++d)
              body.state.displacement[i][d] =
                turned[d] - body.state.reference[i][d];
          }
        return find_faces(body);
      };
      EXPECT_GT(found(0).size(), 10u);
      EXPECT_EQ(found(angle), found(0));
    }
}

// The tractions of two cells that share one face are independent, so that the
// mean may be at the strength while both sides are not: the criterion is not
// convex where friction begins.
TEST(Insertion, SeesTheMeanOfUnlikeSides)
{
  Body shape;
  shape.vertices = {{{0, 0, 0}},
                    {{edge, 0, 0}},
                    {{.2 * edge, edge, 0}},
                    {{.3 * edge, .3 * edge, .9 * edge}},
                    {{.4 * edge, .3 * edge, -.8 * edge}}};
  shape.cells    = {{0, {{0, 1, 2, 3}}, 0}, {0, {{0, 2, 1, 4}}, 0}};
  BreakingBody body(shape);

  std::mt19937                           random(2);
  std::uniform_real_distribution<double> value(-3e-3 * edge, 3e-3 * edge);
  unsigned int                           n_found = 0;
  for (unsigned int sample = 0; sample < 100000; ++sample)
    {
      for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
        if (std::abs(body.state.reference[i][2]) > .1 * edge)
          for (unsigned int d = 0; d < dim; ++d)
            body.state.displacement[i][d] = value(random);
      const auto expected = brute_force(body);
      ASSERT_EQ(find_faces(body), expected) << "sample " << sample;
      n_found += expected.size();
    }
  EXPECT_GT(n_found, 10000u);
  EXPECT_LT(n_found, 90000u);
}

// Under pressure, faces that are just at their strength and have hardly any
// cohesion: their shear is a small difference from the friction, and not quite
// that of the second Piola-Kirchhoff stress.
TEST(Insertion, FindsFacesUnderStrongPressure)
{
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> value(-1, 1);
  const auto                             shape    = make_box({2, 1, 1}, edge);
  constexpr double                       cohesion = 1e5;
  unsigned int                           n_tested = 0;
  for (unsigned int sample = 0; sample < 1000; ++sample)
    {
      const double stiffness_x = sample % 2 ? 40e9 : 60e9;
      auto         rock        = granite();
      rock.cohesion            = cohesion;
      rock.tensile_strength    = cohesion;
      rock.elasticity          = MaterialParameters::Elasticity::anisotropic;
      rock.stiffness           = stiffness_without_poisson_effect(stiffness_x);
      BreakingBody body(shape, {rock});

      const double pressure  = 4e8 * (1 + value(random));
      const double deviation = .2 * std::pow(value(random), 2);
      Matrix       gradient{};
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          gradient[i][j] = gradient[j][i] =
            -pressure * ((i == j) + deviation * value(random)) /
            (i == 0 ? stiffness_x : 40e9);
      strain(body, gradient);
      const FaceIndex face = sample / 2 % body.topology.faces.size();
      const double    tan  = friction_at_strength(body, face, cohesion);
      if (tan < 0 || tan > std::tan(70 * M_PI / 180))
        continue;

      rock.friction_angle = std::atan(tan * (1 - 1e-9));
      BreakingBody with_friction(shape, {rock});
      strain(with_friction, gradient);
      const auto found = find_faces(with_friction);
      EXPECT_TRUE(std::binary_search(found.begin(), found.end(), face))
        << "sample " << sample << ", tangent " << tan;
      ++n_tested;
    }
  EXPECT_GT(n_tested, 600u);
}

// Under half of its mean strength, a body whose strengths scatter: only cells
// with a weak face are examined.
TEST(Insertion, OnlyCellsWithWeakFacesAreHot)
{
  auto rock            = granite();
  rock.weibull_modulus = 5;
  BreakingBody body(make_box({8, 8, 8}, edge, .2), {rock});
  const double stress = .5 * granite_strength().tensile_strength;
  Matrix       gradient{};
  gradient[0][0] = stress / 40.6e9;
  gradient[1][1] = gradient[2][2] = -.2 * gradient[0][0];
  strain(body, gradient);
  EXPECT_EQ(find_faces(body), brute_force(body));

  // In uniaxial tension the first bound of (10) is exact.
  std::vector<CellIndex> expected;
  for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
    {
      double weakest = 1e30;
      for (const FaceIndex face : body.topology.cell_faces[cell])
        if (!body.topology.is_padding(cell) && face != invalid_index)
          weakest =
            std::min(weakest, body.strengths.strength(face).tensile_strength);
      // No cell is within the error of the small strain.
      EXPECT_GT(std::abs(stress / (.9 * weakest) - 1), 1e-6);
      if (stress > .9 * weakest)
        expected.push_back(cell);
    }
  EXPECT_EQ(body.internal_force.hot_cells(), expected);
  EXPECT_GT(expected.size(), 100u);
  EXPECT_LT(expected.size(), body.topology.n_cells() / 4);
}

TEST(Insertion, UnbreakableMaterialIsNeverCut)
{
  auto hard      = granite();
  hard.breakable = false;
  auto shape     = make_box({4, 2, 2}, edge);
  for (LocalCell &cell : shape.cells)
    for (const VertexIndex v : cell.vertices)
      if (shape.vertices[v][0] > 2.5 * edge)
        cell.material = 1;
  BreakingBody body(shape, {granite(), hard});
  strain(body, traction_on_x(100e6, 0));
  const auto  found  = find_faces(body);
  std::size_t n_soft = 0;
  for (const FaceIndex face : body.all_faces())
    {
      const Face &f       = body.topology.faces[face];
      const bool  is_soft = body.topology.material(f.cells[0]) == 0 &&
                           body.topology.material(f.cells[1]) == 0;
      EXPECT_EQ(body.strengths.is_breakable(face), is_soft);
      n_soft += is_soft;
    }
  for (const FaceIndex face : found)
    EXPECT_TRUE(body.strengths.is_breakable(face));
  EXPECT_GT(found.size(), n_soft / 2);
}
