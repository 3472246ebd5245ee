#include <rift/base/checked_cast.h>
#include <rift/base/exceptions.h>
#include <rift/base/parameter_text.h>
#include <rift/mesh/face_table.h>
#include <rift/mesh/gmsh_model.h>

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <tuple>
#include <unordered_map>

namespace rift
{
  namespace
  {
    // gmsh's numbers for types of elements.
    constexpr int triangle    = 2;
    constexpr int tetrahedron = 4;

    constexpr const char *kinds[] = {"point", "curve", "surface", "volume"};

    using Tags = std::vector<std::size_t>;

    // The named physical groups of one dimension.
    struct Names
    {
      std::vector<std::string>               names;
      std::unordered_map<int, std::uint16_t> index_of_tag;
      std::map<std::string, int>             tag_of_name;
    };

    // The elements of one geometric entity, all of one type.
    struct Elements
    {
      int  entity;
      int  type;
      Tags tags, nodes;
    };

    // Adds the name of a group, with its blanks as those of a scene: none at
    // the ends and no two in a row.
    void
    add_name(Names             &names,
             const int          dimension,
             const int          tag,
             const std::string &name,
             const std::string &source)
    {
      const std::string simple      = simplified(name);
      const auto [other, is_unique] = names.tag_of_name.emplace(simple, tag);
      if (!is_unique)
        throw InputError(
          fmt::format("{}: the physical {}s {} and {} have the same name '{}'; "
                      "blanks at its ends and doubled ones do not count. "
                      "Rename one of them, or make one group of both.",
                      source,
                      kinds[dimension],
                      other->second,
                      tag,
                      simple));
      names.index_of_tag[tag] =
        checked_cast<std::uint16_t>(names.names.size(),
                                    "physical groups of one dimension");
      names.names.push_back(simple);
    }

    Names
    read_names(const int dimension, const std::string &source)
    {
      gmsh::vectorpair groups;
      gmsh::model::getPhysicalGroups(groups, dimension);
      std::sort(groups.begin(), groups.end());

      Names result;
      for (const auto &group : groups)
        {
          std::string name;
          gmsh::model::getPhysicalName(dimension, group.second, name);
          if (simplified(name).empty())
            throw InputError(
              fmt::format("{}: unnamed region: physical {} {} has no name of "
                          "its own. Give it one in "
                          "gmsh: Physical {}(\"name\", {}) = ...;",
                          source,
                          kinds[dimension],
                          group.second,
                          dimension == 3 ? "Volume" : "Surface",
                          group.second));
          add_name(result, dimension, group.second, name, source);
        }
      return result;
    }

    // The physical group of an entity, or nothing (-1).
    int
    physical_group(const int          dimension,
                   const int          entity,
                   const std::string &source)
    {
      std::vector<int> groups;
      gmsh::model::getPhysicalGroupsForEntity(dimension, entity, groups);
      if (groups.size() > 1)
        throw InputError(
          fmt::format("{}: {} {} belongs to the physical groups {} and {}, but "
                      "only one name can be given. Remove it from the others.",
                      source,
                      kinds[dimension],
                      entity,
                      std::abs(groups[0]),
                      std::abs(groups[1])));
      // The sign only tells an orientation.
      return groups.empty() ? -1 : std::abs(groups[0]);
    }

    std::vector<Elements>
    read_elements(const int dimension)
    {
      gmsh::vectorpair entities;
      gmsh::model::getEntities(entities, dimension);
      std::sort(entities.begin(), entities.end());

      std::vector<Elements> result;
      for (const auto &entity : entities)
        {
          std::vector<int>  types;
          std::vector<Tags> tags, nodes;
          gmsh::model::mesh::getElements(types,
                                         tags,
                                         nodes,
                                         dimension,
                                         entity.second);
          for (std::size_t i = 0; i < types.size(); ++i)
            result.push_back({entity.second,
                              types[i],
                              std::move(tags[i]),
                              std::move(nodes[i])});
        }
      return result;
    }

