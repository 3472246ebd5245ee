// What a division into 2, 4, ... 4096 parts costs: cells computed twice and
// messages, counted on one process without MPI.
//   partition_benchmark SCENE.prm [SECTION/NAME=VALUE ...] > parts.csv

#include <rift/app/body.h>
#include <rift/base/exceptions.h>
#include <rift/mesh/partition.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <numeric>

namespace rift::test
{
  namespace
  {
    constexpr int largest_n_parts = 4096;

    using Ranks = std::vector<int>;

    void
    make_unique(Ranks &ranks)
    {
      std::sort(ranks.begin(), ranks.end());
      ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    }

    /** The cells around each vertex, ascending. */
    std::vector<std::vector<CellIndex>>
    cells_around_vertices(const MeshData &mesh)
    {
      std::vector<std::vector<CellIndex>> result(mesh.vertices.size());
      for (CellIndex cell = 0; cell < mesh.cells.size(); ++cell)
        for (const VertexIndex v : mesh.cells[cell])
          result[v].push_back(cell);
      return result;
    }

    /** What each rank sends in a step. */
    class Traffic
    {
    public:
      explicit Traffic(const int n_ranks)
        : nodes(n_ranks)
      {
      }

      void
      add_node(const int from, const int to)
      {
        ++nodes[from][to];
      }

      std::vector<std::size_t>
      messages() const
      {
        std::vector<std::size_t> result;
        for (const auto &partners : nodes)
          result.push_back(partners.size());
        return result;
      }

      /** @param per_message bytes of its header. */
      std::vector<std::size_t>
      bytes(const std::size_t per_message) const
      {
        std::vector<std::size_t> result;
        for (const auto &partners : nodes)
          {
            std::size_t sum = per_message * partners.size();
            for (const auto &[rank, n] : partners)
              sum += dim * sizeof(double) * n;
            result.push_back(sum);
          }
        return result;
      }

    private:
      /** By sender and receiver. */
      std::vector<std::map<int, std::size_t>> nodes;
    };

    struct Counts
    {
      explicit Counts(const int n_ranks)
        : owned(n_ranks)
        , visible(n_ranks)
        , at_own_nodes(n_ranks)
        , followed(n_ranks)
        , shared(n_ranks)
      {
      }

      /** Cells of each rank, without and with its ghosts. */
      std::vector<std::size_t> owned, visible;

      /** Cells that a rank would compute if it summed the forces of the nodes
       * that it owns alone. */
      std::vector<std::size_t> at_own_nodes;

      /** Nodes at incomplete vertices, as GhostExchange sends them. */
      Traffic followed;

      /** Nodes of several ranks, if they sent each other sums of forces. */
      Traffic shared;
    };

    Counts
    count(const MeshData                            &mesh,
          const std::vector<std::vector<CellIndex>> &vertex_cells,
          const std::vector<int>                    &owners,
          const int                                  n_ranks)
    {
      Counts             counts(n_ranks);
      std::vector<Ranks> vertex_owners(vertex_cells.size());
      for (VertexIndex v = 0; v < vertex_cells.size(); ++v)
        {
          Ranks &ranks = vertex_owners[v];
          for (const CellIndex cell : vertex_cells[v])
            ranks.push_back(owners[cell]);
          make_unique(ranks);
          for (const int from : ranks)
            for (const int to : ranks)
              if (from != to)
                counts.shared.add_node(from, to);
        }

      // A cell is seen by all that own a cell at one of its vertices.
      std::vector<Ranks> viewers(mesh.cells.size());
      for (CellIndex cell = 0; cell < mesh.cells.size(); ++cell)
        {
          for (const VertexIndex v : mesh.cells[cell])
            viewers[cell].insert(viewers[cell].end(),
                                 vertex_owners[v].begin(),
                                 vertex_owners[v].end());
          make_unique(viewers[cell]);
          ++counts.owned[owners[cell]];
          for (const int rank : viewers[cell])
            ++counts.visible[rank];

          Ranks node_owners;
          for (const VertexIndex v : mesh.cells[cell])
            node_owners.push_back(owners[vertex_cells[v][0]]);
          make_unique(node_owners);
          for (const int rank : node_owners)
            ++counts.at_own_nodes[rank];
        }

      // Where a rank sees some cells around a vertex but not all of them, the
      // owner of the first one that it sees tells it of the node.
      for (const auto &cells : vertex_cells)
        {
          struct View
          {
            CellIndex   first;
            std::size_t n_cells = 0;
          };
          std::map<int, View> views;
          for (const CellIndex cell : cells)
            for (const int rank : viewers[cell])
              ++views.try_emplace(rank, View{cell}).first->second.n_cells;
          for (const auto &[rank, view] : views)
            if (view.n_cells < cells.size())
              counts.followed.add_node(owners[view.first], rank);
        }
      return counts;
    }

