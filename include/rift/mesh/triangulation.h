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
   * - Each rank owns a contiguous range of the cells, which are expected in
   *   the order of order_cells(); the ranges differ by one cell at most.
   *
   * Only rank 0 reads `mesh`; the others may pass an empty one.
   */
  std::unique_ptr<dealii::parallel::fullydistributed::Triangulation<dim>>
  make_triangulation(const MeshData &mesh, const MPI_Comm &communicator);
} // namespace rift

#endif
