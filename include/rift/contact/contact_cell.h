#ifndef rift_contact_contact_cell_h
#define rift_contact_contact_cell_h

#include <rift/base/types.h>
#include <rift/contact/contact_pair.h>

namespace rift
{
  /** A cell that may touch others, as its owner tells all ranks of it. */
  struct ContactCell
  {
    GlobalCellIndex cell;
    int             owner;
    std::uint32_t   material;

    /** The largest penalty that the time step allows this cell, Pa. */
    double penalty;

    /** kg */
    double mass;

    CellMotion motion;

    /** Name of the node at each corner: its first cell and the corner there.
     * Cells with a common node are bonded. */
    std::array<std::uint64_t, n_corners> nodes;

    /** The cell behind each face that holds, or whose cohesive element does;
     * else invalid_index. */
    std::array<GlobalCellIndex, n_corners> bonded;
  };

  /** Whether something other than contact acts between two cells. */
  inline bool
  are_bonded(const ContactCell &a, const ContactCell &b)
  {
    for (unsigned int i = 0; i < n_corners; ++i)
      {
        if (a.bonded[i] == b.cell)
          return true;
        for (unsigned int j = 0; j < n_corners; ++j)
          if (a.nodes[i] == b.nodes[j])
            return true;
      }
    return false;
  }
} // namespace rift

#endif
