#ifndef rift_material_laws_isotropic_h
#define rift_material_laws_isotropic_h

#include <rift/material/laws/elastic_law.h>

namespace rift
{
  /**
   * Isotropic St. Venant-Kirchhoff elasticity, S = lambda tr(E) I + 2 mu E
   * (doc/theory.md, eq. 3).
   */
  struct IsotropicElasticity
  {
    /** The value of the entry Elasticity, and its description there. */
    static constexpr const char *name    = "isotropic";
    static constexpr const char *meaning = "isotropic with two constants";

    /** Lame's constants, Pa. */
    double lambda, mu;

    /** Entries of subsection Material that it uses. */
    static std::vector<std::string>
    entries()
    {
      return {"Young's modulus", "Poisson's ratio"};
    }

    /** Numbers of its own: none. */
    static std::vector<ElasticConstant>
    constants()
    {
      return {};
    }

    /** The law of a material, from Young's modulus and Poisson's ratio. */
    static IsotropicElasticity
    make(const MaterialParameters &p)
    {
      const double e = p.youngs_modulus, nu = p.poissons_ratio;
      return {e * nu / ((1 + nu) * (1 - 2 * nu)), e / (2 * (1 + nu))};
    }

    /** Stiffness of a material, the same in all axes, Pa. */
    static StiffnessMatrix
    stiffness(const MaterialParameters &p);

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
} // namespace rift

#endif
