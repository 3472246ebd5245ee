#ifndef rift_material_laws_rigid_h
#define rift_material_laws_rigid_h

#include <rift/material/laws/elastic_law.h>

namespace rift
{
  /** Of cells that do not deform: no stress, whatever the rounding. */
  struct RigidElasticity
  {
    static constexpr const char *name = "rigid";
    static constexpr const char *meaning =
      "rigid: does not deform and acts on others by contact alone";

    static std::vector<std::string>
    entries()
    {
      return {};
    }

    static std::vector<ElasticConstant>
    constants()
    {
      return {};
    }

    static StiffnessMatrix
    stiffness(const MaterialParameters &)
    {
      return {};
    }

    static RigidElasticity
    make(const MaterialParameters &)
    {
      return {};
    }

    template <typename Number>
    SymmetricTensor<Number>
    stress(const SymmetricTensor<Number> &) const
    {
      return {};
    }
  };
} // namespace rift

#endif
