#ifndef rift_cohesive_penalty_stiffness_h
#define rift_cohesive_penalty_stiffness_h

#include <rift/cohesive/cohesive_parameters.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>
#include <rift/material/elasticity.h>
#include <rift/material/material_parameters.h>

#include <functional>
#include <vector>

namespace rift
{
  /** Slope of the elastic branch of an interior face, Pa/m. */
  using PenaltyStiffness = std::function<double(FaceIndex)>;

  /**
   * The slopes of the extrinsic model: as stiff as the time step allows
   * (doc/theory.md, section 6).
   *
   * @param frequency_limit square of the frequency up to which the elastic
   *   branches may take a loose cell, 1/s^2.
   */
  PenaltyStiffness
  stable_penalty_stiffness(const Topology              &topology,
                           const ReferenceCellData     &reference,
                           std::vector<StiffnessMatrix> stiffnesses,
                           std::vector<double>          densities,
                           double                       frequency_limit);

  /**
   * The slopes of the intrinsic model: the penalty over the shortest edge of
   * the face (doc/theory.md, eq. 14b). Where the penalty is a multiple of
   * Young's modulus, the softer side counts.
   */
  class IntrinsicPenalty
  {
  public:
    /** @param stiffnesses of each material. */
    IntrinsicPenalty(const Topology                        &topology,
                     const ReferenceCellData               &reference,
                     const State                           &state,
                     const Penalty                         &penalty,
                     const std::vector<MaterialParameters> &materials,
                     const std::vector<StiffnessMatrix>    &stiffnesses);

    /** Zero beside a material that does not break. */
    double
    operator()(FaceIndex face) const;

    /**
     * At most what the faces add to the square of a frequency of a loose cell,
     * 1/s^2 (doc/theory.md, eq. 21b).
     */
    double
    frequency_squared(CellIndex cell) const;

  private:
    struct Side
    {
      double penalty, density;
    };

    const Topology          &topology;
    const ReferenceCellData &reference;
    const State             &state;

    /** Of each material, Pa and kg/m^3. */
    std::vector<Side> sides;
  };
} // namespace rift

#endif
