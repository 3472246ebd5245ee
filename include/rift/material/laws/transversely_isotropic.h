#ifndef rift_material_laws_transversely_isotropic_h
#define rift_material_laws_transversely_isotropic_h

#include <rift/material/laws/anisotropic.h>

namespace rift
{
  /** The same in all directions along the bedding, which lies across material
   * axis 3: shale, slate, foliated rock (doc/theory.md, eq. 4). */
  struct TransverselyIsotropicElasticity
  {
    /** The value of the entry Elasticity, and its description there. */
    static constexpr const char *name = "transversely isotropic";
    static constexpr const char *meaning =
      "transversely isotropic with five: the same in all directions across "
      "axis 3";

    /** Names of its constants. */
    static constexpr const char *modulus_along  = "Young's modulus along";
    static constexpr const char *modulus_across = "Young's modulus across";
    static constexpr const char *ratio_along    = "Poisson's ratio along";
    static constexpr const char *ratio_across   = "Poisson's ratio across";
    static constexpr const char *shear_across   = "Shear modulus across";

    /** Entries of subsection Material that it uses besides its constants. */
    static std::vector<std::string>
    entries()
    {
      return {"Axis 1", "Axis 2"};
    }

    /** Its five constants, with their descriptions. */
    static std::vector<ElasticConstant>
    constants()
    {
      return {{modulus_along,
               "Young's modulus of a transversely isotropic material along its "
               "bedding. Units: Pa."},
              {modulus_across,
               "Young's modulus across the bedding, along axis 3. Units: Pa."},
              {ratio_along,
               "Poisson's ratio between two directions along the bedding. "
               "Units: 1."},
              {ratio_across,
               "Contraction along the bedding over the stretch across it, "
               "under stress across it. Units: 1."},
              {shear_across,
               "Shear modulus between the bedding and axis 3. Units: Pa."}};
    }

    /** Stiffness of a material in its axes, Pa. */
    static StiffnessMatrix
    stiffness(const MaterialParameters &p)
    {
      const auto  &c  = p.elastic_constants;
      const double e1 = c.at(modulus_along), e3 = c.at(modulus_across);
      const double nu12 = c.at(ratio_along), nu31 = c.at(ratio_across);
      const double g = c.at(shear_across);

      // The inverse of the compliance.
      const double    coupling = nu31 * nu31 * e1 / e3;
      const double    d        = 1 - nu12 - 2 * coupling;
      StiffnessMatrix result{};
      result[0][0] = result[1][1] = e1 * (1 - coupling) / ((1 + nu12) * d);
      result[0][1] = result[1][0] = e1 * (nu12 + coupling) / ((1 + nu12) * d);
      for (unsigned int i = 0; i < 2; ++i)
        result[i][2] = result[2][i] = e1 * nu31 / d;
      result[2][2] = e3 * (1 - nu12) / d;
      result[3][3] = result[4][4] = g;
      result[5][5]                = e1 / (2 * (1 + nu12));
      return result;
    }

    /** The law of a material, turned into the frame of the mesh. */
    static AnisotropicElasticity
    make(const MaterialParameters &p)
    {
      return AnisotropicElasticity::make(p, stiffness(p));
    }
  };
} // namespace rift

#endif
