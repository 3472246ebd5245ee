#ifndef rift_material_laws_anisotropic_h
#define rift_material_laws_anisotropic_h

#include <rift/material/laws/elastic_law.h>

namespace rift
{
  /**
   * General anisotropic St. Venant-Kirchhoff elasticity, S = C : E with a
   * tensor fixed in the undeformed body, hence exact under any rotation
   * (doc/theory.md, eq. 4).
   */
  struct AnisotropicElasticity
  {
    /** The value of the entry Elasticity, and its description there. */
    static constexpr const char *name    = "anisotropic";
    static constexpr const char *meaning = "anisotropic with 21";

    /** In the frame of the mesh, shear columns doubled, Pa. */
    StiffnessMatrix matrix;

    /** Entries of subsection Material that it uses. */
    static std::vector<std::string>
    entries()
    {
      return {"Stiffness", "Axis 1", "Axis 2"};
    }

    /** Numbers of its own: none. */
    static std::vector<ElasticConstant>
    constants()
    {
      return {};
    }

    /** Stiffness of a material in its axes, Pa. */
    static StiffnessMatrix
    stiffness(const MaterialParameters &p)
    {
      StiffnessMatrix result;
      unsigned int    k = 0;
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = i; j < 6; ++j, ++k)
          result[i][j] = result[j][i] = p.stiffness[k];
      return result;
    }

    /** The law of a material, turned into the frame of the mesh. */
    static AnisotropicElasticity
    make(const MaterialParameters &p)
    {
      return make(p, stiffness(p));
    }

    /** Of a stiffness in material axes, Pa. */
    static AnisotropicElasticity
    make(const MaterialParameters &p, const StiffnessMatrix &stiffness)
    {
      AnisotropicElasticity law{
        rotate_stiffness(stiffness, material_axes(p.axis_1, p.axis_2))};
      // The law sums over the six components of a strain, so that each shear
      // component stands for two.
      for (auto &row : law.matrix)
        for (unsigned int j = 3; j < 6; ++j)
          row[j] *= 2;
      return law;
    }

    /** Second Piola-Kirchhoff stress, Pa, of a Green-Lagrange strain. */
    template <typename Number>
    SymmetricTensor<Number>
    stress(const SymmetricTensor<Number> &strain) const
    {
      SymmetricTensor<Number> result;
      for (unsigned int i = 0; i < 6; ++i)
        {
          result[i] = matrix[i][0] * strain[0];
          for (unsigned int j = 1; j < 6; ++j)
            result[i] = result[i] + matrix[i][j] * strain[j];
        }
      return result;
    }
  };
} // namespace rift

#endif
