#ifndef rift_module_step_limits_h
#define rift_module_step_limits_h

#include <rift/base/types.h>

#include <functional>
#include <string>
#include <vector>

namespace rift
{
  /** What makes the cells of a material faster or stiffer than their elasticity
   * alone. */
  struct MaterialRoom
  {
    /**
     * Stiffness that modules may add to a loose cell: the square of its largest
     * frequency may grow by three times this factor, one for each of the faces
     * that meet at a corner (doc/theory.md, eq. 21).
     */
    double stiffness_factor = 0;

    /** Pa s */
    double viscosity = 0;
  };

  /** What modules need of the time step. */
  struct StepLimits
  {
    /** No requirements, of this number of materials. */
    explicit StepLimits(const std::size_t n_materials)
      : materials(n_materials)
    {
    }

    /** By material index. */
    std::vector<MaterialRoom> materials;

    /** What modules add at most to the square of a frequency of a loose cell,
     * 1/s^2; empty: nothing. For stiffnesses that the scene gives. */
    std::function<double(CellIndex)> added_frequency_squared;
  };

  /** What the time step leaves for stiffnesses that adapt to it. */
  struct StepBound
  {
    /** Square of the frequency that a loose cell may reach with everything that
     * acts on it, 1/s^2. */
    double frequency_squared;

    /** What of that stiffnesses which the scene gives use up in a cell, 1/s^2;
     * empty: nothing. */
    std::function<double(CellIndex)> added_frequency_squared;
  };
} // namespace rift

#endif
