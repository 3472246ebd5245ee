#ifndef rift_material_elasticity_h
#define rift_material_elasticity_h

#include <rift/material/laws/all.h>

namespace rift
{
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
} // namespace rift

#endif
