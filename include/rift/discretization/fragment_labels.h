#ifndef rift_discretization_fragment_labels_h
#define rift_discretization_fragment_labels_h

#include <rift/base/communicator.h>
#include <rift/mesh/topology.h>

#include <vector>

namespace rift
{
  /**
   * Names of the pieces of the body, in which cells hang together by faces
   * that have not failed: the smallest global index of their cells.
   */
  struct FragmentLabels
  {
    /** For each cell slot; invalid_index for padding. */
    std::vector<GlobalCellIndex> of_cell;

    /** The pieces of this rank that may go on on others, ascending. */
    std::vector<GlobalCellIndex> divided;
  };

  /** Finds the pieces over all ranks. Collective. */
  FragmentLabels
  label_fragments(const Topology &topology, const Communicator &communicator);

  /** The same as if no face had failed: the bodies that the pieces come from.
   * Collective. */
  FragmentLabels
  label_bodies(const Topology &topology, const Communicator &communicator);
} // namespace rift

#endif
