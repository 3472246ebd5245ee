#ifndef rift_contact_vertex_groups_h
#define rift_contact_vertex_groups_h

#include <rift/base/archive.h>
#include <rift/discretization/state.h>

#include <vector>

namespace rift
{
  /**
   * Which cells around a vertex still hang together there. The cells around a
   * vertex form one group at first. Nodes of a group whose displacements differ
   * by at most a distance hang together, directly or by others; a group that no
   * longer does so falls apart, for good. Cells with a common group are none of
   * contact's business: what acts between them are the cohesive elements around
   * (doc/theory.md, section 8).
   *
   * All of it follows from the nodes at complete vertices, so that all ranks
   * that see such a vertex have the same groups.
   */
  class VertexGroups
  {
  public:
    /** @param distance over the least height of the undeformed cells around a
     *   vertex. The topology must outlive this object. */
    VertexGroups(const Topology &topology, double distance);

    /** Has the vertices of a face be looked at: it opens or has been cut. */
    void
    watch(const State &state, FaceIndex face);

    /**
     * Lets groups fall apart.
     *
     * @param path sum over the steps of how far any node may have moved, m: so
     *   that vertices that cannot have changed are passed over.
     * @return the vertices at which a group has fallen apart.
     */
    std::vector<VertexIndex>
    divide(const State &state, double path);

    /** Name of the group of a cell at a corner, the same on all ranks: its
     * first cell and the corner there. */
    std::uint64_t
    name(CellIndex cell, unsigned int corner) const;

    /** The vertices that have more than one group. */
    std::vector<VertexIndex>
    divided_vertices() const;

    /** Writes the groups of the vertices whose first cell this rank owns. */
    void
    save(Archive &archive) const;

    /** Reads the groups of all vertices that are complete here. */
    void
    load(const Archive &archive);

  private:
    /** A node at a vertex and its group. */
    struct GroupedNode
    {
      NodeIndex     node;
      std::uint32_t group;
    };

    /** A vertex that is looked at. */
    struct Watched
    {
      VertexIndex vertex;

      /** How far nodes come apart before a group divides, m. */
      double limit;

      /** The path at which this can happen at the earliest, m. */
      double wake;

      /** The nodes there; empty if they or their groups may have changed. */
      std::vector<GroupedNode> nodes;
    };

    /** A node at a vertex, and how far it is from those of its group that have
     * been reached so far, m. */
    struct Member : GroupedNode
    {
      Vector3<double> displacement;
      double          nearest;
    };

    /** The nodes at a vertex in the order of its cells. */
    std::vector<GroupedNode>
    nodes_at(VertexIndex vertex) const;

    /** Gives the nodes of a group that do not hang together numbers of their
     * own.
     *
     * @return how much longer the longest distance may become that holds two
     *   parts of a group together, m. */
    static double
    divide_group(std::vector<Member>::iterator first,
                 std::vector<Member>::iterator last,
                 double                        limit,
                 std::uint32_t                &n_groups);

    bool
    divide_at(const State &state, double path, Watched &watched);

    /** The groups at a vertex by cell around it; makes room for them. */
    std::uint32_t *
    groups_at(VertexIndex vertex);

    const Topology &topology;
    const double    distance;

    /** Those at the vertex that is being looked at. */
    std::vector<Member> members;

    std::vector<Watched>       watched;
    std::vector<std::uint32_t> watched_at;

    /** Where the groups of a vertex begin; invalid_index where all is one. */
    std::vector<std::uint32_t> begin_at;
    std::vector<std::uint32_t> groups;
  };
} // namespace rift

#endif
