#ifndef rift_tests_support_single_cell_h
#define rift_tests_support_single_cell_h

#include "elastic_body.h"

namespace rift::test
{
  /** A body of one tetrahedron. */
  inline Body
  make_cell(const std::array<Vector3<double>, 4> &corners)
  {
    Body body;
    body.vertices.assign(corners.begin(), corners.end());
    body.cells = {{0, {{0, 1, 2, 3}}, 0}};
    if (signed_volume(corners[0], corners[1], corners[2], corners[3]) < 0)
      std::swap(body.cells[0].vertices[2], body.cells[0].vertices[3]);
    // order() wants points of positive coordinates.
    for (auto &x : body.vertices)
      x += Vector3<double>{{10, 10, 10}};
    return body;
  }

  /** The regular tetrahedron of edge 1. */
  inline Body
  make_regular_cell()
  {
    return make_cell({{{{0, 0, 0}},
                       {{1, 0, 0}},
                       {{.5, std::sqrt(3.) / 2, 0}},
                       {{.5, std::sqrt(3.) / 6, std::sqrt(2. / 3)}}}});
  }

  /** A tetrahedron of any shape but quite flat ones. */
  inline Body
  make_random_cell(Random &random)
  {
    while (true)
      {
        std::array<Vector3<double>, 4> corners;
        double                         longest = 0;
        for (auto &x : corners)
          x = random_matrix(random)[0];
        for (const auto &x : corners)
          for (const auto &y : corners)
            longest = std::max(longest, norm(x - y));
        const double volume =
          signed_volume(corners[0], corners[1], corners[2], corners[3]);
        if (std::abs(volume) > .01 * std::pow(longest, 3))
          return make_cell(corners);
      }
  }
} // namespace rift::test

#endif
