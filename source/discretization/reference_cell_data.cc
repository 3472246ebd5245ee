#include <rift/discretization/reference_cell_data.h>

namespace rift
{
  double
  lumped_mass(const Topology            &topology,
              const ReferenceCellData   &data,
              const std::vector<double> &densities,
              const NodeIndex            node)
  {
    double            mass   = 0;
    const VertexIndex vertex = topology.node_vertices[node];
    for (auto cell = topology.vertex_cells_first(vertex);
         cell != topology.vertex_cells_last(vertex);
         ++cell)
      if (topology.node(*cell, topology.corner_at_vertex(*cell, vertex)) ==
          node)
        mass += densities[topology.material(*cell)] *
                data[*cell / batch_size].volume[*cell % batch_size] / n_corners;
    return mass;
  }
} // namespace rift
