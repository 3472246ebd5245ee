#include <rift/base/exceptions.h>
#include <rift/contact/contact_search.h>
#include <rift/contact/separation.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** So many boxes touch another one only when bodies have collapsed. */
    constexpr std::size_t largest_pairs_per_cell = 200;

    Vector3<double>
    lower_corner_of_common_box(const Box &a, const Box &b)
    {
      Vector3<double> corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = std::max(a.lower[d], b.lower[d]);
      return corner;
    }
  } // namespace

  Box
  box_around(const Tetrahedron &t, const double margin)
  {
    Box box{t[0], t[0]};
    for (const Vector3<double> &x : t)
      for (unsigned int d = 0; d < dim; ++d)
        {
          box.lower[d] = std::min(box.lower[d], x[d]);
          box.upper[d] = std::max(box.upper[d], x[d]);
        }
    for (unsigned int d = 0; d < dim; ++d)
      {
        box.lower[d] -= margin;
        box.upper[d] += margin;
      }
    return box;
  }

  std::vector<BoxPair>
  find_candidates(const std::vector<ContactCell> &cells,
                  const double                    skin,
                  const SpaceDivision            &division,
                  const int                       rank)
  {
    std::vector<Box>        boxes;
    std::vector<FacePlanes> planes;
    boxes.reserve(cells.size());
    planes.reserve(cells.size());
    for (const ContactCell &cell : cells)
      {
        boxes.push_back(box_around(cell.motion.positions, skin / 2));
        planes.emplace_back(cell.motion.positions);
      }
    const std::size_t limit = largest_pairs_per_cell * cells.size();
    const auto pairs = find_touching(boxes, limit, [&](const BoxPair &pair) {
      const ContactCell &a = cells[pair.first], &b = cells[pair.second];
      return !are_bonded(a, b) &&
             division.rank_of(lower_corner_of_common_box(boxes[pair.first],
                                                         boxes[pair.second])) ==
               rank &&
             planes[pair.first].distance_to(b.motion.positions) <= skin &&
             planes[pair.second].distance_to(a.motion.positions) <= skin;
    });
    if (!pairs)
      throw RunError("contact: the " + std::to_string(cells.size()) +
                     " cells at surfaces have more than " +
                     std::to_string(limit) +
                     " pairs that may touch. Bodies lie in each other, or "
                     "cells of very different size meet: look at the last "
                     "results in ParaView.");
    return *pairs;
  }
} // namespace rift
