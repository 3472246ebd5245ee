#include <rift/app/body.h>
#include <rift/base/exceptions.h>
#include <rift/base/parameter_text.h>
#include <rift/discretization/discretize.h>
#include <rift/loading/prescribed_motion.h>
#include <rift/mesh/cell_ordering.h>
#include <rift/mesh/face_table.h>
#include <rift/mesh/gmsh_reader.h>
#include <rift/mesh/mesh_buffer.h>
#include <rift/mesh/mesh_checks.h>
#include <rift/mesh/triangulation.h>

#include <algorithm>
#include <array>
#include <set>

namespace rift
{
  namespace
  {
    template <typename Named>
    std::vector<std::string>
    names_of(const std::vector<Named> &list)
    {
      std::vector<std::string> names;
      for (const Named &entry : list)
        names.push_back(entry.name);
      return names;
    }

    bool
    contains(const std::vector<std::string> &list, const std::string &name)
    {
      return std::find(list.begin(), list.end(), name) != list.end();
    }

    /** That a subsection of the scene can have the name of a material. */
    void
    check_name(const std::string &name, const MeshData &mesh)
    {
      if (const std::string problem = name_problem(name); !problem.empty())
        throw InputError("the mesh " + mesh.source + " has the material \"" +
                         excerpt(name) + "\": " + problem +
                         ". Rename the physical volume.");
    }

    /** That the .prm and the mesh speak of the same materials. */
    void
    check_materials(const Parameters &parameters, const MeshData &mesh)
    {
      const auto known = names_of(parameters.materials);
      for (const std::string &name : mesh.material_names)
        check_name(name, mesh);
      for (const std::string &name : mesh.material_names)
        if (!contains(known, name))
          throw InputError(
            "the mesh " + mesh.source + " has the material \"" + name +
            "\", but the scene has no subsection \"Material " + name + "\"." +
            suggestion(name, known) +
            " Add the subsection, or rename the physical volume.");
      for (const std::string &name : known)
        if (!contains(mesh.material_names, name))
          throw InputError("subsection \"Material " + name +
                           "\" belongs to no physical volume of the mesh " +
                           mesh.source + "." +
                           suggestion(name, mesh.material_names));
    }

    /** The names of parts of the outer surface, not of joints. */
    std::vector<std::string>
    boundary_names(const MeshData &mesh)
    {
      std::vector<std::string> names;
      for (const NamedFace &face : mesh.boundary_faces)
        if (!contains(names, mesh.surface_names[face.name]))
          names.push_back(mesh.surface_names[face.name]);
      return names;
    }

    /** A surface of the mesh that a subsection of the scene speaks of. */
    struct UsedSurface
    {
      std::string subsection, name;
    };

    std::vector<UsedSurface>
    used_surfaces(const Parameters &parameters)
    {
      std::vector<UsedSurface> result;
      for (const BoundaryParameters &boundary : parameters.boundaries)
        result.push_back({"Boundary " + boundary.name, boundary.name});
      for (const ProbeParameters &probe : parameters.probes)
        if (!probe.boundary.empty())
          result.push_back({"Probe " + probe.name, probe.boundary});
      return result;
    }

    std::size_t
    count_faces(const std::vector<NamedFace> &faces,
                const std::string            &name,
                const MeshData               &mesh)
    {
      return std::count_if(faces.begin(), faces.end(), [&](const NamedFace &f) {
        return mesh.surface_names[f.name] == name;
      });
    }

    /** Between which materials the inner faces of this name lie. */
    std::string
    place_of_inner_faces(const std::string &name, const MeshData &mesh)
    {
      const FaceTable          faces(mesh);
      std::vector<std::string> places;
      for (const NamedFace &face : mesh.internal_faces)
        {
          if (mesh.surface_names[face.name] != name)
            continue;
          std::array<VertexIndex, 3> corners;
          for (unsigned int c = 0; c < 3; ++c)
            corners[c] =
              mesh.cells[face.cell][face_corners[face.local_face][c]];
          std::set<std::string> materials;
          for (const FaceTable::Side &side : faces.find(corners))
            materials.insert(
              "\"" + mesh.material_names[mesh.cell_materials[side.cell]] +
              "\"");
          const std::string place =
            materials.size() > 1 ?
              "between " + *materials.begin() + " and " + *materials.rbegin() :
              "within " + *materials.begin();
          if (!contains(places, place))
            places.push_back(place);
        }
      return enumeration(places, "and");
    }

