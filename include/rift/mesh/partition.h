#ifndef rift_mesh_partition_h
#define rift_mesh_partition_h

#include <rift/mesh/mesh_data.h>
#include <rift/mesh/mesh_parameters.h>

#include <vector>

namespace rift
{
  /**
   * Divides the cells among ranks such that the weights are even.
   *
   * - `curve`: ranges of the canonical order, that of a space-filling curve:
   *   takes no time, and few bytes in a checkpoint.
   * - `metis`: METIS's division of the graph of neighbours, with smaller
   *   interfaces.
   *
   * @param mesh in the order of order_cells(); empty where another rank has it.
   * @param weights cost of each cell; empty: all the same.
   * @return the rank of each cell; each rank has one at least.
   */
  std::vector<int>
  partition_cells(const MeshData            &mesh,
                  int                        n_ranks,
                  MeshParameters::Partition  method,
                  const std::vector<double> &weights = {});
} // namespace rift

#endif