    std::size_t
    largest(const std::vector<std::size_t> &numbers)
    {
      return *std::max_element(numbers.begin(), numbers.end());
    }

    double
    mean(const std::vector<std::size_t> &numbers)
    {
      return std::accumulate(numbers.begin(), numbers.end(), 0.) /
             numbers.size();
    }

    void
    print_header()
    {
      std::cout << "method,parts,owned min,owned mean,owned max,ghosts mean,"
                   "ghosts max,visible max,redundancy,imbalance,"
                   "redundancy at own nodes,imbalance at own nodes,"
                   "messages mean,messages max,bytes mean,bytes max,"
                   "shared messages mean,shared messages max,"
                   "shared bytes mean,shared bytes max\n";
    }

    void
    print_traffic(const Traffic &traffic, const std::size_t per_message)
    {
      const auto messages = traffic.messages();
      const auto bytes    = traffic.bytes(per_message);
      std::cout << ',' << mean(messages) << ',' << largest(messages) << ','
                << mean(bytes) << ',' << largest(bytes);
    }

    void
    print(const std::string &method, const Counts &counts)
    {
      const auto              &owned   = counts.owned;
      const auto              &visible = counts.visible;
      std::vector<std::size_t> ghosts;
      for (std::size_t i = 0; i < owned.size(); ++i)
        ghosts.push_back(visible[i] - owned[i]);
      std::cout << method << ',' << owned.size() << ','
                << *std::min_element(owned.begin(), owned.end()) << ','
                << mean(owned) << ',' << largest(owned) << ',' << mean(ghosts)
                << ',' << largest(ghosts) << ',' << largest(visible) << ','
                << mean(visible) / mean(owned) << ','
                << largest(visible) / mean(visible) << ','
                << mean(counts.at_own_nodes) / mean(owned) << ','
                << largest(counts.at_own_nodes) / mean(counts.at_own_nodes);
      print_traffic(counts.followed, 8);
      print_traffic(counts.shared, 0);
      std::cout << std::endl;
    }

    void
    count_all(const std::string              &scene,
              const std::vector<std::string> &overrides)
    {
      const MeshData mesh =
        make_mesh(read_parameters(scene, overrides), Communicator());
      const auto vertex_cells = cells_around_vertices(mesh);
      std::cerr << mesh.cells.size() << " cells, " << mesh.vertices.size()
                << " vertices\n";
      print_header();
      using Partition = MeshParameters::Partition;
      const std::pair<std::string, Partition> methods[] = {
        {"curve", Partition::curve},
        {"metis", Partition::metis}};
      for (const auto &[name, method] : methods)
        for (int n = 2; n <= largest_n_parts; n *= 2)
          print(name,
                count(mesh, vertex_cells, partition_cells(mesh, n, method), n));
    }
  } // namespace
} // namespace rift::test

int
main(int argc, char **argv)
{
  if (argc < 2)
    {
      std::cerr << "usage: partition_benchmark SCENE.prm "
                   "[SECTION/NAME=VALUE ...]\n";
      return 1;
    }
  try
    {
      rift::test::count_all(argv[1], {argv + 2, argv + argc});
    }
  catch (const rift::Error &error)
    {
      std::cerr << "partition_benchmark: " << error.what() << '\n';
      return 1;
    }
}
