#ifndef rift_mesh_mesh_data_h
#define rift_mesh_mesh_data_h

#include <rift/base/types.h>
#include <rift/base/vector3.h>

#include <string>
#include <vector>

namespace rift
{
  /**
   * A named face of the mesh: local face `local_face` of cell `cell`, which is
   * the face opposite to the corner of that number, belongs to the surface
   * `name`, an index into MeshData::surface_names.
   */
  struct NamedFace
  {
    /** The cell, the number of its face, and the name, as an index. */
    GlobalCellIndex cell;
    std::uint8_t    local_face;
    std::uint16_t   name;
  };

  /**
   * A mesh of tetrahedra as it comes from gmsh, before it is distributed.
   */
  struct MeshData
  {
    /** Where it came from, for messages: a path, or "built-in box". */
    std::string source;

    /** Points, m. */
    std::vector<Vector3<double>> vertices;

    /** The four corners of each cell, of positive volume. */
    std::vector<std::array<VertexIndex, n_corners>> cells;

    /** The tag that each cell has in the file, for messages. */
    std::vector<std::size_t> cell_tags;

    /** For each cell an index into material_names. */
    std::vector<std::uint16_t> cell_materials;

    /** Names of the physical volumes, in ascending order of gmsh's tag. */
    std::vector<std::string> material_names;

    /** Names of the physical surfaces, in ascending order of gmsh's tag. */
    std::vector<std::string> surface_names;

    /** Faces on the surface of the body that have a name. */
    std::vector<NamedFace> boundary_faces;

    /** Faces inside the body that have a name (joints); one side of each. */
    std::vector<NamedFace> internal_faces;
  };

  /**
   * The corners of the local face that is opposite to corner `face`, in the
   * order that makes the normal by the right-hand rule point out of the cell.
   */
  constexpr std::array<std::array<unsigned int, 3>, n_corners> face_corners = {
    {{{1, 2, 3}}, {{0, 3, 2}}, {{0, 1, 3}}, {{0, 2, 1}}}};
} // namespace rift

#endif
