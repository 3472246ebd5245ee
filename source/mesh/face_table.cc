#include <rift/mesh/face_table.h>

#include <algorithm>
#include <tuple>

namespace rift
{
  namespace
  {
    // Sorts three vertices and tells whether it took an odd permutation.
    bool
    sort_corners(std::array<VertexIndex, 3> &v)
    {
      bool       odd  = false;
      const auto swap = [&](const unsigned int i, const unsigned int j) {
        if (v[j] < v[i])
          {
            std::swap(v[i], v[j]);
            odd = !odd;
          }
      };
      swap(0, 1);
      swap(1, 2);
      swap(0, 1);
      return odd;
    }

    auto
    key(const FaceTable::Side &side)
    {
      return std::tie(side.middle, side.largest, side.cell, side.local_face);
    }
  } // namespace

  FaceTable::FaceTable(const MeshData &mesh)
    : begin_of_vertex(mesh.vertices.size() + 1, 0)
    , sides(n_corners * mesh.cells.size())
  {
    const auto corners_of = [&](const std::size_t c, const unsigned int f) {
      const auto &cell = mesh.cells[c];
      const auto &face = face_corners[f];
      return std::array<VertexIndex, 3>{
        {cell[face[0]], cell[face[1]], cell[face[2]]}};
    };

    // A bucket for each smallest vertex: a sort of everything takes several
    // times as long.
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (unsigned int f = 0; f < n_corners; ++f)
        {
          const auto v = corners_of(c, f);
          ++begin_of_vertex[*std::min_element(v.begin(), v.end()) + 1];
        }
    for (std::size_t v = 0; v + 1 < begin_of_vertex.size(); ++v)
      begin_of_vertex[v + 1] += begin_of_vertex[v];

    std::vector<std::size_t> next(begin_of_vertex);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
      for (unsigned int f = 0; f < n_corners; ++f)
        {
          auto       v        = corners_of(c, f);
          const bool odd      = sort_corners(v);
          sides[next[v[0]]++] = {v[1],
                                 v[2],
                                 static_cast<GlobalCellIndex>(c),
                                 static_cast<std::uint8_t>(f),
                                 odd};
        }
    for (std::size_t v = 0; v + 1 < begin_of_vertex.size(); ++v)
      std::sort(sides.begin() + begin_of_vertex[v],
                sides.begin() + begin_of_vertex[v + 1],
                [](const Side &a, const Side &b) { return key(a) < key(b); });
  }

  FaceTable::Range
  FaceTable::find(std::array<VertexIndex, 3> v) const
  {
    sort_corners(v);
    if (v[0] >= n_vertices())
      return {nullptr, nullptr};
    const auto range = faces_of(v[0]);
    const auto first = std::find_if(range.begin(), range.end(), [&](auto &s) {
      return s.middle == v[1] && s.largest == v[2];
    });
    const auto last  = std::find_if(first, range.end(), [&](auto &s) {
      return s.middle != v[1] || s.largest != v[2];
    });
    return {first, last};
  }
} // namespace rift
