#ifndef rift_discretization_corner_news_h
#define rift_discretization_corner_news_h

#include <rift/base/types.h>

#include <array>

namespace rift
{
  /**
   * Something that a module tells other ranks of a corner of a cell at a
   * complete vertex: those at which the vertex is incomplete and which see the
   * cell (GhostExchange).
   */
  struct CornerNews
  {
    /** What it is about; each module has kinds of its own. */
    enum class Kind : std::uint8_t
    {
      /** A node that may part, with its demand. */
      candidate,

      /** A face that is to be cut, with the normal of the crack plane. */
      cut,

      /** A plane along which a node is to be cut, and its area. */
      plane,

      /** A corner of a face at which all strength is lost. */
      failed
    };

    /** The cell, by its index on this rank; its corner; and one of its faces, if
     * it is about one. */
    CellIndex    cell;
    std::uint8_t corner, local_face;

    /** See Kind. */
    Kind                  kind;
    std::array<double, 4> values;
  };
} // namespace rift

#endif
