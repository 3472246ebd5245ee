#ifndef rift_discretization_activity_h
#define rift_discretization_activity_h

#include <rift/base/simd.h>
#include <rift/mesh/topology.h>

#include <vector>

namespace rift
{
  /**
   * Which parts of the body have ever moved. A cell whose nodes have no
   * displacement has a force of exactly zero, so batches of such cells and
   * the nodes of only such cells are passed over; the result is the same to
   * the last bit.
   *
   * A batch sleeps until one of its neighbours has had a force or until it is
   * woken by a load; it never falls asleep again.
   */
  class Activity
  {
  public:
    /** Nodes are updated in blocks of this many. */
    static constexpr std::size_t block_size = 32;

    Activity() = default;

    /** All batches are asleep; see wake_all(). */
    explicit Activity(const Topology &topology);

    /** Whether a batch must be computed. */
    bool
    is_awake(const std::size_t batch) const
    {
      return batches[batch] != asleep;
    }

    /** Whether the neighbours of an awake batch have been woken. */
    bool
    has_woken_neighbours(const std::size_t batch) const
    {
      return batches[batch] == awake_and_spread;
    }

    /** Whether any of the nodes `block_size * block + ...` may move. */
    bool
    is_block_awake(const std::size_t block) const
    {
      return blocks[block] != 0;
    }

    /** Nodes made by a split are awake: [old number, n_nodes). */
    void
    grow(std::size_t n_nodes);

    /** Makes all batches and nodes move again. */
    void
    wake_all(const Topology &topology);

    /** Wakes the cells around a node. */
    void
    wake_node(const Topology &topology, NodeIndex node);

    /** To be called when the cells of a batch begin to have forces. */
    void
    wake_neighbours(const Topology &topology, std::size_t batch);

    /** Number of batches that are awake. */
    std::size_t
    n_awake() const;

  private:
    void
    wake_batch(const Topology &topology, std::size_t batch);

    static constexpr std::uint8_t asleep = 0, awake = 1, awake_and_spread = 2;

    std::vector<std::uint8_t> batches;
    std::vector<std::uint8_t> blocks;
  };
} // namespace rift

#endif
