#ifndef rift_cohesive_insertion_h
#define rift_cohesive_insertion_h

#include <rift/cohesive/face_strengths.h>
#include <rift/discretization/state.h>
#include <rift/solid/cell_stresses.h>

#include <vector>

namespace rift
{
  /**
   * Decides which faces break: an intact face gets a cohesive element when its
   * normal stress or its shear stress reaches the strength,
   *   sigma_n >= T  or  |tau| >= C - min(sigma_n, 0) tan(phi)
   * (doc/theory.md, eq. 11). The traction is the mean of the two cells'
   * nominal tractions P N, resolved along the current normal.
   *
   * The decision for a face depends on its two cells alone, so that all ranks
   * that see the face decide the same.
   */
  class Insertion
  {
  public:
    /**
     * All arguments must outlive this object.
     *
     * @param bounds those that `internal_force` watches.
     */
    Insertion(const Topology          &topology,
              const ReferenceCellData &reference,
              const InternalForce     &internal_force,
              const FaceStrengths     &strengths,
              const StressBounds      &bounds);

    /**
     * Faces of the hot cells at their strength, ascending.
     *
     * @param hot_cells see InternalForce::hot_cells(), ascending.
     */
    std::vector<FaceIndex>
    find_faces(const State &state, const std::vector<CellIndex> &hot_cells);

  private:
    /**
     * Faces of a batch on which the stress of the cell itself comes near the
     * smallest strength of its faces, one bit for each lane: at a face that
     * is at its strength that is so on one of its sides at least.
     */
    std::array<std::uint8_t, n_corners>
    near_strength(std::uint32_t                     batch,
                  const InternalForce::BatchStress &stress) const;

    /** Nominal stress of a cell. */
    Matrix3<double>
    stress(const State &state, CellIndex cell);

    bool
    breaks(const State &state, FaceIndex face);

    const Topology          &topology;
    const ReferenceCellData &reference;
    const FaceStrengths     &strengths;
    const StressBounds      &bounds;

    CellStresses stresses;
  };
} // namespace rift

#endif
