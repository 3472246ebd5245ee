#ifndef rift_mesh_mesh_parameters_h
#define rift_mesh_mesh_parameters_h

#include <rift/base/parameter_file.h>
#include <rift/base/vector3.h>

#include <map>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /** Where the mesh comes from: subsection Mesh of the .prm. */
  struct MeshParameters
  {
    /** A file, or a built-in shape. */
    enum class Shape
    {
      file,
      box,
      cylinder
    };

    /** How cells are divided among ranks; see partition_cells(). */
    enum class Partition
    {
      curve,
      metis
    };

    /** The entry Shape. */
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

    /** The entry Partition; it has no influence on results. */
    Partition partition = Partition::curve;

    /** Declares the entries of subsection Mesh. */
    static void
    declare(dealii::ParameterHandler &prm);

    /**
     * Reads subsection Mesh; `scene` tells from where paths start. Throws
     * ParameterError if `Parameters` is not a list of NAME=NUMBER.
     */
    static MeshParameters
    parse(dealii::ParameterHandler &prm, const ParameterFile &scene);

    /**
     * Throws ParameterError for a file that does not exist or is no .geo or
     * .msh, for sizes that are not positive, and for an element size that is
     * larger than the body or makes more cells than indices can count.
     */
    void
    check() const;

    /** What the choice of the shape leaves without effect. */
    std::vector<InertEntries>
    inert_entries() const;
  };
} // namespace rift

#endif
