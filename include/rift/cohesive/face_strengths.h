#ifndef rift_cohesive_face_strengths_h
#define rift_cohesive_face_strengths_h

#include <rift/base/communicator.h>
#include <rift/cohesive/cohesive_parameters.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/material/face_strength.h>
#include <rift/material/material_parameters.h>
#include <rift/material/stress_bound.h>
#include <rift/mesh/topology.h>

#include <vector>

namespace rift
{
  /** Strength of the planes inside a material, without scatter. */
  class PlaneStrength
  {
  public:
    /** Takes the strengths and the axes of the material. */
    explicit PlaneStrength(const MaterialParameters &material);

    /** @param normal of unit length, in the frame of the mesh. */
    FaceStrength
    across(const Vector3<double> &normal) const;

  private:
    Matrix3<double>  axes;
    DirectionalValue tensile_strength, cohesion, fracture_energy_1,
      fracture_energy_2;
    double tan_friction_angle, residual_friction;
  };

  /** The same of one plane. */
  inline FaceStrength
  strength_across(const MaterialParameters &material,
                  const Vector3<double>    &normal)
  {
    return PlaneStrength(material).across(normal);
  }

  /**
   * The strength of every interior face, by its normal in the undeformed body.
   * Between two materials the weaker value of each property counts; where one
   * of them is not breakable, the face never breaks.
   *
   * With a Weibull modulus m both strengths of a face are scaled by a random
   * factor of mean 1, w = (-ln U)^(1/m) / Gamma(1 + 1/m). U depends only on
   * the seed and on the face's place in the canonical order of the mesh, not
   * on the number of ranks.
   */
  class FaceStrengths
  {
  public:
    /** The topology and the reference data must outlive this object.
     * @param materials by material index. */
    FaceStrengths(const Topology                        &topology,
                  const ReferenceCellData               &reference,
                  const std::vector<MaterialParameters> &materials,
                  const CohesiveParameters              &parameters);

    /** Whether a cohesive element may be inserted at an interior face. */
    bool
    is_breakable(FaceIndex face) const;

    /** The strength of an interior face, with scatter and direction. */
    FaceStrength
    strength(FaceIndex face) const;

    /**
     * For each cell the stress below which none of its faces can break, with
     * some margin; the same on all ranks that see the cell. Collective.
     */
    StressBounds
    stress_bounds(const Communicator &communicator) const;

  private:
    /** Without scatter. */
    FaceStrength
    weaker_side(FaceIndex face) const;

    void
    scatter(unsigned int seed);

    /** The smallest factor of the breakable faces of each cell, by batches;
     * empty without scatter. Collective. */
    std::vector<Simd>
    cell_factors(const Communicator &communicator) const;

    double
    random_factor(FaceIndex face, double weibull_modulus, unsigned int seed);

    const Topology                       &topology;
    const ReferenceCellData              &reference;
    const std::vector<MaterialParameters> materials;

    /** For each pair of materials, across any normal: what counts where
     * strengths do not depend on the direction. */
    std::vector<FaceStrength> pairs;

    /** For each face; empty where nothing scatters. */
    std::vector<double> factors;
  };
} // namespace rift

#endif
