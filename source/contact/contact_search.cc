#include <rift/base/exceptions.h>
#include <rift/contact/broad_phase.h>
#include <rift/contact/contact_search.h>

#include <algorithm>
#include <cstring>

namespace rift
{
  namespace
  {
    /** So many boxes touch another one only when bodies have collapsed. */
    constexpr std::size_t largest_pairs_per_cell = 200;

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
  } // namespace

  std::vector<ContactCandidate>
  find_candidates(const std::vector<ContactCell> &cells, const double skin)
  {
    std::vector<Box> boxes;
    boxes.reserve(cells.size());
    for (const ContactCell &cell : cells)
      boxes.push_back(box_around(cell.motion.positions, skin / 2));
    const std::size_t limit = largest_pairs_per_cell * cells.size();
    const auto        pairs = find_touching(boxes, limit);
    if (pairs.size() > limit)
      throw RunError("contact: the " + std::to_string(cells.size()) +
                     " cells at surfaces have more than " +
                     std::to_string(limit) +
                     " pairs that may touch. Bodies lie in each other, or "
                     "cells of very different size meet: look at the last "
                     "results in ParaView.");

    std::vector<ContactCandidate> candidates;
    for (const BoxPair &pair : pairs)
      {
        const ContactCell &a = cells[pair.first], &b = cells[pair.second];
        if (!are_bonded(a, b) &&
            separation(a.motion.positions, b.motion.positions) <= skin)
          candidates.push_back({pair.first, pair.second});
      }
    return candidates;
  }

  std::vector<ContactCell>
  gather_cells(const std::vector<ContactCell> &own,
               const Communicator             &communicator)
  {
    if (communicator.size() == 1)
      return own;
    std::vector<ContactCell> all;
    for (const std::string &bytes :
         communicator.all_gather({reinterpret_cast<const char *>(own.data()),
                                  own.size() * sizeof(ContactCell)}))
      {
        const std::size_t n_before = all.size();
        all.resize(n_before + bytes.size() / sizeof(ContactCell));
        if (!bytes.empty())
          std::memcpy(&all[n_before], bytes.data(), bytes.size());
      }
    std::sort(all.begin(),
              all.end(),
              [](const ContactCell &a, const ContactCell &b) {
                return a.cell < b.cell;
              });
    return all;
  }
} // namespace rift
