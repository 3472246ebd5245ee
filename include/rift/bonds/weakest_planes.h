#ifndef rift_bonds_weakest_planes_h
#define rift_bonds_weakest_planes_h

#include <rift/material/elasticity.h>
#include <rift/material/face_strength.h>

#include <functional>
#include <vector>

namespace rift
{
  /** The strength of the plane of a normal, in the undeformed body. */
  using StrengthAcross =
    std::function<FaceStrength(const Vector3<double> &normal)>;

  /** Normal traction, tension positive, and magnitude of the shear traction of
   * a plane, Pa. */
  struct PlaneTraction
  {
    /** Pa. */
    double normal, shear;
  };

  /** The traction that a stress exerts on the plane of a unit normal, Pa. */
  PlaneTraction
  traction_on(const SymmetricTensor<double> &stress,
              const Vector3<double>         &normal);

  /**
   * Demand of a plane: the largest of its tension and of its Mohr-Coulomb shear
   * over the strengths (doc/theory.md, eq. 36). A plane breaks at 1. The line of
   * friction goes on in tension, so that the stresses of a demand below 1 are
   * a convex set.
   */
  double
  demand_on(const PlaneTraction &traction, const FaceStrength &strength);

  /** The planes that break first under a stress. */
  struct WeakestPlanes
  {
    /** Largest demand of all planes. */
    double demand;

    /** Whether it is the shear that breaks them. */
    bool by_shear;

    /** Their unit normals: one in tension, two conjugate ones in shear, both of
     * the same demand where strengths do not depend on the direction. */
    std::vector<Vector3<double>> normals;
  };

  /** The largest demand of all planes, which have the same strength: from the
   * principal stresses (doc/theory.md, eq. 36). */
  double
  largest_demand(const SymmetricTensor<double> &stress,
                 const FaceStrength            &strength);

  /**
   * The weakest planes where all planes have the same strength: in closed form
   * from the principal stresses (doc/theory.md, eq. 36).
   */
  WeakestPlanes
  weakest_planes(const SymmetricTensor<double> &stress,
                 const FaceStrength            &strength);

  /** The weakest planes where the strength depends on the normal: those of some
   * hundred directions show where to search in small steps. */
  class DirectionalPlanes
  {
  public:
    /** Computes the strength of these directions. */
    explicit DirectionalPlanes(StrengthAcross strength_across);

    /** An upper bound of the demand of all planes, from that of these directions:
     * between them the stresses of planes change by less than 3 % of the largest
     * difference of the principal stresses. */
    double
    bound_of_demand(const SymmetricTensor<double> &stress) const;

    /** The plane of the largest demand of all. */
    WeakestPlanes
    weakest(const SymmetricTensor<double> &stress) const;

  private:
    /** The demand of each direction, if the normal and the shear traction are
     * larger by a margin, Pa. */
    void
    find_demands(const SymmetricTensor<double> &stress,
                 double                         margin,
                 std::vector<double>           &demands) const;

    const StrengthAcross               strength_across;
    const std::vector<Vector3<double>> directions;

    /** By component of the normal and direction; by direction: one over the
     * tensile strength and over the cohesion, Pa, and the friction. */
    std::vector<double> normals[3], inverse_tension, inverse_cohesion, friction;
  };
} // namespace rift

#endif
