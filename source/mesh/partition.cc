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
      const auto   n_cells = static_cast<std::int64_t>(weights.size());
      std::vector<int> owners;
      owners.reserve(weights.size());
      double sum = 0;
      for (std::int64_t cell = 0; cell < n_cells; ++cell)
        {
          // The middle of a cell on the curve decides, but every rank gets a
          // cell at least.
          const double place = n_ranks * (sum + .5 * weights[cell]) / total;
          const auto   smallest =
            std::max<std::int64_t>(0, n_ranks - (n_cells - cell));
          const std::int64_t largest =
            owners.empty() ? 0 : std::min(owners.back() + 1, n_ranks - 1);
          owners.push_back(static_cast<int>(
            std::max(smallest,
                     std::min(static_cast<std::int64_t>(place), largest))));
          sum += weights[cell];
        }
      return owners;
    }

    bool
    has_empty_rank(const std::vector<int> &owners, const int n_ranks)
    {
      std::vector<bool> is_used(n_ranks, false);
      for (const int owner : owners)
        is_used[owner] = true;
      return std::find(is_used.begin(), is_used.end(), false) != is_used.end();
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

      // METIS counts in integers of 32 bits.
      const double unit    = std::min(1000., 1e9 / n_cells);
      const double largest = *std::max_element(weights.begin(), weights.end());
      std::vector<unsigned int> counts, owners(n_cells);
      for (const double weight : weights)
        counts.push_back(1 +
                         static_cast<unsigned int>(unit * weight / largest));
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
    if (method == MeshParameters::Partition::metis)
      {
        std::vector<int> owners = cut_graph(mesh, all, n_ranks);
        // It does so where there are few cells for each.
        if (!has_empty_rank(owners, n_ranks))
          return owners;
      }
    return cut_curve(all, n_ranks);
  }
} // namespace rift
