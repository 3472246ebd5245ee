#ifndef rift_mesh_node_splitter_h
#define rift_mesh_node_splitter_h

#include <rift/mesh/topology.h>

#include <vector>

namespace rift
{
  /** A node that a crack has parted. */
  struct NodeSplit
  {
    /**
     * The nodes that are now where there was one. The first is the old one;
     * the others are new. Each belongs to one connected piece of the cells
     * around; pieces are ordered by their smallest cell.
     */
    std::vector<NodeIndex> parts;
  };

  /** What split_nodes() has done, for those that hold data of nodes. */
  struct TopologyChange
  {
    /** The nodes that have split. */
    std::vector<NodeSplit> splits;

    /** Interior faces whose state went from intact to cohesive, ascending. */
    std::vector<FaceIndex> cut_faces;
  };

  /**
   * Cuts faces and splits the nodes that this parts.
   *
   * The rule is local to a node: the cells that use it fall into connected
   * components, two cells being connected where they share an intact face that
   * has the node; each component gets a node of its own. It covers all cases
   * of Fig. 3 of Fukuda et al. (2021) without telling them apart; a face cut
   * inside of the body parts nothing before its neighbours are cut.
   *
   * The result does not depend on the order in which faces are cut, but for
   * the numbers of the new nodes. Nodes at incomplete vertices are left alone.
   *
   * @param cut_faces interior faces that are intact, ascending, no duplicates.
   */
  TopologyChange
  split_nodes(Topology &topology, const std::vector<FaceIndex> &cut_faces);

  /**
   * Gives a node of its own to each piece of cells at vertices where pieces
   * touch by an edge or by the vertex alone, before anything is cut: where no
   * face connects them there is nothing that could be cut, either. Nodes at
   * incomplete vertices are left alone.
   *
   * @return number of nodes that this has made.
   */
  std::size_t
  separate_touching_pieces(Topology &topology);

  /**
   * Marks all faces between cells of parted materials as cut and separates
   * their nodes: for an intact body, before anything knows its nodes.
   *
   * @param parted for each material.
   */
  void
  separate_materials(Topology &topology, const std::vector<bool> &parted);
} // namespace rift

#endif
