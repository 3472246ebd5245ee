#include <rift/base/bytes.h>
#include <rift/base/check.h>
#include <rift/base/disjoint_sets.h>
#include <rift/discretization/fragment_labels.h>
#include <rift/discretization/ghost_values.h>

#include <algorithm>
#include <functional>
#include <map>

namespace rift
{
  namespace
  {
    /** Whether a face connects its cells. */
    using Connects = std::function<bool(FaceIndex)>;

    /** Two labels of one piece. */
    using LabelPair = std::array<GlobalCellIndex, 2>;

    /**
     * Labels of all cells as far as this rank can tell: of a face between two
     * ghosts it may not know whether it has failed.
     */
    std::vector<GlobalCellIndex>
    local_labels(const Topology &topology, const Connects &connects)
    {
      DisjointSets sets(topology.n_cell_slots());
      for (FaceIndex face = 0; face < topology.faces.size(); ++face)
        {
          const CellIndex *cells = topology.faces[face].cells;
          if (connects(face) &&
              (topology.owns_cell(cells[0]) || topology.owns_cell(cells[1])))
            sets.unite(cells[0], cells[1]);
        }
      // Slots stand in the order of their global indices.
      std::vector<GlobalCellIndex> labels(topology.n_cell_slots());
      for (CellIndex cell = 0; cell < labels.size(); ++cell)
        labels[cell] = topology.cell_global_indices[sets.find(cell)];
      return labels;
    }

    /** Calls f(owner of the ghost, own cell, face) for each face between a
     * cell of this rank and a ghost, in the order of the faces. */
    template <typename Function>
    void
    for_each_border_face(const Topology &topology, const Function &f)
    {
      for (FaceIndex face = 0; face < topology.faces.size(); ++face)
        {
          const CellIndex *cells = topology.faces[face].cells;
          for (const unsigned int side : {0, 1})
            if (topology.owns_cell(cells[side]) &&
                !topology.owns_cell(cells[1 - side]))
              f(topology.cell_owners[cells[1 - side]], cells[side], face);
        }
    }

    void
    sort_unique(std::vector<LabelPair> &pairs)
    {
      std::sort(pairs.begin(), pairs.end());
      pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    }

    /** Own label and that of the neighbour where a piece leaves the rank. */
    std::vector<LabelPair>
    pairs_at_border(const Topology                     &topology,
                    const Connects                     &connects,
                    const std::vector<GlobalCellIndex> &labels,
                    const Communicator                 &communicator)
    {
      // Both ranks go through the faces between them in the same order.
      std::map<int, std::vector<GlobalCellIndex>> own;
      for_each_border_face(
        topology,
        [&](const int rank, const CellIndex cell, FaceIndex) {
          own[rank].push_back(labels[cell]);
        });
      const auto others = communicator.exchange(own);

      std::vector<LabelPair>     pairs;
      std::map<int, std::size_t> next;
      for_each_border_face(
        topology,
        [&](const int rank, const CellIndex cell, const FaceIndex face) {
          const GlobalCellIndex other = others.at(rank).at(next[rank]++);
          if (connects(face))
            pairs.push_back({{labels[cell], other}});
        });
      sort_unique(pairs);
      return pairs;
    }

    /** For each label of a pair, ascending, the smallest one of its piece. */
    std::vector<LabelPair>
    unite(const std::vector<LabelPair> &pairs)
    {
      std::vector<GlobalCellIndex> labels;
      for (const LabelPair &pair : pairs)
        labels.insert(labels.end(), pair.begin(), pair.end());
      std::sort(labels.begin(), labels.end());
      labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
      const auto position = [&](const GlobalCellIndex label) {
        const auto at = std::lower_bound(labels.begin(), labels.end(), label);
        rift_check(at != labels.end() && *at == label);
        return static_cast<std::uint32_t>(at - labels.begin());
      };
      DisjointSets sets(labels.size());
      for (const auto &[a, b] : pairs)
        sets.unite(position(a), position(b));
      std::vector<LabelPair> result;
      for (std::uint32_t i = 0; i < labels.size(); ++i)
        result.push_back({{labels[i], labels[sets.find(i)]}});
      return result;
    }

    FragmentLabels
    label_pieces(const Topology     &topology,
                 const Communicator &communicator,
                 const Connects     &connects)
    {
      FragmentLabels result{local_labels(topology, connects), {}};
      const auto     pairs =
        pairs_at_border(topology, connects, result.of_cell, communicator);

      std::vector<LabelPair> all_pairs;
      communicator.gather_in_turn(
        to_bytes(pairs),
        [&](const std::string &bytes) {
          const auto more = from_bytes<LabelPair>(bytes);
          all_pairs.insert(all_pairs.end(), more.begin(), more.end());
        });
      std::string bytes = to_bytes(unite(all_pairs));
      communicator.broadcast(bytes);
      const auto final_labels = from_bytes<LabelPair>(bytes);
      const auto final_label  = [&](const GlobalCellIndex label) {
        const auto at = std::lower_bound(final_labels.begin(),
                                         final_labels.end(),
                                         LabelPair{{label, 0}});
        return at != final_labels.end() && (*at)[0] == label ? (*at)[1] : label;
      };

      for (CellIndex cell = 0; cell < result.of_cell.size(); ++cell)
        result.of_cell[cell] = topology.owns_cell(cell) ?
                                 final_label(result.of_cell[cell]) :
                                 invalid_index;
      copy_to_ghosts(communicator, topology, result.of_cell);
      for (const auto &[own, other] : pairs)
        result.divided.push_back(final_label(own));
      std::sort(result.divided.begin(), result.divided.end());
      result.divided.erase(
        std::unique(result.divided.begin(), result.divided.end()),
        result.divided.end());
      return result;
    }
  } // namespace

  FragmentLabels
  label_fragments(const Topology &topology, const Communicator &communicator)
  {
    return label_pieces(topology, communicator, [&](const FaceIndex face) {
      return topology.face_states[face] < FaceState::failed;
    });
  }

  FragmentLabels
  label_bodies(const Topology &topology, const Communicator &communicator)
  {
    return label_pieces(topology, communicator, [](FaceIndex) { return true; });
  }
} // namespace rift
