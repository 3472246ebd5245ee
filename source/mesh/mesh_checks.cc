#include <rift/base/exceptions.h>
#include <rift/mesh/face_table.h>
#include <rift/mesh/mesh_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    std::string
    print(const Vector3<double> &x)
    {
      return fmt::format("({:g}, {:g}, {:g})", x[0], x[1], x[2]);
    }

    Vector3<double>
    centre(const MeshData &mesh, const std::size_t cell)
    {
      Vector3<double> sum = {{0, 0, 0}};
      for (const VertexIndex v : mesh.cells[cell])
        sum += mesh.vertices[v];
      return 0.25 * sum;
    }

    // A cell by its tag and position.
    std::string
    print_cell(const MeshData &mesh, const std::size_t cell)
    {
      return fmt::format("cell {} at {}",
                         mesh.cell_tags[cell],
                         print(centre(mesh, cell)));
    }

    // The first cell that uses a vertex.
    std::size_t
    cell_of_vertex(const MeshData &mesh, const VertexIndex vertex)
    {
      const auto cell = std::find_if(
        mesh.cells.begin(),
        mesh.cells.end(),
        [&](const auto &corners) {
          return std::count(corners.begin(), corners.end(), vertex) > 0;
        });
      return cell - mesh.cells.begin();
    }

    void
    check_regions(const MeshData &mesh)
    {
      if (mesh.cells.empty())
        throw InputError(mesh.source + ": there are no cells. Define a volume "
                                       "and mesh it in 3-D.");
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        if (mesh.cell_materials[c] >= mesh.material_names.size() ||
            mesh.material_names[mesh.cell_materials[c]].empty())
          throw InputError(
            fmt::format("{}: unnamed region: cell {} belongs to volume number "
                        "{}, which has no name. Name it by a physical volume.",
                        mesh.source,
                        mesh.cell_tags[c],
                        mesh.cell_materials[c]));
    }

    void
    check_vertices(const MeshData &mesh)
    {
      std::vector<bool> used(mesh.vertices.size(), false);
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        for (const VertexIndex v : mesh.cells[c])
          {
            if (v >= mesh.vertices.size())
              throw InputError(
                fmt::format("{}: cell {} uses vertex {}, but there are only {} "
                            "vertices. Write the mesh again.",
                            mesh.source,
                            mesh.cell_tags[c],
                            v,
                            mesh.vertices.size()));
            used[v] = true;
            for (const double x : mesh.vertices[v])
              if (!std::isfinite(x))
                throw InputError(
                  fmt::format("{}: a corner of cell {} is at {}, which is no "
                              "point in space. Write the mesh again.",
                              mesh.source,
                              mesh.cell_tags[c],
                              print(mesh.vertices[v])));
          }
      const auto orphan = std::find(used.begin(), used.end(), false);
      if (orphan != used.end())
        throw InputError(
          fmt::format("{}: orphan vertex {} at {}: no cell uses it. Remove it.",
                      mesh.source,
                      orphan - used.begin(),
                      print(mesh.vertices[orphan - used.begin()])));
    }

    void
    check_volumes(const MeshData &mesh)
    {
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        {
          const auto corner = [&](const unsigned int i) {
            return mesh.vertices[mesh.cells[c][i]];
          };
          double longest_edge = 0;
          for (unsigned int i = 0; i < n_corners; ++i)
            for (unsigned int j = 0; j < i; ++j)
              longest_edge =
                std::max(longest_edge, norm(corner(i) - corner(j)));
          const double volume =
            dot(corner(1) - corner(0),
                cross(corner(2) - corner(0), corner(3) - corner(0))) /
            6;
          const double cube = std::pow(longest_edge, 3);
          if (!(volume > smallest_relative_volume * cube))
            throw InputError(
              fmt::format("{}: {} has the volume {:g} m3, with a longest edge "
                          "of {:g} m: it "
                          "is flat or inside out. Mesh again with optimisation "
                          "(Mesh.Optimize = 1) or another element size.",
                          mesh.source,
                          print_cell(mesh, c),
                          volume,
                          longest_edge));
        }
    }

    // A vertex in one of the small boxes into which space is divided.
    struct BoxEntry
    {
      std::uint64_t box;
      VertexIndex   vertex;

      bool
      operator<(const BoxEntry &other) const
      {
        return std::tie(box, vertex) < std::tie(other.box, other.vertex);
      }
    };

    // All vertices in all boxes that they touch within the tolerance.
    std::vector<BoxEntry>
    sort_into_boxes(const MeshData        &mesh,
                    const Vector3<double> &origin,
                    const double           tolerance)
    {
      // So wide that a vertex is rarely near the border of its box.
      const double          width = 1000 * tolerance;
      std::vector<BoxEntry> entries;
      entries.reserve(mesh.vertices.size() + mesh.vertices.size() / 8);
      for (VertexIndex v = 0; v < mesh.vertices.size(); ++v)
        {
          const Vector3<double> x        = mesh.vertices[v] - origin;
          std::array<double, 3> range[2] = {};
          for (unsigned int d = 0; d < dim; ++d)
            {
              range[0][d] = std::floor((x[d] - tolerance) / width);
              range[1][d] = std::floor((x[d] + tolerance) / width);
            }
          for (double i = range[0][0]; i <= range[1][0]; ++i)
            for (double j = range[0][1]; j <= range[1][1]; ++j)
              for (double k = range[0][2]; k <= range[1][2]; ++k)
                {
                  // A hash: boxes that share it only cost a comparison.
                  std::uint64_t box = 0;
                  for (const double index : {i, j, k})
                    {
                      box ^= static_cast<std::uint64_t>(
                        static_cast<std::int64_t>(index));
                      box *= 0x9e3779b97f4a7c15u;
                      box ^= box >> 29;
                    }
                  entries.push_back({box, v});
                }
        }
      std::sort(entries.begin(), entries.end());
      return entries;
    }

    void
    check_coincidence(const MeshData &mesh)
    {
      Vector3<double> lower = mesh.vertices[0], upper = lower;
      for (const auto &x : mesh.vertices)
        for (unsigned int d = 0; d < dim; ++d)
          {
            lower[d] = std::min(lower[d], x[d]);
            upper[d] = std::max(upper[d], x[d]);
          }
      const double tolerance = coincidence_tolerance * norm(upper - lower);

      const auto entries = sort_into_boxes(mesh, lower, tolerance);
      for (std::size_t i = 0; i < entries.size(); ++i)
        for (std::size_t j = i; j-- > 0 && entries[j].box == entries[i].box;)
          {
            const VertexIndex a = entries[j].vertex, b = entries[i].vertex;
            if (norm(mesh.vertices[a] - mesh.vertices[b]) <= tolerance)
              throw InputError(fmt::format(
                "{}: two vertices are at the same position {}, one of cell {} "
                "and one of cell {}: the body would be torn there. Merge them "
                "in gmsh (Coherence Mesh, or BooleanFragments before meshing), "
                "or leave a gap, such as 1e-6 m, between bodies that touch by "
                "contact alone.",
                mesh.source,
                print(mesh.vertices[a]),
                mesh.cell_tags[cell_of_vertex(mesh, a)],
                mesh.cell_tags[cell_of_vertex(mesh, b)]));
          }
    }

    VertexIndex
    opposite_corner(const MeshData &mesh, const FaceTable::Side &side)
    {
      return mesh.cells[side.cell][side.local_face];
    }

    void
    check_pair(const MeshData        &mesh,
               const FaceTable::Side &a,
               const FaceTable::Side &b)
    {
      if (opposite_corner(mesh, a) == opposite_corner(mesh, b))
        throw InputError(
          fmt::format("{}: {} is there twice, again as cell {}. Remove one of "
                      "them.",
                      mesh.source,
                      print_cell(mesh, a.cell),
                      mesh.cell_tags[b.cell]));
      if (a.odd == b.odd)
        throw InputError(fmt::format("{}: {} and {} lie on the same side of "
                                     "the face that they share, so "
                                     "they overlap. Mesh again.",
                                     mesh.source,
                                     print_cell(mesh, a.cell),
                                     print_cell(mesh, b.cell)));
    }

    void
    check_faces(const MeshData &mesh)
    {
      const FaceTable faces(mesh);
      const auto      same_face = [](const auto &a, const auto &b) {
        return a.middle == b.middle && a.largest == b.largest;
      };
      for (VertexIndex v = 0; v < faces.n_vertices(); ++v)
        {
          const auto sides = faces.faces_of(v);
          for (std::size_t i = 1; i < sides.size(); ++i)
            {
              const auto *side = sides.begin() + i;
              if (!same_face(side[0], side[-1]))
                continue;
              if (i + 1 < sides.size() && same_face(side[0], side[1]))
                throw InputError(fmt::format(
                  "{}: {}, {} and {} share one face, but a face has "
                  "only two sides. Mesh again.",
                  mesh.source,
                  print_cell(mesh, side[-1].cell),
                  print_cell(mesh, side[0].cell),
                  print_cell(mesh, side[1].cell)));
              check_pair(mesh, side[-1], side[0]);
            }
        }
    }
  } // namespace

  void
  check_mesh(const MeshData &mesh)
  {
    check_regions(mesh);
    check_vertices(mesh);
    check_volumes(mesh);
    check_coincidence(mesh);
    check_faces(mesh);
  }
} // namespace rift
