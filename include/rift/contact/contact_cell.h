#ifndef rift_contact_contact_cell_h
#define rift_contact_contact_cell_h

#include <rift/base/types.h>
#include <rift/contact/cell_motion.h>

namespace rift
{
  /** What contact has to know of a cell that never changes. */
  struct ContactCellConstants
  {
    /** The largest penalty that the time step allows this cell, Pa; infinite
     * where nothing can move it. */
    double penalty;

    /** kg; likewise. */
    double mass;

    /** The rigid body that it belongs to, or invalid_index. */
    std::uint32_t body;
  };

  /** A cell that may touch others, as its owner tells other ranks of it. */
  struct ContactCell
  {
    /** The cell, the rank that owns it, its material and what contact knows of
     * both. */
    GlobalCellIndex      cell;
    int                  owner;
    std::uint32_t        material;
    ContactCellConstants constants;

    /** Where it is, and how it moves. */
    CellMotion motion;

    /** Name of the node at each corner: its first cell and the corner there.
     * Cells with a common node are bonded. */
    std::array<std::uint64_t, n_corners> nodes;

    /** The cell behind each face that holds, or whose cohesive element does;
     * else invalid_index. */
    std::array<GlobalCellIndex, n_corners> bonded;
  };

  /** Whether something other than contact acts between two cells, or they
   * cannot come nearer to each other. */
  inline bool
  are_bonded(const ContactCell &a, const ContactCell &b)
  {
    if (a.constants.body != invalid_index &&
        a.constants.body == b.constants.body)
      return true;
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
