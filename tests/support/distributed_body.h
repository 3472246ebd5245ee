#ifndef rift_tests_support_distributed_body_h
#define rift_tests_support_distributed_body_h

#include "test_body.h"

#include <map>
#include <set>

namespace rift::test
{
  /** What one rank sees of a body: its own cells and one layer of ghosts. */
  struct BodyPart
  {
    Body body;
    int  rank;

    /** The vertex of the whole body that each vertex here is. */
    std::vector<VertexIndex> global_vertices;
  };

  /**
   * Cuts out what one rank sees.
   *
   * @param body in order(): its global indices and vertices are those of the
   *   whole.
   * @param owners rank of each cell.
   */
  inline BodyPart
  part_of(const Body &body, const std::vector<int> &owners, const int rank)
  {
    std::set<VertexIndex> own_vertices;
    for (std::size_t i = 0; i < body.cells.size(); ++i)
      if (owners[i] == rank)
        own_vertices.insert(body.cells[i].vertices.begin(),
                            body.cells[i].vertices.end());

    BodyPart                           part{{}, rank, {}};
    std::map<VertexIndex, VertexIndex> local;
    for (std::size_t i = 0; i < body.cells.size(); ++i)
      {
        LocalCell  cell   = body.cells[i];
        const auto is_own = [&](const VertexIndex v) {
          return own_vertices.count(v) > 0;
        };
        if (std::none_of(cell.vertices.begin(), cell.vertices.end(), is_own))
          continue;
        cell.owner = owners[i];
        for (VertexIndex &v : cell.vertices)
          {
            const auto [entry, is_new] =
              local.emplace(v, part.global_vertices.size());
            if (is_new)
              {
                part.global_vertices.push_back(v);
                part.body.vertices.push_back(body.vertices[v]);
              }
            v = entry->second;
          }
        part.body.cells.push_back(cell);
      }
    return part;
  }

  inline DiscreteBody
  discretize(const BodyPart &part, const std::vector<double> &densities)
  {
    return discretize_ordered(part.body, densities, part.rank);
  }

  /**
   * An owner for each cell: by chance for each, or runs of cells that follow
   * each other. Some ranks may own nothing.
   */
  inline std::vector<int>
  random_owners(const std::size_t n_cells,
                const int         n_ranks,
                std::mt19937     &random)
  {
    const bool       in_runs = random() % 2 == 0;
    std::vector<int> owners;
    for (std::size_t i = 0; i < n_cells; ++i)
      owners.push_back(in_runs && i > 0 && random() % 8 > 0 ?
                         owners.back() :
                         static_cast<int>(random() % n_ranks));
    return owners;
  }
} // namespace rift::test

#endif
