#ifndef rift_contact_contact_cell_h
#define rift_contact_contact_cell_h

#include <rift/base/types.h>
#include <rift/contact/cell_motion.h>
#include <rift/contact/contact_penalty.h>

namespace rift
{
  /** What contact has to know of a cell that never changes. */
  struct ContactCellConstants
  {
    /** kg; infinite where nothing can move it. */
    double mass;

    /** The rigid body that it belongs to, or invalid_index. */
    std::uint32_t body;
  };

  /** No step. */
  constexpr std::uint64_t never_included = std::uint64_t(-1);

  /** A cell that may touch others, as its owner tells other ranks of it. */
  struct ContactCell
  {
    /** The cell, the rank that owns it, its material and what contact knows of
     * both. */
    GlobalCellIndex      cell;
    int                  owner;
    std::uint32_t        material;
    ContactCellConstants constants;

    /** As it is now. */
    ContactStiffness stiffness;

    /** Where it was when others were told of it, and how far its corners can be
     * from there before they are told again, m. */
    Tetrahedron positions;
    double      margin;

    /** The step at whose end a crack released it or others came to lie deep in
     * a cell before it, so that it could touch cells that it could not touch
     * before; `never_included` if others are told for another reason. */
    std::uint64_t included_at;

    /** Name of the group at each corner; see VertexGroups. */
    std::array<std::uint64_t, n_corners> groups;

    /** The cell behind each interior face, else invalid_index, and whether
     * something other than contact holds the two sides of this face. */
    std::array<GlobalCellIndex, n_corners> behind;
    std::array<bool, n_corners>            is_held;
  };

  /** Whether something other than contact acts between two cells, or they
   * cannot come nearer to each other. */
  inline bool
  are_bonded(const ContactCell &a, const ContactCell &b)
  {
    if (a.constants.body != invalid_index &&
        a.constants.body == b.constants.body)
      return true;
    // Nobody else has the two sides of a face that is not held.
    for (unsigned int i = 0; i < n_corners; ++i)
      if (a.behind[i] == b.cell)
        return a.is_held[i];
    for (unsigned int i = 0; i < n_corners; ++i)
      for (unsigned int j = 0; j < n_corners; ++j)
        if (a.groups[i] == b.groups[j])
          return true;
    return false;
  }
} // namespace rift

#endif
