#ifndef rift_mesh_gmsh_model_h
#define rift_mesh_gmsh_model_h

#include <rift/mesh/mesh_data.h>

#include <string>

namespace rift
{
  /**
   * Takes the mesh out of gmsh's current model.
   *
   * The vertices are the nodes that tetrahedra use, in ascending order of
   * gmsh's tags. Other nodes are left out if gmsh has them on a point, curve
   * or surface (centres of arcs and other aids of construction). In a volume
   * gmsh's mesher leaves some behind; in a `.msh` they are an error. Corners
   * are swapped where that makes the volume of a cell positive. A triangle of
   * a named surface becomes a boundary face or, between two cells, an internal
   * face of the cell of smaller index. Names have their blanks as those of a
   * scene, none at the ends and no two in a row.
   *
   * @throws InputError if there are no cells, for other volume elements than
   * 4-node tetrahedra, for volumes and surface elements in none or two
   * physical groups or in a group without name, for names that two groups of one kind have, and for
   * surface triangles that are no face of a cell.
   */
  MeshData
  extract_mesh(const std::string &source);
} // namespace rift

#endif
