#include <rift/solid/cell_frequency.h>
#include <rift/time_integration/critical_time_step.h>

#include <cmath>

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

    /** Calls f(cell, its batch, its lane, the limits of its material). */
    template <typename Function>
    void
    for_each_cell(const Topology                    &topology,
                  const ReferenceCellData           &reference,
                  const std::vector<MaterialLimits> &limits,
                  const Function                    &f)
    {
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        if (!topology.is_padding(cell))
          f(cell,
            reference[cell / batch_size],
            cell % batch_size,
            limits[topology.material(cell)]);
    }
  } // namespace

  CriticalTimeStep
  critical_time_step(const Topology                    &topology,
                     const ReferenceCellData           &reference,
                     const std::vector<MaterialLimits> &limits)
  {
    CriticalTimeStep result{0, invalid_index, 0, ""};
    for_each_cell(
      topology,
      reference,
      limits,
      [&result](const CellIndex       cell,
                const ReferenceBatch &batch,
                const unsigned int    lane,
                const MaterialLimits &of) {
        // Three cohesive faces meet at each corner of a loose
        // cell.
        const double frequency_squared =
          largest_frequency_squared(batch, lane, of.stiffness, of.density) *
          (1 + 3 * of.cohesive_stiffness_factor);
        if (frequency_squared > result.frequency_squared)
          {
            result.frequency_squared = frequency_squared;
            result.cell              = cell;
          }
      });
    // Elastic branches may bring any breakable cell up to this frequency,
    // whatever its own is, so that viscosity must be stable together with it.
    const double omega = std::sqrt(result.frequency_squared);
    result.time_step   = 2 / omega;
    for_each_cell(topology,
                  reference,
                  limits,
                  [&result, omega](const CellIndex       cell,
                                   const ReferenceBatch &batch,
                                   const unsigned int    lane,
                                   const MaterialLimits &of) {
                    if (of.viscosity == 0)
                      return;
                    const double rate =
                      largest_frequency_squared(batch,
                                                lane,
                                                viscosity_matrix(of.viscosity),
                                                of.density);
                    const double ratio = rate / (2 * omega);
                    const double bound =
                      2 / (omega * (std::sqrt(1 + ratio * ratio) + ratio));
                    if (bound < result.time_step)
                      {
                        result.time_step = bound;
                        result.cell      = cell;
                      }
                  });
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
