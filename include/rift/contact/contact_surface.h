#ifndef rift_contact_contact_surface_h
#define rift_contact_contact_surface_h

#include <rift/contact/contact_cell.h>
#include <rift/contact/known_face_states.h>
#include <rift/contact/vertex_groups.h>

#include <vector>

namespace rift
{
  /**
   * The cells of this rank that may touch others: those with a face on the
   * outer surface, those at vertices whose cells no longer hang together,
   * those beside faces that nothing else holds, and those behind others that lie
   * deep in something. It sees cracks by the states of faces, when it looks at
   * them.
   */
  class ContactSurface
  {
  public:
    /**
     * Takes in the cells at the outer surface. The topology must outlive this
     * object.
     *
     * @param opening over the least height of the cells around a vertex, from
     *   which the cells there are apart.
     * @param first_free the first state of faces that nothing else holds.
     */
    ContactSurface(const Topology &topology,
                   double          opening,
                   FaceState       first_free);

    /**
     * Looks at the faces and at the vertices of those that have opened.
     *
     * @param path see VertexGroups::divide().
     * @return own cells that may touch others now though they could not before,
     *   ascending.
     */
    std::vector<CellIndex>
    look(const State &state, double path);

    /**
     * Takes in the cells around the vertices of a cell in which others lie deep.
     *
     * @return own cells that could not touch others before.
     */
    std::vector<CellIndex>
    include_behind(CellIndex cell);

    /** Cells that this rank owns, ascending. */
    std::vector<CellIndex>
    cells() const;

    /**
     * What other ranks are to know of a cell of this rank: all that can be seen
     * from the topology and the state.
     *
     * @param owner this rank.
     */
    ContactCell
    describe(const State &state, CellIndex cell, int owner) const;

    /** The ranks that see a cell of this rank; ascending. */
    std::vector<int>
    subscribers(CellIndex cell) const;

    /** Writes what the last look() has seen, and the cells behind others. */
    void
    save(Archive &archive) const;

    /** Continues from what save() has written; face states are those of that
     * time. */
    void
    load(const State &state, const Archive &archive);

  private:
    /** Takes in a cell if it is of this rank. */
    void
    include(CellIndex cell, std::vector<CellIndex> &news);

    /** Takes in the cells around a vertex. */
    void
    include_around(VertexIndex vertex, std::vector<CellIndex> &news);

    /** Takes in the two cells of a face that nothing else holds. */
    void
    include_beside(FaceIndex face, std::vector<CellIndex> &news);

    const Topology           &topology;
    const FaceState           first_free;
    std::vector<std::uint8_t> is_member;

    /** Cells around which all may touch others, and own cells that do so for no
     * other reason. */
    std::vector<std::uint8_t> is_surrounded;
    std::vector<CellIndex>    behind;

    /** At the last look. */
    KnownFaceStates face_states;
    VertexGroups    groups;
  };

  /** Where a cell is. */
  Tetrahedron
  positions_of(const Topology &topology, const State &state, CellIndex cell);

  /** Where a cell is and how it moves. */
  CellMotion
  motion_of(const Topology &topology, const State &state, CellIndex cell);
} // namespace rift

#endif