    void
    check_type(const Elements    &elements,
               const int          type,
               const std::string &source)
    {
      if (elements.type == type)
        return;
      std::string         name;
      int                 dimension, order, n_nodes, n_primary_nodes;
      std::vector<double> coordinates;
      gmsh::model::mesh::getElementProperties(elements.type,
                                              name,
                                              dimension,
                                              order,
                                              n_nodes,
                                              coordinates,
                                              n_primary_nodes);
      throw InputError(fmt::format(
        "{}: element {} of {} {} is of type '{}' (order {}, {} nodes), but "
        "rift computes with {} of first order. {}",
        source,
        elements.tags.front(),
        kinds[dimension],
        elements.entity,
        name,
        order,
        n_nodes,
        dimension == 3 ? "4-node tetrahedra" : "3-node triangles",
        order > 1 ? "Set Mesh.ElementOrder = 1." :
                    "Remove Recombine, Layers and the like from the mesh."));
    }

    // The nodes of the cells become vertices, in ascending order of tags.
    class VertexNumbering
    {
    public:
      explicit VertexNumbering(const std::vector<Elements> &volumes)
      {
        for (const auto &elements : volumes)
          tags.insert(tags.end(), elements.nodes.begin(), elements.nodes.end());
        std::sort(tags.begin(), tags.end());
        tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
        tags.shrink_to_fit();
        checked_cast<VertexIndex>(tags.size(), "nodes of the mesh");

        index_of_tag.reserve(tags.size());
        for (std::size_t i = 0; i < tags.size(); ++i)
          index_of_tag[tags[i]] = static_cast<VertexIndex>(i);
      }

      VertexIndex
      operator[](const std::size_t tag) const
      {
        const auto it = index_of_tag.find(tag);
        return it == index_of_tag.end() ? invalid_index : it->second;
      }

      Tags tags;

    private:
      std::unordered_map<std::size_t, VertexIndex> index_of_tag;
    };

    std::vector<Vector3<double>>
    read_vertices(const VertexNumbering &numbering, const std::string &source)
    {
      std::vector<Vector3<double>> vertices(numbering.tags.size());
      std::vector<bool>            found(vertices.size(), false);
      for (int dimension = 0; dimension <= 3; ++dimension)
        {
          Tags                tags;
          std::vector<double> x, parametric;
          gmsh::model::mesh::getNodes(tags,
                                      x,
                                      parametric,
                                      dimension,
                                      -1,
                                      false,
                                      false);
          for (std::size_t i = 0; i < tags.size(); ++i)
            {
              const VertexIndex v = numbering[tags[i]];
              if (v != invalid_index)
                {
                  vertices[v] = {{x[3 * i], x[3 * i + 1], x[3 * i + 2]}};
                  found[v]    = true;
                }
              else if (dimension == 3 && ends_with(source, ".msh"))
                throw InputError(fmt::format(
                  "{}: orphan node {} at ({:g}, {:g}, {:g}) lies in a volume, "
                  "but no cell uses it. Remove it, or mesh again.",
                  source,
                  tags[i],
                  x[3 * i],
                  x[3 * i + 1],
                  x[3 * i + 2]));
            }
        }
      const auto missing = std::find(found.begin(), found.end(), false);
      if (missing != found.end())
        throw InputError(
          fmt::format("{}: node {} has no coordinates, but a cell uses it. The "
                      "file is damaged: write it again.",
                      source,
                      numbering.tags[missing - found.begin()]));
      return vertices;
    }

    void
    orient(std::array<VertexIndex, n_corners> &cell,
           const std::vector<Vector3<double>> &vertices)
    {
      const auto edge = [&](const unsigned int i) {
        return vertices[cell[i]] - vertices[cell[0]];
      };
      if (dot(edge(1), cross(edge(2), edge(3))) < 0)
        std::swap(cell[2], cell[3]);
    }

    void
    add_cells(MeshData                    &mesh,
              const std::vector<Elements> &volumes,
              const VertexNumbering       &numbering)
    {
      const Names materials = read_names(3, mesh.source);
      mesh.material_names   = materials.names;
      for (const auto &elements : volumes)
        {
          const int group = physical_group(3, elements.entity, mesh.source);
          if (group < 0)
            throw InputError(fmt::format(
              "{}: unnamed region: volume {} (cell {}) belongs to no physical "
              "volume, so it has no material. Give it one in gmsh: Physical "
              "Volume(\"name\") = {{{}}};",
              mesh.source,
              elements.entity,
              elements.tags.front(),
              elements.entity));
          for (std::size_t c = 0; c < elements.tags.size(); ++c)
            {
              std::array<VertexIndex, n_corners> cell;
              for (unsigned int i = 0; i < n_corners; ++i)
                cell[i] = numbering[elements.nodes[n_corners * c + i]];
              orient(cell, mesh.vertices);
              mesh.cells.push_back(cell);
              mesh.cell_tags.push_back(elements.tags[c]);
              mesh.cell_materials.push_back(materials.index_of_tag.at(group));
            }
        }
    }

