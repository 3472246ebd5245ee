#ifndef rift_tests_benchmarks_granite_h
#define rift_tests_benchmarks_granite_h

#include <rift/material/material_parameters.h>
#include <rift/solid/internal_force.h>

#include "../support/test_body.h"

/** The rock of the spalling scene in a box, for all benchmarks. */
namespace rift::test
{
  constexpr double granite_edge = 2.5e-3;

  inline MaterialParameters
  granite()
  {
    MaterialParameters material;
    material.name              = "granite";
    material.density           = 2641;
    material.youngs_modulus    = 40.6e9;
    material.poissons_ratio    = .2;
    material.tensile_strength  = 15e6;
    material.cohesion          = 36.7e6;
    material.friction_angle    = 50 * M_PI / 180;
    material.fracture_energy_1 = 400;
    material.fracture_energy_2 = 400;
    return material;
  }

  /** The same elasticity, by way of 21 constants. */
  inline MaterialParameters
  granite_as_anisotropic()
  {
    MaterialParameters material = granite();
    const auto         c        = stiffness_matrix(make_elasticity(granite()));
    material.elasticity         = MaterialParameters::Elasticity::anisotropic;
    unsigned int k              = 0;
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = i; j < 6; ++j, ++k)
        material.stiffness[k] = c[i][j];
    material.axis_1 = {{1, 2, 3}};
    material.axis_2 = {{-2, 1, .5}};
    return material;
  }

  /** A cube of 6 n^3 tetrahedra of irregular shape, in motion: strains of
   * about 1e-5, far below the strength. */
  inline DiscreteBody
  moving_granite(const unsigned int n)
  {
    DiscreteBody body =
      discretize(make_box({{n, n, n}}, granite_edge, .15), {granite().density});
    std::mt19937                           random(1);
    std::uniform_real_distribution<double> noise(-1e-5 * granite_edge,
                                                 1e-5 * granite_edge);
    for (NodalVector &u : body.state.displacement)
      for (unsigned int d = 0; d < dim; ++d)
        u[d] = noise(random);
    return body;
  }
} // namespace rift::test

#endif
