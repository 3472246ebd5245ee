#ifndef rift_bonds_node_star_h
#define rift_bonds_node_star_h

#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>
#include <rift/mesh/topology.h>

#include <functional>
#include <optional>
#include <vector>

namespace rift
{
  /** A cell that uses a node, and its corner there. */
  struct StarCell
  {
    /** Its index on this rank. */
    CellIndex    cell;
    std::uint8_t corner;
  };

  /** The cells that use a node, in ascending order: the star of a node. */
  std::vector<StarCell>
  cells_at_node(const Topology &topology, NodeIndex node);

  /** The same into a list that keeps its memory. */
  void
  cells_at_node(const Topology        &topology,
                NodeIndex              node,
                std::vector<StarCell> &cells);

  /** How the star of a node is cut in two. */
  struct StarCut
  {
    /** Faces to be cut, which were intact. */
    std::vector<FaceIndex> faces;

    /** Their area, and the area that all faces between the two sides have on
     * the plane, m^2. */
    double new_area, projected_area;
  };

  /**
   * Cuts the star of a node in two along a plane through the node (doc/theory.md,
   * eq. 38). Cells wholly on one side of the plane stay there; those that the
   * plane passes through go where the cut has the smallest new area. Faces that
   * are cut already and end at the node are carried on: the two cells beside
   * them come on different sides.
   *
   * @param node at a complete vertex.
   * @param normal of the plane in the undeformed body, of unit length.
   * @param is_breakable whether a face can be cut.
   * @return nothing where the plane leaves all cells on one side, or where only
   *   faces that cannot be cut would part the sides.
   */
  std::optional<StarCut>
  cut_star(const Topology                       &topology,
           const ReferenceCellData              &reference,
           const State                          &state,
           NodeIndex                             node,
           const Vector3<double>                &normal,
           const std::function<bool(FaceIndex)> &is_breakable);
} // namespace rift

#endif
