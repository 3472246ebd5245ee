#ifndef rift_time_integration_critical_time_step_h
#define rift_time_integration_critical_time_step_h

#include <rift/base/communicator.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/material/elasticity.h>

#include <functional>
#include <string>
#include <vector>

namespace rift
{
  /** What the bound of the time step depends on in each material. */
  struct MaterialLimits
  {
    /** The material, its stiffness, Pa, its density, kg/m^3, and its viscosity,
     * Pa s. */
    std::string     name;
    StiffnessMatrix stiffness;
    double          density;
    double          viscosity = 0;

    /** CohesiveParameters::stiffness_factor where faces may break, else 0. */
    double cohesive_stiffness_factor = 0;
  };

  /** What cohesive elements of given stiffness add at most to the square of a
   * frequency of a loose cell, 1/s^2; empty where there are none. */
  using CohesiveFrequency = std::function<double(CellIndex)>;

  /** The largest safe time step and what limits it. */
  struct CriticalTimeStep
  {
    /** The step, s. */
    double time_step;

    /**
     * Square of the largest frequency of any loose cell with its cohesive
     * faces, 1/s^2: up to this the elastic branches may be stiff.
     */
    double frequency_squared;

    /** The same bound of a cell alone, the mean of all, s; and the cell that has
     * the smallest one. */
    double          mean_time_step;
    GlobalCellIndex smallest_cell;

    /** For the log: "cell 17 of granite, with room for cracks or contact". */
    std::string limited_by;
  };

  /**
   * A time step at which central differences are stable whatever breaks: no
   * frequency of the assembled body exceeds the largest of its loose cells,
   * each with the cohesive faces that may come to it (doc/theory.md, eq. 21).
   * Viscosity shortens the step further. Collective.
   */
  CriticalTimeStep
  critical_time_step(const Topology                    &topology,
                     const ReferenceCellData           &reference,
                     const std::vector<MaterialLimits> &limits,
                     const Communicator                &communicator,
                     const CohesiveFrequency           &penalty = {});
} // namespace rift

#endif
