#ifndef rift_material_laws_elastic_law_h
#define rift_material_laws_elastic_law_h

#include <rift/base/simd.h>
#include <rift/material/material_parameters.h>

/**
 * @file
 *
 * What elastic laws share. A law is a structure with static members:
 *
 *     name        the word for it in Material/Elasticity
 *     meaning     what it is, for the documentation of that entry
 *     entries()   names of the entries of subsection Material that it uses, of
 *                 those that every material has
 *     constants() entries of its own
 *     stiffness() in material axes, Pa
 *     make()      the structure that computes the stress, see below
 *
 * The stress is computed by a structure with a member function `stress`; most
 * laws use AnisotropicElasticity for that. A law stands in the list of
 * laws/all.h and nowhere else.
 */
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

  /** A number of subsection Material that one law alone uses. */
  struct ElasticConstant
  {
    /** Name of the entry in subsection Material. */
    std::string name;

    /** Ends with "Units: X.". */
    std::string documentation;
  };

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
