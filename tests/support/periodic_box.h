#ifndef rift_tests_support_periodic_box_h
#define rift_tests_support_periodic_box_h

#include "test_body.h"

#include <map>

namespace rift::test
{
  /**
   * A box of n[0] x n[1] x n[2] cubes of edge h, as make_box(), that goes on
   * periodically along y and z: its sides there share their nodes. At least
   * three cubes along each, so that no two cells have the same nodes.
   */
  inline DiscreteBody
  make_periodic_box(const std::array<unsigned int, 3> &n,
                    const double                       h,
                    const double                       density)
  {
    Body body = make_box(n, h);
    order(body);

    // The number of each vertex once images are the same.
    std::vector<VertexIndex>                   number;
    std::vector<Vector3<double>>               vertices;
    std::map<std::array<long, 3>, VertexIndex> by_place;
    for (Vector3<double> x : body.vertices)
      {
        std::array<long, 3> place;
        for (unsigned int d = 0; d < 3; ++d)
          {
            place[d] = std::lround(x[d] / h);
            if (d > 0 && place[d] == static_cast<long>(n[d]))
              place[d] = 0;
            x[d] = place[d] * h;
          }
        const auto [at, is_new] = by_place.emplace(place, vertices.size());
        number.push_back(at->second);
        if (is_new)
          vertices.push_back(x);
      }

    ReferenceCellData reference = discretize_ordered(body, {density}).reference;
    for (LocalCell &cell : body.cells)
      for (VertexIndex &v : cell.vertices)
        v = number[v];
    DiscreteBody result{Topology(body.cells, vertices.size()),
                        std::move(reference),
                        {}};
    result.state.resize(vertices.size());
    for (NodeIndex node = 0; node < vertices.size(); ++node)
      {
        for (unsigned int d = 0; d < dim; ++d)
          result.state.reference[node][d] = vertices[node][d];
        result.state.mass[node] =
          lumped_mass(result.topology, result.reference, {density}, node);
      }
    return result;
  }
} // namespace rift::test

#endif
