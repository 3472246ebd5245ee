#ifndef rift_cohesive_cohesive_faces_h
#define rift_cohesive_cohesive_faces_h

#include <rift/base/check.h>
#include <rift/base/simd.h>
#include <rift/discretization/activity.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>
#include <rift/mesh/topology.h>

#include <array>
#include <vector>

namespace rift
{
  struct FaceKinematics;

  /** Number of Gauss points on a cohesive face. */
  constexpr unsigned int n_face_points = 7;

  /**
   * The rule of degree 5 on a triangle (Radon): shape functions of the three
   * corners at each point, and weights that sum to 1 (doc/theory.md, eq. 15).
   */
  struct FaceQuadrature
  {
    /** The rule, by point: shape functions by corner, and weights. */
    std::array<std::array<double, 3>, n_face_points> shape;
    std::array<double, n_face_points>                weight;

    FaceQuadrature();
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

    /** Lanes in use, from the first. */
    unsigned int n_faces;
  };

  /** The rest of what is known of a cohesive element, one by one. */
  struct CohesiveFaceInfo
  {
    /** The face, by its index in Topology::faces. */
    FaceIndex face;

    /** Times at which the first nodes parted (0 in the intrinsic model) and at
     * which the face failed, s; the latter is negative before. */
    double start_time, failure_time;
  };

  /**
   * The faces that have a cohesive element, whatever its law: their nodes,
   * triangles and states. They stand in the order in which they got it, and by
   * face index within a step: an order that is the same on any number of ranks,
   * and in which their forces are summed.
   *
   * The state of a face is that in Topology::face_states, where others look.
   */
  class CohesiveFaces
  {
  public:
    /** Both must outlive this object, which changes states of faces. */
    CohesiveFaces(Topology &topology, const ReferenceCellData &reference);

    /** Number of cohesive elements that this rank computes. */
    std::size_t
    size() const
    {
      return infos.size();
    }

    /** Whether a face has a cohesive element. */
    bool
    has(const FaceIndex face) const
    {
      return index_of_face[face] != invalid_index;
    }

    /** Where a face stands that has an element. */
    std::size_t
    index(const FaceIndex face) const
    {
      rift_check(has(face));
      return index_of_face[face];
    }

    /** Gives a face an element. */
    void
    add(FaceIndex face, const State &state);

    /** Takes in which nodes the faces around these vertices have now. */
    void
    update_nodes(const std::vector<VertexIndex> &vertices);

    /** The state of the face of an element. */
    FaceState
    state(const std::size_t index) const
    {
      return topology.face_states[infos[index].face];
    }

    /** Whether the face of an element has begun to open. */
    bool
    has_opened(const std::size_t index) const
    {
      return state(index) >= FaceState::opening;
    }

    /** Whether this rank counts the element in sums over all ranks. */
    bool
    is_owned(const std::size_t index) const
    {
      return topology.owns_face(infos[index].face);
    }

    /** Has a face pass on to a state, unless it is there or further already. */
    void
    set_state(std::size_t index, FaceState next, double time);

    /** Areas of the faces of a batch that act, m^2: zero where a face has been
     * let go of. */
    Simd
    acting_area(std::size_t batch) const;

    /**
     * Faces with damage whose sides have moved apart by `release_distance`
     * times the root of their area (or their least height, where that is less),
     * since an element between them says nothing of overlap once they have
     * turned against each other; and at the end of each contact interval failed
     * faces that are open at all corners, at one of them by `contact_opening`,
     * since contact then resists their overlap.
     */
    SimdMask
    lanes_to_release(std::size_t           batch,
                     const FaceKinematics &kinematics,
                     std::uint64_t         step) const;

    /** Whether all cells beside the faces of a batch are at rest. */
    bool
    is_at_rest(std::size_t batch, const Activity &activity) const;

    /** The elements by eight, and one by one, in the same order. */
    std::vector<CohesiveBatch>    batches;
    std::vector<CohesiveFaceInfo> infos;

    /** Steps between two looks of contact for cracks, zero without contact, and
     * the opening over the size of a face from which contact resists. */
    std::uint64_t contact_interval = 0;
    double        contact_opening  = 0;

  private:
    static constexpr double release_distance = .5;

    /** Reads the nodes of a face from the topology. */
    void
    update_face(FaceIndex face);

    Topology                &topology;
    const ReferenceCellData &reference;

    /** Index of each interior face, if it has an element. */
    std::vector<std::uint32_t> index_of_face;
  };
} // namespace rift

#endif
