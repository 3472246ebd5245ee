#ifndef rift_material_elasticity_h
#define rift_material_elasticity_h

#include <rift/base/simd.h>
#include <rift/material/material_parameters.h>

#include <variant>
#include <vector>

namespace rift
{
  /**
   * A symmetric tensor of second order as a row of its components
   * 11, 22, 33, 23, 13, 12 (Voigt's order; no factors of two).
   */
  template <typename Number>
  using SymmetricTensor = std::array<Number, 6>;

  /** Position of component (i, j) of a symmetric tensor in such a row. */
  constexpr std::array<std::array<unsigned int, 3>, 3> voigt = {
    {{{0, 5, 4}}, {{5, 1, 3}}, {{4, 3, 2}}}};

  /**
   * Isotropic St. Venant-Kirchhoff elasticity, S = lambda tr(E) I + 2 mu E
   * (doc/theory.md, eq. 3).
   */
  struct IsotropicElasticity
  {
    /** Lame's constants, Pa. */
    double lambda, mu;

    /** Second Piola-Kirchhoff stress, Pa, of a Green-Lagrange strain. */
    template <typename Number>
    SymmetricTensor<Number>
    stress(const SymmetricTensor<Number> &strain) const
    {
      const Number volumetric = lambda * (strain[0] + strain[1] + strain[2]);
      const double two_mu     = 2 * mu;
      return {{two_mu * strain[0] + volumetric,
               two_mu * strain[1] + volumetric,
               two_mu * strain[2] + volumetric,
               two_mu * strain[3],
               two_mu * strain[4],
               two_mu * strain[5]}};
    }
  };

  /**
   * General anisotropic St. Venant-Kirchhoff elasticity, S = C : E with a
   * tensor fixed in the undeformed body, hence exact under any rotation
   * (doc/theory.md, eq. 4).
   */
  struct AnisotropicElasticity
  {
    /** In the frame of the mesh, shear columns doubled, Pa. */
    StiffnessMatrix stiffness;

    template <typename Number>
    SymmetricTensor<Number>
    stress(const SymmetricTensor<Number> &strain) const
    {
      SymmetricTensor<Number> result;
      for (unsigned int i = 0; i < 6; ++i)
        {
          result[i] = stiffness[i][0] * strain[0];
          for (unsigned int j = 1; j < 6; ++j)
            result[i] = result[i] + stiffness[i][j] * strain[j];
        }
      return result;
    }
  };

  /** Of cells that do not deform: no stress, whatever the rounding. */
  struct RigidElasticity
  {
    template <typename Number>
    SymmetricTensor<Number>
    stress(const SymmetricTensor<Number> &) const
    {
      return {};
    }
  };

  /** The elastic laws; a new one is a struct above and a name here. */
  using Elasticity =
    std::variant<IsotropicElasticity, AnisotropicElasticity, RigidElasticity>;

  /** Of an isotropic material, or of a microcracked one without its cracks, in
   * Voigt's notation, Pa. */
  StiffnessMatrix
  isotropic_stiffness(const MaterialParameters &parameters);

  /** Stiffness of an elastic material in its axes, in Voigt's notation, Pa. */
  StiffnessMatrix
  stiffness_in_material_axes(const MaterialParameters &parameters);

  /** The law that a material asks for. */
  Elasticity
  make_elasticity(const MaterialParameters &parameters);

  /** Stiffness of a law in the frame of the mesh, in Voigt's notation, Pa. */
  StiffnessMatrix
  stiffness_matrix(const Elasticity &elasticity);

  /** Young's modulus of the mean of a stiffness over all directions (Voigt),
   * Pa: that of the material itself where it is isotropic. */
  double
  mean_youngs_modulus(const StiffnessMatrix &stiffness);

  /**
   * Turns a stiffness from material axes into the frame of the mesh.
   *
   * @param axes the three material axes, orthonormal, row by row.
   */
  StiffnessMatrix
  rotate_stiffness(const StiffnessMatrix &stiffness,
                   const Matrix3<double> &axes);

  /**
   * Orthonormal material axes from two directions: the first as given, the
   * second freed of its part along the first, the third their product.
   */
  Matrix3<double>
  material_axes(const Vector3<double> &axis_1, const Vector3<double> &axis_2);
} // namespace rift

#endif
