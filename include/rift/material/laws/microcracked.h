#ifndef rift_material_laws_microcracked_h
#define rift_material_laws_microcracked_h

#include <rift/material/laws/anisotropic.h>
#include <rift/material/laws/isotropic.h>

namespace rift
{
  /** What groups of microcracks leave of an isotropic material (doc/theory.md,
   * section 10). */
  struct MicrocrackedElasticity
  {
    /** The value of the entry Elasticity, and its description there. */
    static constexpr const char *name = "microcracked";
    static constexpr const char *meaning =
      "microcracked: what groups of microcracks leave of an isotropic one";

    /** Entries of subsection Material that it uses. */
    static std::vector<std::string>
    entries()
    {
      return {"Young's modulus",
              "Poisson's ratio",
              "Crack groups",
              "Crack scheme",
              "Axis 1",
              "Axis 2"};
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
      // What leaves no stiffness has been refused before.
      return stiffness_with_cracks(IsotropicElasticity::stiffness(p),
                                   p.crack_groups,
                                   p.crack_scheme)
        .value();
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
