#include <rift/base/bytes.h>
#include <rift/base/exact_sum.h>
#include <rift/discretization/fragment_labels.h>
#include <rift/discretization/fragments.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace rift
{
  namespace
  {
    /** Sums over the cells of a fragment, or over those of a rank. */
    template <typename Number, std::size_t n>
    struct FragmentSums
    {
      GlobalCellIndex       label;
      std::array<Number, n> sums;
    };

    /** What one rank knows: fragments that it has to itself, and its parts of
     * the others. */
    template <std::size_t n>
    struct Contributions
    {
      std::vector<FragmentSums<double, n>>           whole;
      std::vector<FragmentSums<ExactSum::Digits, n>> divided;
    };

    /** The cells of this rank, those of a fragment after each other. */
    std::vector<std::pair<GlobalCellIndex, CellIndex>>
    sorted_cells(const Topology &topology, const FragmentLabels &labels)
    {
      std::vector<std::pair<GlobalCellIndex, CellIndex>> cells;
      for (CellIndex cell = 0; cell < labels.of_cell.size(); ++cell)
        if (topology.owns_cell(cell))
          cells.emplace_back(labels.of_cell[cell], cell);
      std::sort(cells.begin(), cells.end());
      return cells;
    }

    /** Sums the `n` numbers `terms(cell)` over each fragment on this rank. */
    template <std::size_t n, typename Terms>
    Contributions<n>
    contributions(const Topology       &topology,
                  const FragmentLabels &labels,
                  const Terms          &terms)
    {
      Contributions<n> result;
      const auto       cells = sorted_cells(topology, labels);
      for (auto cell = cells.begin(); cell != cells.end();)
        {
          const GlobalCellIndex   label = cell->first;
          std::array<ExactSum, n> sums;
          for (; cell != cells.end() && cell->first == label; ++cell)
            {
              const std::array<double, n> more = terms(cell->second);
              for (std::size_t i = 0; i < n; ++i)
                sums[i].add(more[i]);
            }
          if (std::binary_search(labels.divided.begin(),
                                 labels.divided.end(),
                                 label))
            {
              result.divided.push_back({label, {}});
              for (std::size_t i = 0; i < n; ++i)
                result.divided.back().sums[i] = sums[i].digits();
            }
          else
            {
              result.whole.push_back({label, {}});
              for (std::size_t i = 0; i < n; ++i)
                result.whole.back().sums[i] = sums[i].value();
            }
        }
      return result;
    }

    /** The sums over all ranks; on rank 0. Collective. */
    template <std::size_t n>
    std::vector<FragmentSums<double, n>>
    collect(const Contributions<n> &own, const Communicator &communicator)
    {
      std::vector<FragmentSums<double, n>> result;
      communicator.gather_in_turn(
        to_bytes(own.whole),
        [&](const std::string &bytes) {
          const auto more = from_bytes<FragmentSums<double, n>>(bytes);
          result.insert(result.end(), more.begin(), more.end());
        });

      std::map<GlobalCellIndex, std::array<ExactSum, n>> divided;
      communicator.gather_in_turn(
        to_bytes(own.divided),
        [&](const std::string &bytes) {
          for (const auto &part :
               from_bytes<FragmentSums<ExactSum::Digits, n>>(bytes))
            for (std::size_t i = 0; i < n; ++i)
              divided[part.label][i].add(ExactSum::from_digits(part.sums[i]));
        });
      for (const auto &[label, sums] : divided)
        {
          result.push_back({label, {}});
          for (std::size_t i = 0; i < n; ++i)
            result.back().sums[i] = sums[i].value();
        }
      return result;
    }

    /** A piece and how it is known. */
    struct LabelledFragment
    {
      GlobalCellIndex label, body;
      Fragment        fragment;
    };

    // Places of the sums over the cells of a piece.
    enum
    {
      n_cells,
      volume,
      mass,
      moment,
      displacement = moment + dim,
      momentum     = displacement + dim,
      body_label   = momentum + dim,
      n_sums
    };
    using Terms = std::array<double, n_sums>;

    /** Adds the mean over the corners of a cell, times its mass. */
    template <typename Value>
    void
    add_mean(Terms             &terms,
             const unsigned int first,
             const Topology    &topology,
             const CellIndex    cell,
             const Value       &value)
    {
      Vector3<double> sum{};
      for (unsigned int c = 0; c < n_corners; ++c)
        sum += value(topology.node(cell, c));
      for (unsigned int d = 0; d < dim; ++d)
        terms[first + d] = terms[mass] / n_corners * sum[d];
    }

    Vector3<double>
    mean(const Terms &sums, const unsigned int first)
    {
      Vector3<double> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = sums[first + d] / sums[mass];
      return result;
    }

    /** The pieces in the order of Fragments::list. */
    std::vector<LabelledFragment>
    in_order(const std::vector<FragmentSums<double, n_sums>> &sums)
    {
      std::vector<LabelledFragment> result;
      for (const auto &[label, of] : sums)
        {
          Fragment fragment;
          fragment.n_cells      = static_cast<std::uint64_t>(of[n_cells]);
          fragment.volume       = of[volume];
          fragment.mass         = of[mass];
          fragment.centre       = mean(of, moment);
          fragment.displacement = mean(of, displacement);
          fragment.velocity     = mean(of, momentum);
          result.push_back(
            {label, static_cast<GlobalCellIndex>(of[body_label]), fragment});
        }
      std::sort(result.begin(), result.end(), [](auto &a, auto &b) {
        return std::make_pair(-a.fragment.mass, a.label) <
               std::make_pair(-b.fragment.mass, b.label);
      });
      std::unordered_map<GlobalCellIndex, std::uint32_t> main_pieces;
      for (std::uint32_t i = 0; i < result.size(); ++i)
        result[i].fragment.main_piece =
          main_pieces.emplace(result[i].body, i).first->second;
      return result;
    }
  } // namespace

  bool
  Fragments::has_left(const std::uint32_t fragment) const
  {
    const Fragment       &piece = list[fragment];
    const Vector3<double> shift =
      piece.displacement - list[piece.main_piece].displacement;
    return piece.main_piece != fragment &&
           norm(shift) > std::cbrt(piece.volume);
  }

  Fragments
  find_fragments(const Topology                     &topology,
                 const ReferenceCellData            &reference,
                 const std::vector<double>          &densities,
                 const std::vector<GlobalCellIndex> &bodies,
                 const State                        &state,
                 const std::vector<Vector3<double>> &velocity,
                 const Communicator                 &communicator)
  {
    const FragmentLabels labels   = label_fragments(topology, communicator);
    const auto           terms_of = [&](const CellIndex cell) {
      Terms terms{};
      terms[n_cells] = 1;
      terms[volume] = reference[cell / batch_size].volume[cell % batch_size];
      terms[mass] = densities[topology.material(cell)] * terms[volume];
      const auto add = [&](const unsigned int first, const auto &value) {
        add_mean(terms, first, topology, cell, value);
      };
      add(moment, [&](const NodeIndex n) { return state.position(n); });
      add(displacement,
          [&](const NodeIndex n) { return state.displacement[n].vector(); });
      add(momentum, [&](const NodeIndex n) { return velocity[n]; });
      // Only the first cell of a piece, whose index is its label, adds this:
      // the sum is the label of the body.
      if (topology.cell_global_indices[cell] == labels.of_cell[cell])
        terms[body_label] = bodies[cell];
      return terms;
    };
    const auto  own   = contributions<n_sums>(topology, labels, terms_of);
    std::string bytes = to_bytes(in_order(collect(own, communicator)));
    communicator.broadcast(bytes);

    Fragments                                          result;
    std::unordered_map<GlobalCellIndex, std::uint32_t> numbers;
    for (const auto &piece : from_bytes<LabelledFragment>(bytes))
      {
        numbers.emplace(piece.label, result.list.size());
        result.list.push_back(piece.fragment);
      }
    for (const GlobalCellIndex label : labels.of_cell)
      result.of_cell.push_back(label == invalid_index ? invalid_index :
                                                        numbers.at(label));
    return result;
  }
} // namespace rift