    /** That a surface that the .prm speaks of is an outer one. */
    void
    check_surface(const UsedSurface &used, const MeshData &mesh)
    {
      const std::string &name = used.name;
      if (count_faces(mesh.boundary_faces, name, mesh) > 0)
        return;
      const std::string start = "subsection \"" + used.subsection +
                                "\" speaks of the boundary \"" + name + "\", ";
      if (const auto n = count_faces(mesh.internal_faces, name, mesh))
        throw InputError(
          start + "whose " + std::to_string(n) + " faces in the mesh " +
          mesh.source + " all lie inside the body, " +
          place_of_inner_faces(name, mesh) +
          ": only outer surfaces can be loaded, held or probed. Take one of "
          "these, or mesh the two sides apart, with a small gap between them, "
          "such as 1e-6 m (in gmsh without Coherence and BooleanFragments), "
          "and let them meet by contact.");
      throw InputError(
        start + "which the mesh " + mesh.source + " does not have." +
        suggestion(name,
                   boundary_names(mesh),
                   "None of its outer surfaces has a name. Give them names in "
                   "gmsh: Physical Surface(\"" +
                     name + "\") = {...};"));
    }

    /** Warns of names that outer and inner faces have. */
    void
    warn_of_inner_faces(const Parameters &parameters,
                        const MeshData   &mesh,
                        Log              &log)
    {
      for (const UsedSurface &used : used_surfaces(parameters))
        if (const auto n = count_faces(mesh.internal_faces, used.name, mesh))
          log.warn(
            "subsection \"" + used.subsection + "\" uses the " +
            std::to_string(count_faces(mesh.boundary_faces, used.name, mesh)) +
            " outer faces of \"" + used.name + "\" alone, and not the " +
            std::to_string(n) + " that lie inside the body, " +
            place_of_inner_faces(used.name, mesh));
    }

    /** That what moves a rigid body stands with its material. */
    void
    check_rigid_boundaries(const Parameters &parameters, const MeshData &mesh)
    {
      for (const NamedFace &face : mesh.boundary_faces)
        for (const BoundaryParameters &boundary : parameters.boundaries)
          for (const MaterialParameters &material : parameters.materials)
            if (PrescribedMotion::is_needed(boundary) && material.is_rigid() &&
                boundary.name == mesh.surface_names[face.name] &&
                material.name ==
                  mesh.material_names[mesh.cell_materials[face.cell]])
              throw InputError(
                "subsection \"Boundary " + boundary.name +
                "\" prescribes a velocity on the rigid material \"" +
                material.name + "\". Prescribe it in subsection \"Material " +
                material.name + "\", for the whole body.");
    }

    /** What all ranks have to know of a mesh: its names and named faces. */
    MeshData
    share_names(const MeshData &mesh, const Communicator &communicator)
    {
      MeshData names       = mesh;
      names.vertices       = {};
      names.cells          = {};
      names.cell_tags      = {};
      names.cell_materials = {};
      std::string bytes    = pack_mesh(names);
      communicator.broadcast(bytes);
      return unpack_mesh(bytes);
    }

    void
    check_number_of_ranks(const MeshData &mesh, const int n_ranks)
    {
      if (mesh.cells.size() < static_cast<std::size_t>(n_ranks))
        throw InputError("the mesh " + mesh.source + " has " +
                         std::to_string(mesh.cells.size()) +
                         " cells, too few for " + std::to_string(n_ranks) +
                         " ranks. Start rift on fewer ranks.");
    }

    std::map<std::string, Surface>
    find_surfaces(const Topology               &topology,
                  const MeshData               &names,
                  const std::vector<NamedFace> &faces)
    {
      std::map<std::string, Surface> surfaces;
      for (std::size_t i = 0; i < names.surface_names.size(); ++i)
        surfaces[names.surface_names[i]] =
          find_surface(topology, faces, static_cast<std::uint16_t>(i));
      return surfaces;
    }

    /** "0.1 x 0.02 x 0.02 m" */
    std::string
    extent_text(const MeshData &mesh)
    {
      std::string text;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const auto [least, largest] = std::minmax_element(
            mesh.vertices.begin(),
            mesh.vertices.end(),
            [d](const auto &a, const auto &b) { return a[d] < b[d]; });
          text +=
            (d > 0 ? " x " : "") + short_text((*largest)[d] - (*least)[d]);
        }
      return text + " m";
    }

