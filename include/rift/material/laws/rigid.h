#ifndef rift_material_laws_rigid_h
#define rift_material_laws_rigid_h

#include <rift/material/laws/elastic_law.h>

namespace rift
{
  /** Of cells that do not deform: no stress, whatever the rounding. */
  struct RigidElasticity
  {
    /** The value of the entry Elasticity, and its description there. */
    static constexpr const char *name = "rigid";
    static constexpr const char *meaning =
      "rigid: does not deform and acts on others by contact alone";

    /** Entries of subsection Material that it uses: none. */
    static std::vector<std::string>
    entries()
    {
      return {};
    }

    /** Numbers of its own: none. */
    static std::vector<ElasticConstant>
    constants()
    {
      return {};
    }

    /** Zero: the law has no stiffness. */
    static StiffnessMatrix
    stiffness(const MaterialParameters &)
    {
      return {};
    }

    /** The law, which has no parameters. */
    static RigidElasticity
    make(const MaterialParameters &)
    {
      return {};
    }

    /** Zero, whatever the strain. */
    template <typename Number>
    SymmetricTensor<Number>
    stress(const SymmetricTensor<Number> &) const
    {
      return {};
    }
  };
} // namespace rift

#endif
