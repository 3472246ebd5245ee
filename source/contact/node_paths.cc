#include <rift/contact/node_paths.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    /** No node of a range is faster, m/s: by the largest components of all. */
    double
    bound_of_speeds(const NodalVector *first, const NodalVector *last)
    {
      Row largest{};
      for (; first != last; ++first)
        {
          const Row squares = first->row() * first->row();
          largest           = largest > squares ? largest : squares;
        }
      return std::sqrt(largest[0] + largest[1] + largest[2]);
    }
  } // namespace

  void
  NodePaths::grow(const std::size_t n_nodes)
  {
    if (n_nodes == n_known_nodes)
      return;
    // A new node may have been anywhere before.
    blocks.resize((n_nodes + block_size - 1) / block_size, path);
    std::fill(blocks.begin() + n_known_nodes / block_size, blocks.end(), path);
    n_known_nodes = n_nodes;
  }

  void
  NodePaths::advance(const State &state, const double time_step)
  {
    grow(state.n_nodes());
    double largest = 0;
    for (std::size_t block = 0; block < blocks.size(); ++block)
      {
        const std::size_t begin = block * block_size;
        const double      speed = bound_of_speeds(
          state.velocity.data() + begin,
          state.velocity.data() + std::min(begin + block_size, n_known_nodes));
        largest = std::max(largest, speed);
        blocks[block] += time_step * speed;
      }
    move = time_step * largest;
    path += move;
  }

  void
  NodePaths::include(const double other_move)
  {
    if (other_move <= move)
      return;
    path += other_move - move;
    move = other_move;
  }
} // namespace rift
