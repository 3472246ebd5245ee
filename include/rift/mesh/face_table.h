#ifndef rift_mesh_face_table_h
#define rift_mesh_face_table_h

#include <rift/mesh/mesh_data.h>

namespace rift
{
  /**
   * All faces of all cells of a mesh, sorted so that the two sides of a face
   * lie next to each other and a face is found by its corners.
   */
  class FaceTable
  {
  public:
    /** One side of a face. */
    struct Side
    {
      /** The two larger vertices of the face, in ascending order. */
      VertexIndex middle, largest;

      /** The cell, and the number of the face in it. */
      GlobalCellIndex cell;
      std::uint8_t    local_face;
      /**
       * Whether the outward corners of the cell's face are an odd permutation
       * of the ascending order. The two cells of a face that lie on opposite
       * sides of it differ in this.
       */
      bool odd;
    };

    /** The sides of one face: one on the boundary, two inside the body. */
    struct Range
    {
      /** The first side, and one past the last. */
      const Side *first, *last;

      /** The first side. */
      const Side *
      begin() const
      {
        return first;
      }

      /** One past the last side. */
      const Side *
      end() const
      {
        return last;
      }

      /** Number of sides: 1 on the surface of the mesh, 2 inside. */
      std::size_t
      size() const
      {
        return last - first;
      }
    };

    /** Takes linear time. The cells' vertex indices must be in range. */
    explicit FaceTable(const MeshData &mesh);

    /**
     * The sides, in ascending order of cells, of the face with these corners
     * in any order; empty if no cell has it.
     */
    Range
    find(std::array<VertexIndex, 3> corners) const;

    /** The smallest vertex of a face is in [0, n_vertices()). */
    VertexIndex
    n_vertices() const
    {
      return static_cast<VertexIndex>(begin_of_vertex.size() - 1);
    }

    /** The sides of all faces whose smallest vertex is `vertex`. */
    Range
    faces_of(const VertexIndex vertex) const
    {
      return {sides.data() + begin_of_vertex[vertex],
              sides.data() + begin_of_vertex[vertex + 1]};
    }

  private:
    std::vector<std::size_t> begin_of_vertex;
    std::vector<Side>        sides;
  };
} // namespace rift

#endif
