#ifndef rift_mesh_mesh_parameters_h
#define rift_mesh_mesh_parameters_h

#include <rift/base/vector3.h>

#include <map>
#include <string>

namespace rift
{
  /** Where the mesh comes from: subsection Mesh of the .prm. */
  struct MeshParameters
  {
    enum class Shape
    {
      file,
      box,
      cylinder
    };

    Shape shape = Shape::file;

    /** A .geo or .msh file, already made relative to the .prm's folder. */
    std::string file;

    /** Edge length of the cells, m; 0 leaves the sizes of a .geo alone. */
    double element_size = 0;

    /** Numbers given to a .geo by name (`DefineConstant`). */
    std::map<std::string, double> geo_parameters;

    /** Edges of the built-in box with a corner at the origin, m. */
    Vector3<double> box_size = {{0, 0, 0}};

    /** Built-in cylinder along x, from x = 0, m. */
    double cylinder_radius = 0;
    double cylinder_length = 0;

    /** The only material of a built-in shape. */
    std::string material = "rock";
  };
} // namespace rift

#endif
