#include <rift/base/bytes.h>
#include <rift/base/exact_sum.h>
#include <rift/base/output_file.h>
#include <rift/io/fragment_labels.h>
#include <rift/io/fragments.h>

#include <algorithm>
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
    sorted_cells(const FragmentLabels &labels)
    {
      std::vector<std::pair<GlobalCellIndex, CellIndex>> cells;
      for (CellIndex cell = 0; cell < labels.of_cell.size(); ++cell)
        if (labels.of_cell[cell] != invalid_index)
          cells.emplace_back(labels.of_cell[cell], cell);
      std::sort(cells.begin(), cells.end());
      return cells;
    }

    /** Sums the `n` numbers `terms(cell)` over each fragment on this rank. */
    template <std::size_t n, typename Terms>
    Contributions<n>
    contributions(const FragmentLabels &labels, const Terms &terms)
    {
      Contributions<n> result;
      const auto       cells = sorted_cells(labels);
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

    /**
     * The sums over all ranks, by mass, the largest first, and then by label;
     * on rank 0. Collective.
     *
     * @param mass index of the mass among the sums.
     */
    template <std::size_t n>
    std::vector<FragmentSums<double, n>>
    collect(const Contributions<n> &own,
            const std::size_t       mass,
            const Communicator     &communicator)
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

      std::sort(result.begin(), result.end(), [mass](auto &a, auto &b) {
        return std::make_pair(-a.sums[mass], a.label) <
               std::make_pair(-b.sums[mass], b.label);
      });
      return result;
    }

    double
    volume_of(const ReferenceCellData &reference, const CellIndex cell)
    {
      return reference[cell / batch_size].volume[cell % batch_size];
    }
  } // namespace

  std::vector<std::uint32_t>
  number_fragments(const Topology            &topology,
                   const ReferenceCellData   &reference,
                   const std::vector<double> &densities,
                   const Communicator        &communicator)
  {
    const FragmentLabels labels = label_fragments(topology, communicator);
    const auto           mass   = [&](const CellIndex cell) {
      return std::array<double, 1>{
        {densities[topology.material(cell)] * volume_of(reference, cell)}};
    };
    std::vector<GlobalCellIndex> in_order;
    for (const auto &fragment :
         collect(contributions<1>(labels, mass), 0, communicator))
      in_order.push_back(fragment.label);
    std::string bytes = to_bytes(in_order);
    communicator.broadcast(bytes);

    std::unordered_map<GlobalCellIndex, std::uint32_t> numbers;
    for (const GlobalCellIndex label : from_bytes<GlobalCellIndex>(bytes))
      numbers.emplace(label, numbers.size());
    std::vector<std::uint32_t> result;
    for (const GlobalCellIndex label : labels.of_cell)
      result.push_back(label == invalid_index ? invalid_index :
                                                numbers.at(label));
    return result;
  }

  std::vector<Fragment>
  list_fragments(const Topology                     &topology,
                 const ReferenceCellData            &reference,
                 const std::vector<double>          &densities,
                 const State                        &state,
                 const std::vector<Vector3<double>> &velocity,
                 const Communicator                 &communicator)
  {
    // Number of cells, volume, mass, moment and momentum.
    const auto terms = [&](const CellIndex cell) {
      const double    volume   = volume_of(reference, cell);
      const double    mass     = densities[topology.material(cell)] * volume;
      Vector3<double> position = {{0, 0, 0}}, speed = {{0, 0, 0}};
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          const NodeIndex node = topology.node(cell, c);
          position += state.position(node);
          speed += velocity[node];
        }
      const Vector3<double> moment   = (mass / n_corners) * position;
      const Vector3<double> momentum = (mass / n_corners) * speed;
      return std::array<double, 9>{{1,
                                    volume,
                                    mass,
                                    moment[0],
                                    moment[1],
                                    moment[2],
                                    momentum[0],
                                    momentum[1],
                                    momentum[2]}};
    };
    const FragmentLabels  labels = label_fragments(topology, communicator);
    std::vector<Fragment> list;
    for (const auto &fragment :
         collect(contributions<9>(labels, terms), 2, communicator))
      {
        const auto &s = fragment.sums;
        list.push_back({static_cast<std::size_t>(s[0]),
                        s[1],
                        s[2],
                        {{s[3] / s[2], s[4] / s[2], s[5] / s[2]}},
                        {{s[6] / s[2], s[7] / s[2], s[8] / s[2]}}});
      }
    return list;
  }

  void
  write_fragments(const std::string           &path,
                  const std::vector<Fragment> &fragments)
  {
    HistoryFile file(path,
                     {"fragment",
                      "cells",
                      "volume [m^3]",
                      "mass [kg]",
                      "x [m]",
                      "y [m]",
                      "z [m]",
                      "velocity x [m/s]",
                      "velocity y [m/s]",
                      "velocity z [m/s]"});
    double      number = 0;
    for (const Fragment &f : fragments)
      file.append({number++,
                   static_cast<double>(f.n_cells),
                   f.volume,
                   f.mass,
                   f.centre[0],
                   f.centre[1],
                   f.centre[2],
                   f.velocity[0],
                   f.velocity[1],
                   f.velocity[2]});
    file.flush();
  }
} // namespace rift
