#ifndef rift_mesh_cell_ordering_h
#define rift_mesh_cell_ordering_h

#include <rift/mesh/mesh_data.h>

namespace rift
{
  /**
   * Brings a mesh into the canonical order, in which all sums run later and
   * in which cells that are close in space are mostly close in memory:
   *
   * - cells by material, then along a Hilbert curve through the bounding box
   *   of the cell centres, then by their former index;
   * - vertices as they are first met going through the corners of the cells;
   *   a vertex that no cell uses is dropped;
   * - named faces by cell and local face.
   *
   * The corners of a cell keep their order. The result depends on nothing but
   * the mesh.
   */
  void
  order_cells(MeshData &mesh);
} // namespace rift

#endif
