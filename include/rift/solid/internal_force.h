#ifndef rift_solid_internal_force_h
#define rift_solid_internal_force_h

#include <rift/base/exact_sum.h>
#include <rift/discretization/activity.h>
#include <rift/discretization/field_list.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>
#include <rift/material/elasticity.h>
#include <rift/material/stress_bound.h>

#include <optional>
#include <vector>

namespace rift
{
  /** A cell that has left the range in which its law makes sense. */
  struct FailedCell
  {
    /** The cell, by its index on this rank. */
    CellIndex cell;
    /** Volume over reference volume. */
    double volume_ratio;
  };

  /**
   * The elastic forces of all cells, total Lagrangian.
   */
  class InternalForce
  {
  public:
    /**
     * Smallest ratio of current to reference volume that is accepted; St.
     * Venant-Kirchhoff softens in compression and means nothing beyond.
     */
    static constexpr double smallest_volume_ratio = .5;

    /** @param laws one for each material index. */
    InternalForce(const Topology          &topology,
                  const ReferenceCellData &reference,
                  std::vector<Elasticity>  laws);

    /**
     * Asks for the cells that come near their strength; see hot_cells().
     *
     * @param bounds must outlive this object.
     */
    void
    watch(const StressBounds &bounds);

    /**
     * Adds the forces of all cells that are awake to `state.force`.
     *
     * @return the first cell, if any, that is inverted, squeezed below
     *   smallest_volume_ratio, or not a number.
     */
    std::optional<FailedCell>
    add_to(State &state, Activity &activity);

    /**
     * Cells in which the last call of add_to() found a stress above the bound
     * that watch() gave for them, in ascending order.
     */
    const std::vector<CellIndex> &
    hot_cells() const
    {
      return hot;
    }

    /** Takes over the hot cells of a checkpoint, ascending. */
    void
    restore_hot_cells(std::vector<CellIndex> cells)
    {
      hot = std::move(cells);
    }

    /** Strain and stress of a batch of cells. */
    struct BatchStress
    {
      /** Displacement gradient and Green-Lagrange strain. */
      Matrix3<Simd>         gradient;
      SymmetricTensor<Simd> strain;

      /** Second and first Piola-Kirchhoff stress, Pa. */
      SymmetricTensor<Simd> second;
      Matrix3<Simd>         first;
    };

    /** Strain and stress of the eight cells of a batch at the time t_n. */
    BatchStress
    stress(const State &state, std::size_t batch) const;

    /** Cauchy stress of one cell, Pa. */
    SymmetricTensor<double>
    cauchy_stress(const State &state, CellIndex cell) const;

    /** Declares what is known of the stress in cells.
     * @param force null: the names alone. */
    static void
    declare_fields(FieldList &list, const InternalForce *force);

    /** Strain energy of the cells that this rank owns, J. */
    ExactSum
    strain_energy(const State &state) const;

  private:
    template <typename Law, bool is_watched>
    std::optional<FailedCell>
    add_range(const Law           &law,
              const MaterialRange &range,
              State               &state,
              Activity            &activity);

    const Topology          &topology;
    const ReferenceCellData &reference;
    std::vector<Elasticity>  laws;
    const StressBounds      *bounds = nullptr;
    std::vector<CellIndex>   hot;
  };
} // namespace rift

#endif
