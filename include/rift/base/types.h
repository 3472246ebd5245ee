#ifndef rift_base_types_h
#define rift_base_types_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

/**
 * Everything of rift lives in this namespace. All quantities are in SI units.
 */
namespace rift
{
  /** rift is a three-dimensional code. */
  constexpr unsigned int dim = 3;

  /** Number of nodes, faces and corners of a tetrahedron (TET4). */
  constexpr unsigned int n_corners = 4;

  /**
   * Cells, cohesive faces and contact pairs are worked on in batches of this
   * many, one per lane of a SIMD vector. It is the same on every machine, so
   * that the layout of the arrays and of the sums never changes; the compiler
   * splits the vectors where the hardware has shorter ones.
   */
  constexpr unsigned int batch_size = 8;

  /**
   * Index of a cell on this rank, *including* the padding that fills the last
   * batch of each material: batch number times `batch_size` plus lane.
   */
  using CellIndex = std::uint32_t;

  /** Position of a cell in the canonical order of the whole mesh. */
  using GlobalCellIndex = std::uint32_t;

  /** Index of an interior face on this rank. */
  using FaceIndex = std::uint32_t;

  /** Index of a point of the mesh, which never changes. */
  using VertexIndex = std::uint32_t;

  /** Index of a node: what carries the unknowns; a crack makes new ones. */
  using NodeIndex = std::uint32_t;

  /** The index of nothing. */
  constexpr std::uint32_t invalid_index =
    std::numeric_limits<std::uint32_t>::max();
} // namespace rift

#endif
