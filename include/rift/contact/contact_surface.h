#ifndef rift_contact_contact_surface_h
#define rift_contact_contact_surface_h

#include <rift/contact/contact_cell.h>
#include <rift/discretization/state.h>

#include <functional>
#include <vector>

namespace rift
{
  /**
   * The cells of this rank that may touch others: those with a face on the
   * outer surface, and those around the vertices of a crack.
   */
  class ContactSurface
  {
  public:
    /** Takes in the cells at the outer surface. The topology must outlive this
     * object. */
    explicit ContactSurface(const Topology &topology);

    /** Takes in the cells around the vertices of a face that has opened. */
    void
    include(FaceIndex face);

    /** Takes in a cell of this rank. */
    void
    include_cell(CellIndex cell);

    /** Cells that this rank owns, ascending. */
    std::vector<CellIndex>
    cells() const;

    /** Whether something other than contact holds the sides of a face apart
     * and together. */
    using IsHeld = std::function<bool(FaceIndex)>;

    /**
     * What other ranks are to know of a cell of this rank; the penalty is left
     * to the caller.
     *
     * @param owner this rank.
     */
    ContactCell
    describe(CellIndex cell, int owner, const IsHeld &is_held) const;

    /** The ranks that see a cell of this rank; ascending. */
    std::vector<int>
    subscribers(CellIndex cell) const;

  private:
    const Topology           &topology;
    std::vector<std::uint8_t> is_member;
  };

  /** Where a cell is and how it moves. */
  CellMotion
  motion_of(const Topology &topology, const State &state, CellIndex cell);
} // namespace rift

#endif
