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
    std::vector<ContactCell>
    surface_cells(const Topology &topology, const State &state, const int rank)
    {
      ContactSurface surface(topology);
      const auto     is_held = [&](const FaceIndex face) {
        return topology.face_states[face] < FaceState::failed;
      };
      for (FaceIndex face = 0; face < topology.faces.size(); ++face)
        if (!is_held(face))
          surface.include(face);
      std::vector<ContactCell> cells;
      for (const CellIndex cell : surface.cells())
        {
          cells.push_back(surface.describe(cell, rank, is_held));
          cells.back().constants = {0, 0, invalid_index};
          cells.back().motion    = motion_of(topology, state, cell);
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
      rendezvous.search(surface_cells(topology, state, rank), 0);

    std::vector<PackedMotion> cells;
    for (const ContactCell &cell : found.cells)
      cells.push_back(pack(cell.motion));
    std::vector<CellPair> pairs;
    for (const BoxPair &pair : found.pairs)
      if (found.cells[pair.first].owner == rank)
        pairs.push_back({pair.first, pair.second});
    const std::vector<CommonPart> parts = common_parts(cells, pairs);

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
        const Deepest here{part, a.cell, b.cell, a.motion.positions[0]};
        if (is_deeper(here, deepest))
          deepest = here;
      }
    deepest = communicator.first_of_ranks(deepest, is_deeper);
    return {static_cast<std::uint64_t>(communicator.sum(n_pairs)),
            deepest.part,
            deepest.place};
  }
} // namespace rift
