#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>
#include <rift/mesh/mesh_parameters.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace rift
{
  namespace
  {
    const char *const section = "Mesh";

    // "radius = 0.019, length = 0.18"
    std::map<std::string, double>
    parse_geo_parameters(const std::string &text)
    {
      const auto fail = [](const std::string &problem) {
        throw ParameterError(section,
                             "Parameters",
                             problem +
                               " Write \"NAME = NUMBER, NAME = NUMBER\".");
      };
      std::map<std::string, double> result;
      for (const std::string &pair : dealii::Utilities::split_string_list(text))
        {
          const std::size_t equals = pair.find('=');
          const std::string name   = simplified(pair.substr(0, equals));
          if (equals == std::string::npos || name.empty())
            fail("\"" + pair + "\" gives no number to a name.");
          const std::string number = simplified(pair.substr(equals + 1));
          if (!dealii::Patterns::Double().match(number))
            fail("\"" + number + "\" is not a number.");
          if (!result.emplace(name, dealii::Utilities::string_to_double(number))
                 .second)
            fail("\"" + name + "\" is given twice.");
        }
      return result;
    }

    void
    check_file(const std::string &file)
    {
      if (file.empty())
        throw ParameterError(section,
                             "File",
                             "a mesh is needed. Give a .geo or .msh file, or "
                             "set Shape to box or cylinder.");
      if (!ends_with(file, ".geo") && !ends_with(file, ".msh"))
        throw ParameterError(section,
                             "File",
                             "the name of a mesh ends with .geo or .msh.");
      if (!std::filesystem::is_regular_file(file))
        throw ParameterError(section,
                             "File",
                             "there is no file \"" + file +
                               "\". Paths are relative to the .prm.");
    }

    void
    check_positive(const std::string &name, const double value)
    {
      if (!(value > 0))
        throw ParameterError(section,
                             name,
                             "this must be greater than zero. Units: m.");
    }

    // `volume` and `largest` of the body in which the cells have to fit.
    void
    check_element_size(const double size,
                       const double volume,
                       const double largest)
    {
      check_positive("Element size", size);
      if (size > largest)
        throw ParameterError(section,
                             "Element size",
                             "the cells are larger than the body, which is " +
                               short_text(largest) +
                               " m. Is it in mm? rift uses m.");
      // A regular tetrahedron of edge h has the volume 0.118 h^3.
      const double n_cells = volume / (0.118 * size * size * size);
      if (n_cells > 4e9)
        throw ParameterError(section,
                             "Element size",
                             "this would make about " + short_text(n_cells) +
                               " cells; rift can count 4e+09. Is the body "
                               "given in mm? rift uses m.");
    }
  } // namespace

  void
  MeshParameters::declare(dealii::ParameterHandler &prm)
  {
    namespace Patterns = dealii::Patterns;
    const MeshParameters defaults;
    prm.enter_subsection(section);
    prm.declare_entry("Shape",
                      "file",
                      Patterns::Selection("file|box|cylinder"),
                      "Where the mesh comes from: a file of gmsh, or a "
                      "built-in box or cylinder.");
    prm.declare_entry("File",
                      "",
                      Patterns::Anything(),
                      "A .geo, which is meshed at the start, or a .msh file, "
                      "relative to the .prm. Its physical volumes are the "
                      "materials, its physical surfaces the boundaries.");
    declare_number(prm,
                   "Element size",
                   defaults.element_size,
                   "Edge length of the tetrahedra. A .geo gets it as the "
                   "number element_size; 0 leaves the .geo its own. Units: "
                   "m.");
    prm.declare_entry("Parameters",
                      "",
                      Patterns::Anything(),
                      "Numbers that a .geo declares by DefineConstant, as in "
                      "radius = 0.019, length = 0.18.");
    declare_vector(prm,
                   "Box size",
                   defaults.box_size,
                   "Edges of the box along x, y, z; it has a corner at the "
                   "origin and the boundaries x_min, x_max, y_min, y_max, "
                   "z_min, z_max. Units: m.");
    declare_number(prm,
                   "Cylinder radius",
                   defaults.cylinder_radius,
                   "Radius of the cylinder. Units: m.");
    declare_number(prm,
                   "Cylinder length",
                   defaults.cylinder_length,
                   "Length of the cylinder along x, from x = 0; it has the "
                   "boundaries start, end, side. Units: m.");
    prm.declare_entry("Material",
                      defaults.material,
                      Patterns::Anything(),
                      "The material of a built-in shape.");
    prm.declare_entry("Partition",
                      "curve",
                      Patterns::Selection("curve|metis"),
                      "How the cells are divided among ranks: in ranges along "
                      "a space-filling curve, or by METIS, which takes longer "
                      "and makes smaller interfaces. Results do not depend on "
                      "it.");
    prm.leave_subsection();
  }

  MeshParameters
  MeshParameters::parse(dealii::ParameterHandler &prm,
                        const ParameterFile      &scene)
  {
    MeshParameters result;
    prm.enter_subsection(section);
    const std::string shape = prm.get("Shape");
    result.shape            = shape == "box"      ? Shape::box :
                              shape == "cylinder" ? Shape::cylinder :
                                                    Shape::file;
    if (!prm.get("File").empty())
      result.file = scene.resolve(section, "File", prm.get("File"));
    result.element_size    = prm.get_double("Element size");
    result.geo_parameters  = parse_geo_parameters(prm.get("Parameters"));
    result.box_size        = get_vector(prm, "Box size");
    result.cylinder_radius = prm.get_double("Cylinder radius");
    result.cylinder_length = prm.get_double("Cylinder length");
    result.material        = prm.get("Material");
    result.partition =
      prm.get("Partition") == "metis" ? Partition::metis : Partition::curve;
    prm.leave_subsection();
    return result;
  }

  void
  MeshParameters::check() const
  {
    switch (shape)
      {
      case Shape::file:
        check_file(file);
        if (element_size != 0)
          check_positive("Element size", element_size);
        break;
      case Shape::box:
        for (const double edge : box_size)
          check_positive("Box size", edge);
        check_element_size(element_size,
                           box_size[0] * box_size[1] * box_size[2],
                           *std::max_element(box_size.begin(), box_size.end()));
        break;
      case Shape::cylinder:
        check_positive("Cylinder radius", cylinder_radius);
        check_positive("Cylinder length", cylinder_length);
        check_element_size(element_size,
                           M_PI * cylinder_radius * cylinder_radius *
                             cylinder_length,
                           std::max(2 * cylinder_radius, cylinder_length));
        break;
      }
  }

  std::vector<InertEntries>
  MeshParameters::inert_entries() const
  {
    const auto inert = [](const std::vector<std::string> &names,
                          const std::string              &cause,
                          const std::string              &reason) {
      return InertEntries{section, names, {{section, cause}}, reason};
    };
    switch (shape)
      {
      case Shape::box:
        return {
          inert({"File", "Parameters", "Cylinder radius", "Cylinder length"},
                "Shape",
                "on a box")};
      case Shape::cylinder:
        return {
          inert({"File", "Parameters", "Box size"}, "Shape", "on a cylinder")};
      default:
        break;
      }
    std::vector<InertEntries> result = {
      inert({"Box size", "Cylinder radius", "Cylinder length", "Material"},
            "Shape",
            "on a mesh from a file")};
    if (ends_with(file, ".msh"))
      result.push_back(inert({"Element size", "Parameters"},
                             "File",
                             "on a .msh, which is meshed already"));
    return result;
  }
} // namespace rift
