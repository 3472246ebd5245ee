#include <rift/contact/contact_surface.h>
#include <rift/contact/interpenetration.h>
#include <rift/contact/overlap_batch.h>
#include <rift/contact/rendezvous.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rift
{
  namespace
  {
    /** The cells of this rank whose outsides may have met. */
    std::vector<ContactCell>
    surface_cells(const Topology &topology, const State &state, const int rank)
    {
      ContactSurface surface(topology, 0, FaceState::failed);
      surface.look(state, 0);
      std::vector<ContactCell> cells;
      for (const CellIndex cell : surface.cells())
        {
          cells.push_back(surface.describe(state, cell, rank));
          cells.back().constants.body = invalid_index;
        }
      return cells;
    }
  } // namespace

  Interpenetration
  find_interpenetration(const Topology     &topology,
                        const State        &state,
                        const Communicator &communicator)
  {
    // What has no place is the concern of those who watch over the motion.
    const bool is_somewhere = std::all_of(state.displacement.begin(),
                                          state.displacement.end(),
                                          [](const NodalVector &u) {
                                            const Vector3<double> v =
                                              u.vector();
                                            return std::isfinite(dot(v, v));
                                          });
    if (communicator.any(!is_somewhere))
      return {};

    const int  rank = communicator.rank();
    Rendezvous rendezvous(communicator, [rank](const ContactCell &) {
      return std::vector<int>{rank};
    });
    const ContactNeighbourhood found =
      rendezvous.update(surface_cells(topology, state, rank));

    std::vector<PackedMotion> cells;
    for (const ContactCell &cell : found.cells)
      cells.push_back(pack(cell.positions));
    std::vector<CellPair> pairs;
    for (const CellPair &pair : found.pairs)
      if (found.cells[pair.a].owner == rank)
        pairs.push_back(pair);
    const std::vector<CommonPart> parts = common_parts(cells.data(), pairs);

    struct Deepest
    {
      double          part;
      GlobalCellIndex a, b;
      Vector3<double> place;
    };
    const auto is_deeper = [](const Deepest &x, const Deepest &y) {
      return std::make_tuple(-x.part, x.a, x.b) <
             std::make_tuple(-y.part, y.a, y.b);
    };
    Deepest      deepest{0, invalid_index, invalid_index, {}};
    std::int64_t n_pairs = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      {
        const ContactCell &a = found.cells[pairs[i].a],
                          &b = found.cells[pairs[i].b];
        const double part    = parts[i].volume_fraction;
        if (part <= Interpenetration::tolerated_part)
          continue;
        ++n_pairs;
        const Deepest here{part, a.cell, b.cell, a.positions[0]};
        if (is_deeper(here, deepest))
          deepest = here;
      }
    deepest = communicator.first_of_ranks(deepest, is_deeper);
    return {static_cast<std::uint64_t>(communicator.sum(n_pairs)),
            deepest.part,
            deepest.place};
  }
} // namespace rift
