#ifndef rift_solid_cell_stresses_h
#define rift_solid_cell_stresses_h

#include <rift/solid/internal_force.h>

#include <vector>

namespace rift
{
  /** Stresses of cells at one time, computed when they are asked for, batch by
   * batch, and each batch once. */
  class CellStresses
  {
  public:
    /** Both must outlive this object. */
    CellStresses(const Topology &topology, const InternalForce &internal_force)
      : internal_force(internal_force)
      , position(topology.n_batches(), invalid_index)
    {
    }

    /** Of the eight cells of a batch. Valid until the next call. */
    const InternalForce::BatchStress &
    of_batch(const State &state, const std::uint32_t batch)
    {
      if (position[batch] == invalid_index)
        {
          position[batch] = static_cast<std::uint32_t>(stresses.size());
          computed.push_back(batch);
          stresses.push_back(internal_force.stress(state, batch));
        }
      return stresses[position[batch]];
    }

    /** Forgets all: the state has changed. */
    void
    clear()
    {
      for (const std::uint32_t batch : computed)
        position[batch] = invalid_index;
      computed.clear();
      stresses.clear();
    }

  private:
    const InternalForce &internal_force;

    /** Where the stress of a batch stands in `stresses`. */
    std::vector<std::uint32_t>              position;
    std::vector<std::uint32_t>              computed;
    std::vector<InternalForce::BatchStress> stresses;
  };
} // namespace rift

#endif
