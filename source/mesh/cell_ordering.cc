#include <rift/mesh/cell_ordering.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace rift
{
  namespace
  {
    // deal.II stretches the bounding box of the points to a cube, and a curve
    // through a long body would then be cut into long parts. With two more
    // points, at which there is no cell, the box is a cube before.
    void
    append_corners_of_cube(std::vector<dealii::Point<dim>> &points)
    {
      const dealii::BoundingBox<dim> box(points);
      double                         edge = 0;
      for (unsigned int d = 0; d < dim; ++d)
        edge = std::max(edge, box.side_length(d));
      dealii::Point<dim> first = box.get_boundary_points().first, last = first;
      for (unsigned int d = 0; d < dim; ++d)
        last[d] += edge;
      points.push_back(first);
      points.push_back(last);
    }

    // The index that the new order has at each place.
    std::vector<GlobalCellIndex>
    sort_cells(const MeshData &mesh)
    {
      std::vector<dealii::Point<dim>> centres(mesh.cells.size());
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        for (const VertexIndex v : mesh.cells[c])
          for (unsigned int d = 0; d < dim; ++d)
            centres[c][d] += 0.25 * mesh.vertices[v][d];
      append_corners_of_cube(centres);
      const auto place_on_curve =
        dealii::Utilities::inverse_Hilbert_space_filling_curve(centres);

      std::vector<GlobalCellIndex> order(mesh.cells.size());
      std::iota(order.begin(), order.end(), 0);
      const auto key = [&](const GlobalCellIndex &c) {
        return std::tie(mesh.cell_materials[c], place_on_curve[c], c);
      };
      std::sort(order.begin(),
                order.end(),
                [&](const GlobalCellIndex a, const GlobalCellIndex b) {
                  return key(a) < key(b);
                });
      return order;
    }

    template <typename T>
    void
    permute(std::vector<T> &data, const std::vector<GlobalCellIndex> &order)
    {
      std::vector<T> result;
      result.reserve(order.size());
      for (const GlobalCellIndex c : order)
        result.push_back(data[c]);
      data = std::move(result);
    }

    void
    renumber_vertices(MeshData &mesh)
    {
      std::vector<VertexIndex> new_index(mesh.vertices.size(), invalid_index);
      std::vector<Vector3<double>> vertices;
      vertices.reserve(mesh.vertices.size());
      for (auto &cell : mesh.cells)
        for (VertexIndex &v : cell)
          {
            if (new_index[v] == invalid_index)
              {
                new_index[v] = static_cast<VertexIndex>(vertices.size());
                vertices.push_back(mesh.vertices[v]);
              }
            v = new_index[v];
          }
      mesh.vertices = std::move(vertices);
    }

    void
    renumber_faces(std::vector<NamedFace>             &faces,
                   const std::vector<GlobalCellIndex> &new_index)
    {
      for (NamedFace &face : faces)
        face.cell = new_index[face.cell];
      std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
        return std::tie(a.cell, a.local_face, a.name) <
               std::tie(b.cell, b.local_face, b.name);
      });
    }
  } // namespace

  void
  order_cells(MeshData &mesh)
  {
    const std::vector<GlobalCellIndex> order = sort_cells(mesh);
    permute(mesh.cells, order);
    permute(mesh.cell_tags, order);
    permute(mesh.cell_materials, order);
    renumber_vertices(mesh);

    std::vector<GlobalCellIndex> new_index(order.size());
    for (std::size_t c = 0; c < order.size(); ++c)
      new_index[order[c]] = static_cast<GlobalCellIndex>(c);
    renumber_faces(mesh.boundary_faces, new_index);
    renumber_faces(mesh.internal_faces, new_index);
  }
} // namespace rift
