#ifndef rift_discretization_discretization_h
#define rift_discretization_discretization_h

#include <rift/base/archive.h>
#include <rift/base/communicator.h>
#include <rift/discretization/activity.h>
#include <rift/discretization/ghost_exchange.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>
#include <rift/mesh/topology.h>

namespace rift
{
  /**
   * The body as the solver works on it, made once from the triangulation, and
   * the only place where its nodes split: in a step and after a restart alike.
   */
  struct Discretization
  {
    /** The ranks among which the body is divided. */
    Communicator communicator;

    /** The cells, what does not change of them, the motion of their nodes, what
     * ranks tell each other of it, and which cells are at rest. */
    Topology          topology;
    ReferenceCellData reference;
    State             state;
    GhostExchange     exchange;
    Activity          activity;

    /** kg/m^3 of each material. */
    std::vector<double> densities;

    /** For each cell slot the piece of the undamaged body that it belongs to;
     * see label_bodies(). */
    std::vector<GlobalCellIndex> bodies = {};

    /**
     * Cuts faces and splits the nodes that this parts; the new nodes have the
     * motion of the old ones and masses of their own, and are awake.
     *
     * @param faces see split_nodes().
     */
    TopologyChange
    cut(const std::vector<FaceIndex> &faces);

    /**
     * After the drift: has the nodes of ghost cells follow those of their
     * owners, and tells other ranks what has been cut here. Collective.
     *
     * @param splits of cut() in this step.
     * @param openings of this step; those of other ranks are added.
     * @param news of this step; replaced by those of other ranks.
     * @return vertices at which other ranks have split nodes.
     */
    std::vector<VertexIndex>
    follow_owners(const std::vector<NodeSplit> &splits,
                  std::vector<OpeningCorner>   &openings,
                  std::vector<CornerNews>      &news);

    /** Writes the motion of the nodes and the states of the faces. */
    void
    save(Archive &archive) const;

    /**
     * Cuts the intact body as it was and moves its nodes to where they were.
     * Collective.
     *
     * @return the vertices whose nodes have split.
     */
    std::vector<VertexIndex>
    load(const Archive &archive);
  };

  /** Number of pieces of the undamaged body. Collective. */
  std::int64_t
  count_bodies(const Discretization &body);

  /** Where nodes have split. */
  std::vector<VertexIndex>
  vertices_of(const Topology &topology, const std::vector<NodeSplit> &splits);
} // namespace rift

#endif
