#ifndef rift_mesh_topology_h
#define rift_mesh_topology_h

#include <rift/base/check.h>
#include <rift/base/types.h>

#include <vector>

namespace rift
{
  /** What Topology is made from: one cell that this rank sees. */
  struct LocalCell
  {
    /** Its index on all ranks, its vertices on this rank, and its material. */
    GlobalCellIndex                    global_index;
    std::array<VertexIndex, n_corners> vertices;
    std::uint16_t                      material;

    /** Rank that owns the cell; on other ranks it is a ghost. */
    int owner = 0;
  };

  /** The node that each corner of the eight cells of a batch uses. */
  struct alignas(64) BatchNodes
  {
    /** By corner, then by cell. */
    NodeIndex corner[n_corners][batch_size];
  };

  /** The batches [begin, end) whose cells are all of one material. */
  struct MaterialRange
  {
    /** The material, and its first batch and the one behind its last. */
    std::uint16_t material;
    std::uint32_t begin, end;
  };

  /**
   * An interior face, seen from the two cells that it parts. Side 0, called
   * *minus*, is the cell of smaller global index; side 1 is *plus*.
   */
  struct Face
  {
    /** The cell and the number of the face in it, by side. */
    CellIndex    cells[2];
    std::uint8_t local_faces[2];
  };

  /** An interior face, for all ranks: cell and local face of its minus side. */
  struct FaceName
  {
    /** Global index of the cell, and the number of the face in it. */
    GlobalCellIndex cell;
    std::uint32_t   local_face;
  };

  /** What has become of an interior face. It passes through these states in
   * their order; some may be left out. */
  enum class FaceState : std::uint8_t
  {
    /** The cells share their nodes as far as the cracks around allow. */
    intact,
    /** Cut, but nothing has opened yet. */
    cut,
    /** Its cohesive element has begun to open, or has damage where all faces
     * have an element from the start. */
    opening,
    /** The cohesive element has failed: no tension is left, but it resists
     * overlap and sliding. */
    failed,
    /** The cohesive element has let go and resists nothing any more. */
    released
  };

  /**
   * Which node each corner of each cell uses, and which cells meet at faces
   * and vertices. A crack changes only `batches`, `face_states` and
   * `node_vertices` (see split_nodes()); the rest never changes.
   *
   * Cells stand in ascending global index, in batches of eight; the last batch
   * of a material is filled up with cells of no volume, which have no global
   * index (`invalid_index`) and all corners at node 0.
   *
   * A rank sees the cells that it owns and, as ghosts, all others that share a
   * vertex with one of them. Vertices of owned cells are *complete*: all cells
   * around are here, so that forces, masses and splits at their nodes are
   * known. What happens at the other vertices, GhostExchange tells.
   */
  class Topology
  {
  public:
    /**
     * @param cells in ascending global index, all of a material together.
     * @param n_vertices size of the numbering that `cells` uses. Node i starts
     *   out at vertex i.
     * @param own_rank of this process: it owns the cells with this owner.
     */
    Topology(const std::vector<LocalCell> &cells,
             std::size_t                   n_vertices,
             int                           own_rank = 0);

    /** Number of batches of eight cells. */
    std::size_t
    n_batches() const
    {
      return batches.size();
    }

    /** Number of cells with the padding. */
    std::size_t
    n_cell_slots() const
    {
      return cell_global_indices.size();
    }

    /** Number of cells without the padding, ghosts included. */
    std::size_t
    n_cells() const
    {
      return n_real_cells;
    }

    /** Number of cells that this rank owns. */
    std::size_t
    n_owned_cells() const
    {
      return n_owned;
    }

    /** Whether this rank owns a cell; false for padding. */
    bool
    owns_cell(const CellIndex cell) const
    {
      return cell_owners[cell] == own_rank;
    }

    /** Whether all cells around a vertex are here. */
    bool
    is_complete(const VertexIndex vertex) const
    {
      return vertex_is_complete[vertex] != 0;
    }

    /**
     * Whether this rank owns a node: the owner of the first cell around its
     * vertex does. Each node has one owner.
     */
    bool
    owns_node(const NodeIndex node) const
    {
      const VertexIndex vertex = node_vertices[node];
      rift_check(!is_complete(vertex) ||
                 vertex_cells_first(vertex) != vertex_cells_last(vertex));
      return is_complete(vertex) && owns_cell(*vertex_cells_first(vertex));
    }

    /** Number of nodes that this rank owns now. */
    std::size_t
    n_owned_nodes() const;

