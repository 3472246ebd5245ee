#ifndef rift_tests_support_barre_granite_h
#define rift_tests_support_barre_granite_h

#include <rift/material/material_parameters.h>

namespace rift::test
{
  /** Barre granite, elastic: orthotropic, the axes normal to hardway, grain and
   * rift (Fukuda et al. 2021, Table 1). */
  inline MaterialParameters
  barre_granite()
  {
    MaterialParameters material;
    material.name       = "barre";
    material.density    = 2660;
    material.elasticity = MaterialParameters::Elasticity::anisotropic;
    material.stiffness  = {{54.7e9, 8.08e9, 7.13e9, 0, 0,      0, 40.7e9,
                            5.54e9, 0,      0,      0, 35.2e9, 0, 0,
                            0,      15.5e9, 0,      0, 17.9e9, 0, 19.2e9}};
    return material;
  }
} // namespace rift::test

#endif
