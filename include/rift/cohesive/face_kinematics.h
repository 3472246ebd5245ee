#ifndef rift_cohesive_face_kinematics_h
#define rift_cohesive_face_kinematics_h

#include <rift/cohesive/cohesive_faces.h>
#include <rift/discretization/ghost_exchange.h>

namespace rift
{
  /** Where the eight faces of a batch are now. */
  struct FaceKinematics
  {
    /** Reads the displacements of the nodes of a batch. */
    FaceKinematics(const CohesiveBatch &batch, const State &state);

    /** Jump at a Gauss point in the frame of the face, m. */
    Vector3<Simd>
    jump_at(const FaceQuadrature &quadrature, unsigned int point) const;

    /**
     * Frame of the mid-plane: rows are the normal, from minus to plus, and two
     * tangents, the first along the edge from corner 0 to 1. It turns with the
     * face.
     */
    Matrix3<Simd> frame;

    /** Jump at each corner in that frame, m. */
    std::array<Vector3<Simd>, 3> jumps;

    /**
     * The two edges from corner 0 in the frame, m: (length_1, 0) and
     * (along_2, across_2).
     */
    Simd length_1, along_2, across_2;
  };

  /** Tractions at the Gauss points of eight faces in their frame, Pa. */
  using FaceTractions = std::array<Vector3<Simd>, n_face_points>;

  /** Forces on the corners of the two sides of eight faces, N. */
  struct FaceForces
  {
    /** Force on each corner, in the frame of the mesh. */
    std::array<Vector3<Simd>, 3> minus, plus;
  };

  /**
   * Nodal forces of the tractions at the Gauss points (doc/theory.md, eqs. 16
   * and 17). Besides the tractions themselves they hold the couple by which
   * these turn the frame when the face is open: the work of the forces is then
   * that of the tractions on the jumps in the frame, and no momentum, linear
   * or angular, comes from the face.
   */
  FaceForces
  face_forces(const Simd           &area,
              const FaceTractions  &tractions,
              const FaceKinematics &kinematics,
              const FaceQuadrature &quadrature);

  /** Adds the forces of a batch to those of its nodes. */
  void
  scatter(const CohesiveBatch &batch, const FaceForces &forces, State &state);

  /** Forces on the corners of one face in its frame, N. */
  using CornerForces = std::array<Vector3<double>, 3>;

  /**
   * The forces with which corners of a face begin to open, in its frame.
   * Corners that are still bonded are given the mean of the others: their own
   * share will be a correction of that.
   *
   * @param lane of the face in its batch.
   */
  CornerForces
  corner_forces_in_frame(const CohesiveBatch  &batch,
                         const FaceKinematics &kinematics,
                         unsigned int          lane,
                         const OpeningCorner  *first,
                         const OpeningCorner  *last);

  /**
   * The traction that makes these forces, at a point with these shape functions
   * (doc/theory.md, eq. 19), Pa.
   */
  Vector3<double>
  traction_of(const CornerForces          &forces,
              double                       area,
              const std::array<double, 3> &shape);
} // namespace rift

#endif
