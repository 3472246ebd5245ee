#include <rift/mesh/face_table.h>
#include <rift/mesh/partition.h>

#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <numeric>

namespace rift
{
  namespace
  {
    std::vector<int>
    cut_curve(const std::vector<double> &weights, const int n_ranks)
    {
      const double total = std::accumulate(weights.begin(), weights.end(), 0.);
      std::vector<int> owners;
      owners.reserve(weights.size());
      double sum = 0;
      for (const double weight : weights)
        {
          // The middle of a cell on the curve decides.
          const double place = n_ranks * (sum + .5 * weight) / total;
          owners.push_back(std::min(static_cast<int>(place), n_ranks - 1));
          sum += weight;
        }
      return owners;
    }

    std::vector<int>
    cut_graph(const MeshData            &mesh,
              const std::vector<double> &weights,
              const int                  n_ranks)
    {
      const auto              n_cells = mesh.cells.size();
      dealii::SparsityPattern graph(n_cells, n_cells, n_corners + 1);
      const FaceTable         faces(mesh);
      for (VertexIndex v = 0; v < faces.n_vertices(); ++v)
        {
          const auto range = faces.faces_of(v);
          for (auto side = range.begin(); side != range.end(); ++side)
            for (auto other = side + 1;
                 other != range.end() && other->middle == side->middle &&
                 other->largest == side->largest;
                 ++other)
              {
                graph.add(side->cell, other->cell);
                graph.add(other->cell, side->cell);
              }
        }
      graph.compress();

      // METIS counts in integers.
      const double largest = *std::max_element(weights.begin(), weights.end());
      std::vector<unsigned int> counts, owners(n_cells);
      for (const double weight : weights)
        counts.push_back(1 +
                         static_cast<unsigned int>(1000 * weight / largest));
      dealii::SparsityTools::partition(graph, counts, n_ranks, owners);
      return {owners.begin(), owners.end()};
    }
  } // namespace

  std::vector<int>
  partition_cells(const MeshData                 &mesh,
                  const int                       n_ranks,
                  const MeshParameters::Partition method,
                  const std::vector<double>      &weights)
  {
    if (mesh.cells.empty() || n_ranks == 1)
      return std::vector<int>(mesh.cells.size(), 0);
    const std::vector<double> all =
      weights.empty() ? std::vector<double>(mesh.cells.size(), 1.) : weights;
    return method == MeshParameters::Partition::metis ?
             cut_graph(mesh, all, n_ranks) :
             cut_curve(all, n_ranks);
  }
} // namespace rift
