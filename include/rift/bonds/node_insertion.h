#ifndef rift_bonds_node_insertion_h
#define rift_bonds_node_insertion_h

#include <rift/bonds/crack_planes.h>
#include <rift/bonds/node_star.h>
#include <rift/bonds/node_strengths.h>
#include <rift/discretization/corner_news.h>
#include <rift/solid/cell_stresses.h>

#include <optional>
#include <unordered_map>
#include <vector>

namespace rift
{
  /** A node whose stress has reached the strength of a plane. */
  struct CrackCandidate
  {
    /** The node, and the largest demand of all planes. */
    NodeIndex node;
    double    demand;

    /** Mean second Piola-Kirchhoff stress of its cells, Pa. */
    SymmetricTensor<double> stress;
  };

  /**
   * Decides which nodes part, and along which planes (doc/theory.md, eq. 35 to
   * 39). A node whose stress reaches the strength in step n is a candidate;
   * the demands of its neighbours are known to all ranks in step n + 1, in which
   * those are chosen that part; their faces are cut at the start of step n + 2,
   * when all ranks know of them.
   *
   * Every rank at which a vertex is complete decides the same there, and tells
   * those at which it is not.
   */
  class NodeInsertion
  {
  public:
    /** All must outlive this object. */
    NodeInsertion(const Topology          &topology,
                  const ReferenceCellData &reference,
                  const InternalForce     &internal_force,
                  const NodeStrengths     &strengths,
                  CrackPlanes             &planes);

    /** Faces to be cut now, ascending; their planes are known from here on. */
    std::vector<FaceIndex>
    take_due_faces();

    /**
     * Chooses among the candidates of the step before those that part, and
     * finds the candidates of this one.
     *
     * @param hot_cells those of the forces of this step, ascending.
     * @param[out] news for other ranks.
     */
    void
    look(const State                  &state,
         const std::vector<CellIndex> &hot_cells,
         std::vector<CornerNews>      &news);

    /** Writes what it needs to go on. */
    void
    save(const State &state, Archive &archive) const;

    /** Goes on from there; the planes have been loaded. */
    void
    load(const Archive &archive);

    /** Takes in what other ranks have told. */
    void
    take_in(const std::vector<CornerNews> &news);

  private:
    /** A face to be cut, with the normal of its crack plane. */
    struct DueFace
    {
      FaceIndex       face;
      Vector3<double> plane;
    };

    /** Mean stress of the cells of a node, weighted by their volumes (35). */
    SymmetricTensor<double>
    mean_stress(const State &state, const std::vector<StarCell> &cells);

    /** Has other nodes know the demand of one. */
    void
    set_demand(NodeIndex node, double demand);

    /** Finds the candidates among the nodes of hot cells at complete
     * vertices. */
    void
    find_candidates(const State                  &state,
                    const std::vector<CellIndex> &hot_cells);

    /** Whether no node of the cells around has a larger demand; of equal ones
     * the place in the undeformed body decides. */
    bool
    is_largest(const State                 &state,
               const CrackCandidate        &candidate,
               const std::vector<StarCell> &cells) const;

    /** Whether a cut face ends at a node. */
    bool
    is_on_front(NodeIndex node, const std::vector<StarCell> &cells) const;

    /** Whether there is a cut face at one of the cells. */
    bool
    is_beside_crack(const std::vector<StarCell> &cells) const;

    /** The planes that a node may be cut along (37). */
    std::vector<Vector3<double>>
    possible_planes(const CrackCandidate        &candidate,
                    const std::vector<StarCell> &cells) const;

    /** The mean plane of the cracks around, if they are nearly parallel to one
     * of two conjugate planes (37a). */
    std::optional<Vector3<double>>
    plane_of_cracks_around(const CrackCandidate               &candidate,
                           const std::vector<StarCell>        &cells,
                           const std::vector<Vector3<double>> &conjugate) const;

    /** Has a candidate part, if its star can be cut. */
    void
    cut(const State                 &state,
        const CrackCandidate        &candidate,
        const std::vector<StarCell> &cells,
        std::vector<CornerNews>     &news);

    /** Has a plane take part in (37a) from the next step on. */
    void
    add_plane(VertexIndex vertex, const CrackPlanes::Part &part);

    /** Tells others of a face that is to be cut. */
    void
    tell(FaceIndex                face,
         VertexIndex              vertex,
         const Vector3<double>   &plane,
         std::vector<CornerNews> &news) const;

    const Topology          &topology;
    const ReferenceCellData &reference;
    const NodeStrengths     &strengths;
    CrackPlanes             &planes;
    CellStresses             stresses;

    /** Candidates of the last look. */
    std::vector<CrackCandidate> candidates;

    /** By node its demand at the last look, of the candidates of other ranks,
     * too; and these nodes. */
    std::vector<double>    demands;
    std::vector<NodeIndex> with_demand;

    /** What is cut at the start of the next step. */
    std::vector<DueFace> due;

    /** Planes that take part in (37a) from the next step on. */
    std::unordered_map<VertexIndex, std::vector<CrackPlanes::Part>> due_planes;

    /** By node: step from which it is looked at again after it could not be
     * cut, and the step in which it has been looked at last. */
    std::vector<std::uint64_t> next_look, last_look;

    /** Kept to save allocations. */
    std::vector<StarCell> star;
  };
} // namespace rift

#endif
