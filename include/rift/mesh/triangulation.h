#ifndef rift_mesh_triangulation_h
#define rift_mesh_triangulation_h

#include <rift/mesh/mesh_data.h>

#include <deal.II/distributed/fully_distributed_tria.h>

#include <memory>

namespace rift
{
  /**
   * deal.II's view of a mesh, distributed over the ranks of `communicator`.
   *
   * - The coarse cell id of a cell, `cell->id().get_coarse_cell_id()`, is its
   *   index in MeshData::cells, and its vertices keep their order.
   * - The material id is the index into MeshData::material_names.
   * - The boundary id of a named face is 1 + its index in
   *   MeshData::surface_names; it is 0 for faces without a name.
   * - Each rank has the cells that it owns and, as ghosts, those that share a
   *   vertex with one of them.
   *
   * Only rank 0 reads `mesh` and `owners`; the others may pass empty ones.
   *
   * @param owners rank of each cell; see partition_cells().
   */
  std::unique_ptr<dealii::parallel::fullydistributed::Triangulation<dim>>
  make_triangulation(const MeshData         &mesh,
                     const std::vector<int> &owners,
                     const MPI_Comm         &communicator);
} // namespace rift

#endif
