#include <rift/base/exceptions.h>
#include <rift/base/parameter_text.h>
#include <rift/mesh/child_process.h>
#include <rift/mesh/geo_script.h>
#include <rift/mesh/gmsh_model.h>
#include <rift/mesh/gmsh_reader.h>
#include <rift/mesh/gmsh_session.h>
#include <rift/mesh/mesh_buffer.h>
#include <rift/mesh/msh_file.h>

#include <fmt/format.h>
#include <gmsh.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <limits>

namespace rift
{
  namespace
  {
    // Runs `make_model` and takes the mesh out of the model that it leaves in
    // gmsh, all of it in a process of its own.
    MeshData
    run_gmsh(
      const std::string                   &source,
      const std::map<std::string, double> &numbers,
      const std::function<void()>         &make_model,
      const std::size_t memory_limit = std::numeric_limits<std::size_t>::max())
    {
      const auto work = [&]() {
        const GmshSession session(numbers);
        try
          {
            make_model();
            return pack_mesh(extract_mesh(source));
          }
        catch (const std::string &message)
          {
            // That is what gmsh throws.
            throw InputError(fmt::format("{}: gmsh says: {}", source, message));
          }
      };

      try
        {
          return unpack_mesh(run_in_child_process(work, memory_limit));
        }
      catch (const ChildProcessError &error)
        {
          if (error.signal == SIGINT || error.signal == SIGTERM)
            throw Error(ExitCode::stopped_by_signal,
                        "Stopped by a signal while gmsh was at work.");
          throw InputError(
            fmt::format("{}: gmsh {} while it was at work on it. The file may "
                        "be damaged or ask for a mesh that is too large; see "
                        "what gmsh itself makes of it.",
                        source,
                        error.what()));
        }
    }

    void
    name_surface(const int entity, const std::string &name)
    {
      const int group = gmsh::model::addPhysicalGroup(2, {entity});
      gmsh::model::setPhysicalName(2, group, name);
    }

    Vector3<double>
    centre_of_surface(const int entity)
    {
      Vector3<double> x;
      gmsh::model::occ::getCenterOfMass(2, entity, x[0], x[1], x[2]);
      return x;
    }

    // Meshes the volumes and improves the cells in steps, the worst first: to
    // ask for the best at once leaves some of the worst as they are. On a
    // cylinder of 60,000 cells this raises the smallest altitude, which limits
    // the time step, from 0.26 to 0.38 of the element size.
    void
    mesh_volumes()
    {
      gmsh::model::mesh::generate(3);
      double optimise = 0, threshold = 0;
      gmsh::option::getNumber("Mesh.Optimize", optimise);
      gmsh::option::getNumber("Mesh.OptimizeThreshold", threshold);
      if (optimise == 0)
        return;
      for (const double quality : {0.5, 0.7})
        if (quality > threshold)
          {
            gmsh::option::setNumber("Mesh.OptimizeThreshold", quality);
            gmsh::model::mesh::optimize("");
          }
    }

    void
    mesh_built_in_shape(const MeshParameters &parameters, const int volume)
    {
      gmsh::model::addPhysicalGroup(3, {volume}, 1);
      gmsh::model::setPhysicalName(3, 1, parameters.material);
      gmsh::option::setNumber("Mesh.MeshSizeMin", parameters.element_size);
      gmsh::option::setNumber("Mesh.MeshSizeMax", parameters.element_size);
      mesh_volumes();
    }

    MeshData
    make_box(const MeshParameters &parameters)
    {
      const auto &size = parameters.box_size;
      return run_gmsh("built-in box", {}, [&]() {
        const int box =
          gmsh::model::occ::addBox(0, 0, 0, size[0], size[1], size[2]);
        gmsh::model::occ::synchronize();
        gmsh::vectorpair surfaces;
        gmsh::model::getEntities(surfaces, 2);
        for (unsigned int d = 0; d < dim; ++d)
          for (const bool upper : {false, true})
            for (const auto &surface : surfaces)
              {
                const double x = centre_of_surface(surface.second)[d] / size[d];
                if (std::abs(x - upper) < 0.25)
                  name_surface(
                    surface.second,
                    fmt::format("{}_{}", "xyz"[d], upper ? "max" : "min"));
              }
        mesh_built_in_shape(parameters, box);
      });
    }

    MeshData
    make_cylinder(const MeshParameters &parameters)
    {
      const double radius = parameters.cylinder_radius;
      const double length = parameters.cylinder_length;
      return run_gmsh("built-in cylinder", {}, [&]() {
        const int cylinder =
          gmsh::model::occ::addCylinder(0, 0, 0, length, 0, 0, radius);
        gmsh::model::occ::synchronize();
        gmsh::vectorpair surfaces;
        gmsh::model::getEntities(surfaces, 2);
        const std::pair<const char *, double> names[] = {{"start", 0},
                                                         {"end", 1},
                                                         {"side", 0.5}};
        for (const auto &name : names)
          for (const auto &surface : surfaces)
            {
              const double x = centre_of_surface(surface.second)[0] / length;
              if (std::abs(x - name.second) < 0.25)
                name_surface(surface.second, name.first);
            }
        mesh_built_in_shape(parameters, cylinder);
      });
    }

    MeshData
    mesh_script(const MeshParameters &parameters)
    {
      std::map<std::string, double> numbers = parameters.geo_parameters;
      if (parameters.element_size > 0 &&
          !numbers.emplace("element_size", parameters.element_size).second)
        throw InputError("The parameter element_size of the gmsh script '" +
                         parameters.file +
                         "' is set twice, as 'Element size' and by name. "
                         "Remove one of them.");

      std::vector<std::string> names;
      for (const auto &number : numbers)
        {
          if (!std::isfinite(number.second))
            throw InputError(
              fmt::format("The parameter '{}' of the gmsh script '{}' is {}. "
                          "Give it a finite number.",
                          number.first,
                          parameters.file,
                          number.second));
          names.push_back(number.first);
        }
      check_geo_parameters(parameters.file, names);

      return run_gmsh(parameters.file, numbers, [&]() {
        gmsh::open(parameters.file);
        // The script may have meshed already or have merged a mesh.
        std::vector<int> types;
        gmsh::model::mesh::getElementTypes(types, 3);
        if (types.empty())
          mesh_volumes();
      });
    }

    MeshData
    read_mesh_file(const MeshParameters &parameters)
    {
      if (parameters.element_size > 0 || !parameters.geo_parameters.empty())
        throw InputError("The mesh file '" + parameters.file +
                         "' is used as it is: 'Element size' and parameters "
                         "by name have no effect on a .msh. Remove them, or "
                         "use a .geo.");
      check_msh_file(parameters.file);
      // A damaged number can make gmsh fill any amount of memory; a good file
      // needs some ten times its size.
      const std::size_t memory_limit =
        (std::size_t(1) << 30) +
        50 * std::filesystem::file_size(parameters.file);
      return run_gmsh(
        parameters.file,
        {},
        [&]() { gmsh::open(parameters.file); },
        memory_limit);
    }
  } // namespace

  MeshData
  read_mesh(const MeshParameters &parameters)
  {
    parameters.check();
    switch (parameters.shape)
      {
      case MeshParameters::Shape::box:
        return make_box(parameters);
      case MeshParameters::Shape::cylinder:
        return make_cylinder(parameters);
      case MeshParameters::Shape::file:
        break;
      }
    return ends_with(parameters.file, ".geo") ? mesh_script(parameters) :
                                                read_mesh_file(parameters);
  }
} // namespace rift
