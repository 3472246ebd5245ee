#ifndef rift_cohesive_cohesive_faces_h
#define rift_cohesive_cohesive_faces_h

#include <rift/base/plain_bytes.h>
#include <rift/base/simd.h>
#include <rift/cohesive/laws/mohr_coulomb.h>
#include <rift/mesh/topology.h>

#include <array>
#include <vector>

namespace rift
{
  /** Number of Gauss points on a cohesive face. */
  constexpr unsigned int n_face_points = 7;

  /**
   * The rule of degree 5 on a triangle (Radon): shape functions of the three
   * corners at each point, and weights that sum to 1 (doc/theory.md, eq. 15).
   */
  struct FaceQuadrature
  {
    std::array<std::array<double, 3>, n_face_points> shape;
    std::array<double, n_face_points>                weight;

    FaceQuadrature();
  };

  /** What eight cohesive elements remember of what they have gone through. */
  struct CohesiveMemory
  {
    std::array<CohesivePoint<Simd>, n_face_points> points;

    /** Energies of a face that fracture and friction have used up, J. */
    Simd fracture, friction;

    /** Energy besides debts that a face was given when its nodes parted, J;
     * hold_traction(). */
    Simd given;

    /** Debts of a face that has been let go of, J. */
    Simd unpaid;
  };

  /**
   * Eight cohesive elements (CE6): the pairs of nodes of the two sides and the
   * triangle in the undeformed body.
   */
  struct CohesiveBatch
  {
    /** Node of each corner on the minus and the plus side. */
    NodeIndex minus[3][batch_size], plus[3][batch_size];

    /** Edges from corner 0 to 1 and 2, m, and area, m^2, when undeformed. */
    std::array<Vector3<Simd>, 2> edges;
    Simd                         area;

    CohesiveConstants<Simd> constants;

    /** Cohesion of the intact face, Pa. */
    Simd cohesion;

    unsigned int n_faces;

    /** Index in CohesiveFaces::memories; invalid_index as long as none of the
     * faces has anything to remember. */
    std::uint32_t memory;
  };

  /** The rest of what is known of a cohesive element, one by one. */
  struct CohesiveFaceInfo
  {
    FaceIndex face;

    /** Times at which the first nodes parted (0 in the intrinsic model) and at
     * which the face failed, s; the latter is negative before. */
    double start_time, failure_time;

    /** What of the strength of its plane it has; doc/theory.md, eq. 11c. */
    double share;
  };

  /**
   * The cohesive elements that have begun to open, in the order of that, and
   * by face index within a step: an order that is the same on any number of
   * ranks, and in which their forces are summed.
   */
  struct CohesiveFaces
  {
    std::vector<CohesiveBatch>    batches;
    std::vector<CohesiveMemory>   memories;
    std::vector<CohesiveFaceInfo> infos;

    std::size_t
    size() const
    {
      return infos.size();
    }

    /** What a face remembers; null if its batch has no memory. */
    const CohesiveMemory *
    memory_of(const std::size_t face) const
    {
      const std::uint32_t memory = batches[face / batch_size].memory;
      return memory == invalid_index ? nullptr : &memories[memory];
    }
  };

  /** All that a cohesive element remembers, for a checkpoint. */
  struct CohesiveFaceRecord
  {
    FaceName face;
    double   start_time, failure_time, share, area, fracture, friction;
    double   given, unpaid;

    std::array<CohesivePoint<double>, n_face_points> points;
  };

  template <>
  struct HasPlainBytes<CohesiveFaceRecord> : std::true_type
  {
    static_assert(sizeof(CohesiveFaceRecord) ==
                  sizeof(FaceName) + 8 * sizeof(double) +
                    n_face_points * sizeof(CohesivePoint<double>));
    static_assert(sizeof(CohesivePoint<double>) % sizeof(double) == 0);
  };

  /** Memory of one point of one face. */
  CohesivePoint<double>
  get_point(const CohesiveMemory &memory,
            unsigned int          point,
            unsigned int          lane);

  void
  set_point(CohesiveMemory              &memory,
            unsigned int                 point,
            unsigned int                 lane,
            const CohesivePoint<double> &value);
} // namespace rift

#endif
