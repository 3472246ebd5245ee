#include <rift/base/check.h>
#include <rift/base/exact_sum.h>
#include <rift/solid/cell_frequency.h>
#include <rift/time_integration/critical_time_step.h>

#include <algorithm>
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

    /** A cell and its frequency, 1/s, or the square of it. */
    struct FastCell
    {
      double          frequency;
      GlobalCellIndex cell;
      std::uint16_t   material;
    };

    /**
     * The fastest cell of all ranks; the first of several.
     *
     * @param frequency(a cell, its batch, its lane, the limits of its material)
     */
    template <typename Function>
    FastCell
    find_fastest_cell(const Topology                    &topology,
                      const ReferenceCellData           &reference,
                      const std::vector<MaterialLimits> &limits,
                      const Communicator                &communicator,
                      const Function                    &frequency)
    {
      const auto is_faster = [](const FastCell &a, const FastCell &b) {
        return a.frequency > b.frequency ||
               (a.frequency == b.frequency && a.cell < b.cell);
      };
      FastCell fastest{0, invalid_index, 0};
      for (CellIndex i = 0; i < topology.n_cell_slots(); ++i)
        if (topology.owns_cell(i))
          {
            const std::uint16_t material = topology.material(i);
            const FastCell      cell     = {frequency(i,
                                             reference[i / batch_size],
                                             i % batch_size,
                                             limits[material]),
                                            topology.cell_global_indices[i],
                                            material};
            if (is_faster(cell, fastest))
              fastest = cell;
          }
      fastest = communicator.first_of_ranks(fastest, is_faster);
      rift_check(fastest.cell != invalid_index);
      return fastest;
    }

    /** The mean over cells of the bound of the time step. */
    class MeanBound
    {
    public:
      /** @param frequency_squared of a cell, 1/s^2; zero where it is rigid. */
      void
      add(const double frequency_squared)
      {
        if (frequency_squared > 0)
          {
            sum.add(2 / std::sqrt(frequency_squared));
            ++n_cells;
          }
      }

      /** Of all ranks, s. Collective. */
      double
      value(const Communicator &communicator)
      {
        ExactSum::sum_over_ranks({&sum}, communicator);
        return sum.value() /
               std::max<std::int64_t>(communicator.sum(n_cells), 1);
      }

    private:
      ExactSum     sum;
      std::int64_t n_cells = 0;
    };
  } // namespace

  CriticalTimeStep
  critical_time_step(const Topology                    &topology,
                     const ReferenceCellData           &reference,
                     const std::vector<MaterialLimits> &limits,
                     const Communicator                &communicator,
                     const CohesiveFrequency           &penalty)
  {
    const auto find_fastest = [&](const auto &frequency) {
      return find_fastest_cell(topology,
                               reference,
                               limits,
                               communicator,
                               frequency);
    };
    MeanBound      mean;
    const FastCell elastic = find_fastest([&](const CellIndex       cell,
                                              const ReferenceBatch &batch,
                                              const unsigned int    lane,
                                              const MaterialLimits &of) {
      // Three cohesive faces meet at each corner of a loose cell.
      const double square =
        largest_frequency_squared(batch, lane, of.stiffness, of.density) *
          (1 + 3 * of.cohesive_stiffness_factor) +
        (penalty ? penalty(cell) : 0.);
      mean.add(square);
      return square;
    });
    // Elastic branches may bring any breakable cell up to this frequency,
    // whatever its own is, so that viscosity must be stable together with it.
    const double   omega   = std::sqrt(elastic.frequency);
    const FastCell viscous = find_fastest([omega](CellIndex,
                                                  const ReferenceBatch &batch,
                                                  const unsigned int    lane,
                                                  const MaterialLimits &of) {
      if (of.viscosity == 0)
        return 0.;
      const double rate =
        largest_frequency_squared(batch,
                                  lane,
                                  viscosity_matrix(of.viscosity),
                                  of.density);
      const double ratio = rate / (2 * omega);
      return omega * (std::sqrt(1 + ratio * ratio) + ratio);
    });

    const FastCell &fastest  = viscous.frequency > omega ? viscous : elastic;
    const MaterialLimits &of = limits[fastest.material];
    return {2 / std::max(omega, viscous.frequency),
            elastic.frequency,
            mean.value(communicator),
            elastic.cell,
            "cell " + std::to_string(fastest.cell) + " of " + of.name +
              (of.cohesive_stiffness_factor > 0 ?
                 ", with room for cracks or contact" :
                 "") +
              (penalty ? ", cohesive penalty included" : "") +
              (of.viscosity > 0 ? ", viscosity included" : "")};
  }
} // namespace rift