    /** Says what the mesh is. Collective. */
    void
    describe(const Body     &body,
             const MeshData &mesh,
             const bool      is_parted,
             Log            &log)
    {
      const std::size_t n_nodes =
        body.communicator.sum(body.discretization.topology.n_owned_nodes());
      if (!body.communicator.is_root())
        return;
      const auto list = [](const std::vector<std::string> &names) {
        std::string text;
        for (const std::string &name : names)
          text += (text.empty() ? "" : ", ") + name;
        return text.empty() ? std::string("none") : text;
      };
      if (n_nodes > mesh.vertices.size() && !is_parted)
        log.write("Pieces that touch by an edge or a vertex alone are not "
                  "connected there: " +
                  std::to_string(n_nodes - mesh.vertices.size()) +
                  " nodes have been doubled");
      log.write("Mesh " + mesh.source + ": " + extent_text(mesh) + ", " +
                std::to_string(mesh.cells.size()) + " cells, " +
                std::to_string(n_nodes) +
                " nodes; materials: " + list(mesh.material_names) +
                "; boundaries: " + list(boundary_names(mesh)));
    }

    /** Velocities at the start: of each cell's material, weighted by mass. */
    void
    set_initial_velocity(Body &body)
    {
      const Topology &topology = body.discretization.topology;
      State          &state    = body.discretization.state;
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        {
          const auto &material    = body.materials[topology.material(cell)];
          const Vector3<double> v = material.initial_velocity;
          if (topology.is_padding(cell) || dot(v, v) == 0)
            continue;
          const double corner_mass =
            material.density *
            body.discretization.reference[cell / batch_size]
              .volume[cell % batch_size] /
            n_corners;
          for (unsigned int c = 0; c < n_corners; ++c)
            {
              const NodeIndex node = topology.node(cell, c);
              for (unsigned int d = 0; d < dim; ++d)
                state.velocity[node][d] +=
                  corner_mass / state.mass[node] * v[d];
            }
        }
    }
  } // namespace

  MeshData
  make_mesh(const Parameters &parameters, const Communicator &communicator)
  {
    MeshData mesh;
    communicator.on_root([&] {
      mesh = read_mesh(parameters.mesh);
      check_mesh(mesh);
      check_materials(parameters, mesh);
      for (const UsedSurface &used : used_surfaces(parameters))
        check_surface(used, mesh);
      check_rigid_boundaries(parameters, mesh);
      order_cells(mesh);
    });
    return mesh;
  }

  Body
  make_body(const Parameters       &parameters,
            const MeshData         &mesh,
            const std::vector<int> &owners,
            const Communicator     &communicator,
            Log                    &log)
  {
    communicator.on_root(
      [&] { check_number_of_ranks(mesh, communicator.size()); });
    const MeshData names = share_names(mesh, communicator);
    Body           body{communicator,
              {communicator, Topology({}, 0), {}, {}, {}, {}, {}},
              {},
              {},
              {},
              {},
              {}};
    for (const std::string &name : names.material_names)
      for (const MaterialParameters &material : parameters.materials)
        if (material.name == name)
          body.materials.push_back(material);

    for (const MaterialParameters &material : body.materials)
      {
        body.laws.push_back(make_elasticity(material));
        body.stiffnesses.push_back(stiffness_matrix(body.laws.back()));
      }

    std::vector<bool> parted;
    if (parameters.cohesive.model == CohesiveParameters::Model::intrinsic)
      for (const MaterialParameters &material : body.materials)
        parted.push_back(material.breakable);
    body.discretization =
      discretize(*make_triangulation(mesh, owners, communicator.mpi()),
                 densities_of(body.materials),
                 communicator,
                 parted);
    const Topology &topology = body.discretization.topology;
    body.surfaces = find_surfaces(topology, names, names.boundary_faces);
    body.internal_surfaces =
      find_surfaces(topology, names, names.internal_faces);
    set_initial_velocity(body);
    describe(body, mesh, !parted.empty(), log);
    if (communicator.is_root())
      warn_of_inner_faces(parameters, mesh, log);
    return body;
  }
} // namespace rift
