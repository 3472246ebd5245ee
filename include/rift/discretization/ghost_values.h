#ifndef rift_discretization_ghost_values_h
#define rift_discretization_ghost_values_h

#include <rift/base/check.h>
#include <rift/base/communicator.h>
#include <rift/mesh/topology.h>

#include <map>
#include <vector>

namespace rift
{
  /**
   * Gives ghosts the values of their cells on the ranks that own them.
   * Collective.
   *
   * @param values one for each cell slot.
   */
  template <typename T>
  void
  copy_to_ghosts(const Communicator &communicator,
                 const Topology     &topology,
                 std::vector<T>     &values)
  {
    if (communicator.size() == 1)
      return;
    std::map<int, std::vector<GlobalCellIndex>> questions;
    std::map<int, std::vector<CellIndex>>       ghosts;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (!topology.is_padding(cell) && !topology.owns_cell(cell))
        {
          const int owner = topology.cell_owners[cell];
          questions[owner].push_back(topology.cell_global_indices[cell]);
          ghosts[owner].push_back(cell);
        }
    std::map<int, std::vector<T>> answers;
    for (const auto &[rank, cells] : communicator.exchange(questions))
      for (const GlobalCellIndex cell : cells)
        {
          const CellIndex own = topology.find_cell(cell);
          rift_check(own != invalid_index && topology.owns_cell(own));
          answers[rank].push_back(values[own]);
        }
    for (const auto &[rank, of_rank] : communicator.exchange(answers))
      for (std::size_t i = 0; i < of_rank.size(); ++i)
        values[ghosts[rank][i]] = of_rank[i];
  }
} // namespace rift

#endif
