#ifndef rift_material_microcracks_h
#define rift_material_microcracks_h

#include <rift/base/vector3.h>

#include <optional>
#include <vector>

namespace rift
{
  /** Stiffness in Voigt's notation, Pa: stress row = matrix x (strain row with
   * shear strains doubled). */
  using StiffnessMatrix = std::array<std::array<double, 6>, 6>;

  /** u_i C_ijkl v_l, Pa. */
  Matrix3<double>
  acoustic_matrix(const StiffnessMatrix &stiffness,
                  const Vector3<double> &u,
                  const Vector3<double> &v);

  /** Open microcracks, each a flat circle (penny). */
  struct CrackGroup
  {
    /** All of them lie across this; empty: across any direction alike. */
    std::optional<Vector3<double>> normal;

    /** Number per volume times the mean cube of the radii. */
    double density;
  };

  /** How cracks feel that there are others (doc/theory.md, section 10). */
  enum class CrackScheme
  {
    /** They are added little by little, all groups together. */
    differential,

    /** They are added little by little, one group after the other. */
    differential_in_order,

    /** Not at all: each is in the intact material. */
    dilute,

    /** Each is in the cracked material. */
    self_consistent
  };

  /**
   * Resistance of a crack to its opening and sliding, Pa: the second tensor of
   * Hill for a circle of the given normal (doc/theory.md, eq. 29). A mean
   * traction t on a crack of radius a opens it by the volume
   * (4 pi a^3/3) Q^-1 t.
   */
  Matrix3<double>
  crack_resistance(const StiffnessMatrix &stiffness,
                   const Vector3<double> &normal);

  /**
   * Stiffness of a material with microcracks, Pa.
   *
   * @param intact stiffness; normals of the groups are in its axes.
   * @return empty if so many cracks leave no stiffness.
   */
  std::optional<StiffnessMatrix>
  stiffness_with_cracks(const StiffnessMatrix         &intact,
                        const std::vector<CrackGroup> &groups,
                        CrackScheme                    scheme);
} // namespace rift

#endif
