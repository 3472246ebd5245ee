#ifndef rift_contact_interpenetration_h
#define rift_contact_interpenetration_h

#include <rift/base/communicator.h>
#include <rift/discretization/state.h>

namespace rift
{
  /** Cells that lie in each other because nothing holds them apart. */
  struct Interpenetration
  {
    /** Of the volume of the smaller one of two cells; less does not count. */
    static constexpr double tolerated_part = .1;

    /** Pairs of cells that have more in common. */
    std::uint64_t n_pairs = 0;

    /** The largest such part, and a corner of one of the two cells, m. */
    double          largest_part = 0;
    Vector3<double> place        = {{0, 0, 0}};
  };

  /**
   * Looks for cells at outer surfaces and at cracks that lie in each other; of
   * those, cells that an unbroken face or a node connects do not count. For
   * scenes without contact. Collective.
   */
  Interpenetration
  find_interpenetration(const Topology     &topology,
                        const State        &state,
                        const Communicator &communicator);
} // namespace rift

#endif
