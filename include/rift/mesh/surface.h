#ifndef rift_mesh_surface_h
#define rift_mesh_surface_h

#include <rift/mesh/mesh_data.h>
#include <rift/mesh/topology.h>

#include <vector>

namespace rift
{
  /** A face of one cell. */
  struct CellFace
  {
    /** The cell, and the number of the face in it. */
    CellIndex    cell;
    std::uint8_t local_face;
  };

  /** Faces that together bear a name, in ascending order of their cells. */
  using Surface = std::vector<CellFace>;

  /** Those of the named faces of one name whose cells this rank sees. */
  inline Surface
  find_surface(const Topology               &topology,
               const std::vector<NamedFace> &named_faces,
               const std::uint16_t           name)
  {
    Surface surface;
    for (const NamedFace &face : named_faces)
      if (face.name == name)
        {
          const CellIndex cell = topology.find_cell(face.cell);
          if (cell != invalid_index)
            surface.push_back({cell, face.local_face});
        }
    return surface;
  }

  /** The nodes of a face, its normal pointing out of the cell. */
  inline std::array<NodeIndex, 3>
  face_nodes(const Topology &topology, const CellFace &face)
  {
    std::array<NodeIndex, 3> nodes;
    for (unsigned int c = 0; c < 3; ++c)
      nodes[c] = topology.node(face.cell, face_corners[face.local_face][c]);
    return nodes;
  }

  /** The nodes of a surface, ascending, each once. */
  std::vector<NodeIndex>
  surface_nodes(const Topology &topology, const Surface &surface);
} // namespace rift

#endif