    /** Whether this rank owns a face: the owner of its minus side does. */
    bool
    owns_face(const FaceIndex face) const
    {
      return owns_cell(faces[face].cells[0]);
    }

    /** Number of nodes on this rank; it grows as nodes split. */
    std::size_t
    n_nodes() const
    {
      return node_vertices.size();
    }

    /** Number of vertices of the mesh that this rank sees. */
    std::size_t
    n_vertices() const
    {
      return vertex_cells_begin.size() - 1;
    }

    /** Whether a cell slot is empty: it fills the last batch of a material. */
    bool
    is_padding(const CellIndex cell) const
    {
      return cell_global_indices[cell] == invalid_index;
    }

    /** The node that a corner of a cell uses. */
    NodeIndex
    node(const CellIndex cell, const unsigned int corner) const
    {
      rift_check(cell < n_cell_slots() && corner < n_corners);
      return batches[cell / batch_size].corner[corner][cell % batch_size];
    }

    /** The vertex at a corner of a cell. */
    VertexIndex
    vertex(const CellIndex cell, const unsigned int corner) const
    {
      return node_vertices[node(cell, corner)];
    }

    /** The corner at which a cell has this vertex; n_corners if nowhere. */
    unsigned int
    corner_at_vertex(CellIndex cell, VertexIndex vertex) const;

    /** The material of a cell's batch. */
    std::uint16_t
    material(const CellIndex cell) const
    {
      return batch_materials[cell / batch_size];
    }

    /** The cell on the other side of an interior face. */
    CellIndex
    neighbour(const FaceIndex face, const CellIndex cell) const
    {
      rift_check(faces[face].cells[0] == cell || faces[face].cells[1] == cell);
      return faces[face].cells[faces[face].cells[0] == cell ? 1 : 0];
    }

    /** Cells around a vertex, in ascending order: a range of pointers. */
    const CellIndex *
    vertex_cells_first(const VertexIndex vertex) const
    {
      return vertex_cells.data() + vertex_cells_begin[vertex];
    }

    /** End of the range that begins at vertex_cells_first(). */
    const CellIndex *
    vertex_cells_last(const VertexIndex vertex) const
    {
      return vertex_cells.data() + vertex_cells_begin[vertex + 1];
    }

    /** The corners at which these cells have the vertex. */
    const std::uint8_t *
    vertex_corners_first(const VertexIndex vertex) const
    {
      return vertex_corners.data() + vertex_cells_begin[vertex];
    }

    /** The slot of a cell given by its global index; invalid_index if none. */
    CellIndex
    find_cell(GlobalCellIndex global_index) const;

    /** An interior face by its minus side, the same on all ranks. */
    FaceName
    face_name(const FaceIndex face) const
    {
      const Face &f = faces[face];
      return {cell_global_indices[f.cells[0]], f.local_faces[0]};
    }

    /** invalid_index if this rank does not see both sides of it. */
    FaceIndex
    find_face(const FaceName &name) const;

    /**
     * Whether forces are summed at a corner of a face: only then does this
     * rank have to know what it does.
     */
    bool
    needs_face(const FaceIndex face) const;

    /** Nodes of every cell. */
    std::vector<BatchNodes> batches;

    /** Global index of every cell slot. */
    std::vector<GlobalCellIndex> cell_global_indices;

    /** Rank that owns each cell slot; -1 for padding. */
    std::vector<int> cell_owners;

    /** The batches of each material that occurs here, in order. */
    std::vector<MaterialRange> material_ranges;

    /** The material of each batch. */
    std::vector<std::uint16_t> batch_materials;

    /**
     * Interior face at each local face of each cell; local face f is the one
     * opposite to corner f. invalid_index on the surface of the body, and of what
     * this rank sees of it.
     */
    std::vector<std::array<FaceIndex, n_corners>> cell_faces;

    /** Interior faces, ascending by (global index of side 0, local face). */
    std::vector<Face> faces;

    /** What has become of each face. */
    std::vector<FaceState> face_states;

    /** The vertex that each node lies at. */
    std::vector<VertexIndex> node_vertices;

  private:
    void
    make_batches(const std::vector<LocalCell> &cells);

    void
    make_vertex_cells(std::size_t n_vertices);

    void
    make_faces();

    int                        own_rank;
    std::size_t                n_real_cells, n_owned;
    std::vector<std::uint8_t>  vertex_is_complete;
    std::vector<std::uint32_t> vertex_cells_begin;
    std::vector<CellIndex>     vertex_cells;
    std::vector<std::uint8_t>  vertex_corners;
  };
} // namespace rift

#endif
