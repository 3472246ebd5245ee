#include <rift/solid/cell_frequency.h>
#include <rift/time_integration/critical_time_step.h>

#include <cmath>
#include <limits>

namespace rift
{
  namespace
  {
    /** Viscous counterpart of a stiffness: the stress eta d in Voigt's
     * notation, where shear rates are doubled. */
    StiffnessMatrix
    viscosity_matrix(const double viscosity)
    {
      StiffnessMatrix result{};
      for (unsigned int i = 0; i < 6; ++i)
        result[i][i] = i < 3 ? viscosity : .5 * viscosity;
      return result;
    }

    double
    bound_of_cell(const ReferenceBatch &reference,
                  const unsigned int    lane,
                  const MaterialLimits &limits)
    {
      // Three cohesive faces meet at each corner of a loose cell.
      const double omega =
        std::sqrt(largest_frequency_squared(reference,
                                            lane,
                                            limits.stiffness,
                                            limits.density) *
                  (1 + 3 * limits.cohesive_stiffness_factor));
      if (limits.viscosity == 0)
        return 2 / omega;
      const double rate =
        largest_frequency_squared(reference,
                                  lane,
                                  viscosity_matrix(limits.viscosity),
                                  limits.density);
      const double damping_ratio = rate / (2 * omega);
      return 2 / omega *
             (std::sqrt(1 + damping_ratio * damping_ratio) - damping_ratio);
    }
  } // namespace

  CriticalTimeStep
  critical_time_step(const Topology                    &topology,
                     const ReferenceCellData           &reference,
                     const std::vector<MaterialLimits> &limits)
  {
    CriticalTimeStep result{std::numeric_limits<double>::max(),
                            invalid_index,
                            ""};
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (!topology.is_padding(cell))
        {
          const double bound = bound_of_cell(reference[cell / batch_size],
                                             cell % batch_size,
                                             limits[topology.material(cell)]);
          if (bound < result.time_step)
            {
              result.time_step = bound;
              result.cell      = cell;
            }
        }
    const MaterialLimits &of = limits[topology.material(result.cell)];
    result.limited_by =
      "cell " + std::to_string(topology.cell_global_indices[result.cell]) +
      " of " + of.name +
      (of.cohesive_stiffness_factor > 0 ? ", cohesive stiffness included" :
                                          "") +
      (of.viscosity > 0 ? ", viscosity included" : "");
    return result;
  }
} // namespace rift