    void
    add_face(MeshData                         &mesh,
             const FaceTable                  &faces,
             const std::array<std::size_t, 3> &nodes,
             const VertexNumbering            &numbering,
             const std::size_t                 tag,
             const std::uint16_t               name)
    {
      const FaceTable::Range sides = faces.find(
        {{numbering[nodes[0]], numbering[nodes[1]], numbering[nodes[2]]}});
      if (sides.size() == 0)
        throw InputError(fmt::format(
          "{}: triangle {} of the surface '{}' (nodes {}, {}, {}) is no face "
          "of "
          "any cell. Make the surface part of the volumes (BooleanFragments, "
          "Coherence or Surface{{...}} In Volume{{...}}) or take its name "
          "away.",
          mesh.source,
          tag,
          mesh.surface_names[name],
          nodes[0],
          nodes[1],
          nodes[2]));
      const NamedFace face = {sides.first->cell, sides.first->local_face, name};
      (sides.size() == 1 ? mesh.boundary_faces : mesh.internal_faces)
        .push_back(face);
    }

    // Sorts by cell and face and lets each face have one name only.
    void
    tidy_up(std::vector<NamedFace> &faces, const MeshData &mesh)
    {
      const auto key = [](const NamedFace &f) {
        return std::make_tuple(f.cell, f.local_face, f.name);
      };
      std::sort(faces.begin(), faces.end(), [&](auto &a, auto &b) {
        return key(a) < key(b);
      });
      faces.erase(
        std::unique(faces.begin(),
                    faces.end(),
                    [&](auto &a, auto &b) { return key(a) == key(b); }),
        faces.end());
      for (std::size_t i = 1; i < faces.size(); ++i)
        if (faces[i].cell == faces[i - 1].cell &&
            faces[i].local_face == faces[i - 1].local_face)
          throw InputError(
            fmt::format("{}: face {} of cell {} belongs to the surfaces '{}' "
                        "and '{}', but only one name can be given.",
                        mesh.source,
                        faces[i].local_face,
                        mesh.cell_tags[faces[i].cell],
                        mesh.surface_names[faces[i - 1].name],
                        mesh.surface_names[faces[i].name]));
    }

    void
    add_faces(MeshData &mesh, const VertexNumbering &numbering)
    {
      const Names surfaces = read_names(2, mesh.source);
      mesh.surface_names   = surfaces.names;
      if (surfaces.names.empty())
        return;

      const FaceTable faces(mesh);
      for (const auto &elements : read_elements(2))
        {
          const int group = physical_group(2, elements.entity, mesh.source);
          if (group < 0)
            continue;
          check_type(elements, triangle, mesh.source);
          for (std::size_t t = 0; t < elements.tags.size(); ++t)
            add_face(mesh,
                     faces,
                     {{elements.nodes[3 * t],
                       elements.nodes[3 * t + 1],
                       elements.nodes[3 * t + 2]}},
                     numbering,
                     elements.tags[t],
                     surfaces.index_of_tag.at(group));
        }
      tidy_up(mesh.boundary_faces, mesh);
      tidy_up(mesh.internal_faces, mesh);
    }
  } // namespace

  MeshData
  extract_mesh(const std::string &source)
  {
    const std::vector<Elements> volumes = read_elements(3);
    if (volumes.empty())
      throw InputError(
        fmt::format("{}: there are no cells. Define a volume, and write the "
                    "3-D mesh, not the 2-D one.",
                    source));
    std::size_t n_cells = 0;
    for (const auto &elements : volumes)
      {
        check_type(elements, tetrahedron, source);
        n_cells += elements.tags.size();
      }
    checked_cast<GlobalCellIndex>(n_cells, "cells of the mesh");

    MeshData mesh;
    mesh.source = source;
    const VertexNumbering numbering(volumes);
    mesh.vertices = read_vertices(numbering, source);
    add_cells(mesh, volumes, numbering);
    add_faces(mesh, numbering);
    return mesh;
  }
} // namespace rift
