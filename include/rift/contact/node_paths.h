#ifndef rift_contact_node_paths_h
#define rift_contact_node_paths_h

#include <rift/base/check.h>
#include <rift/discretization/state.h>

#include <vector>

namespace rift
{
  /**
   * How far nodes may have moved: sums over the steps of the time step times a
   * bound of the speeds, m. Of any node, and of blocks of nodes that stand side
   * by side, which are close to each other in the body: a fast fragment is far
   * from most. Only differences between two times count.
   */
  class NodePaths
  {
  public:
    /** Takes in that nodes have split. */
    void
    grow(std::size_t n_nodes);

    /** Adds the step that has led here. */
    void
    advance(const State &state, double time_step);

    /** Takes in how far something that no node here belongs to has moved in
     * this step, m. */
    void
    include(double other_move);

    /** Bound of the path of a node. */
    double
    of(const NodeIndex node) const
    {
      rift_check(node < n_known_nodes);
      return blocks[node / block_size];
    }

    /** Bound of the path of any node. */
    double
    of_any() const
    {
      return path;
    }

    /** Bound of how far anything moved in the last step, m. */
    double
    last_move() const
    {
      return move;
    }

  private:
    static constexpr std::size_t block_size = 32;

    std::vector<double> blocks;
    std::size_t         n_known_nodes = 0;
    double              path = 0, move = 0;
  };
} // namespace rift

#endif
