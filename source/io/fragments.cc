#include <rift/base/output_file.h>
#include <rift/io/fragments.h>

#include <algorithm>
#include <numeric>

namespace rift
{
  namespace
  {
    /** For each cell the first cell of its piece. */
    std::vector<CellIndex>
    first_cells(const Topology &topology)
    {
      std::vector<CellIndex> root(topology.n_cell_slots());
      std::iota(root.begin(), root.end(), CellIndex{0});
      const auto find_root = [&root](CellIndex i) {
        while (root[i] != i)
          i = root[i] = root[root[i]];
        return i;
      };
      for (FaceIndex face = 0; face < topology.faces.size(); ++face)
        if (topology.face_states[face] != FaceState::broken)
          {
            const CellIndex a    = find_root(topology.faces[face].cells[0]);
            const CellIndex b    = find_root(topology.faces[face].cells[1]);
            root[std::max(a, b)] = std::min(a, b);
          }
      for (CellIndex &cell : root)
        cell = find_root(cell);
      return root;
    }

    void
    add_cell(Fragment                           &fragment,
             const Topology                     &topology,
             const CellIndex                     cell,
             const double                        volume,
             const double                        density,
             const State                        &state,
             const std::vector<Vector3<double>> &velocity)
    {
      const double corner_mass = density * volume / n_corners;
      ++fragment.n_cells;
      fragment.volume += volume;
      fragment.mass += density * volume;
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          const NodeIndex node = topology.node(cell, c);
          fragment.centre += corner_mass * state.position(node);
          fragment.velocity += corner_mass * velocity[node];
        }
    }
  } // namespace

  Fragments
  find_fragments(const Topology                     &topology,
                 const ReferenceCellData            &reference,
                 const std::vector<double>          &densities,
                 const State                        &state,
                 const std::vector<Vector3<double>> &velocity)
  {
    const auto                 first = first_cells(topology);
    std::vector<Fragment>      pieces;
    std::vector<std::uint32_t> piece_of_cell(first.size(), invalid_index);
    for (CellIndex cell = 0; cell < first.size(); ++cell)
      {
        if (topology.is_padding(cell))
          continue;
        if (first[cell] == cell)
          {
            piece_of_cell[cell] = static_cast<std::uint32_t>(pieces.size());
            pieces.emplace_back();
          }
        piece_of_cell[cell] = piece_of_cell[first[cell]];
        add_cell(pieces[piece_of_cell[cell]],
                 topology,
                 cell,
                 reference[cell / batch_size].volume[cell % batch_size],
                 densities[topology.material(cell)],
                 state,
                 velocity);
      }
    for (Fragment &piece : pieces)
      {
        piece.centre   = (1 / piece.mass) * piece.centre;
        piece.velocity = (1 / piece.mass) * piece.velocity;
      }

    std::vector<std::uint32_t> order(pieces.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
      return pieces[a].mass > pieces[b].mass;
    });
    Fragments                  result;
    std::vector<std::uint32_t> rank(pieces.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
      {
        rank[order[i]] = i;
        result.list.push_back(pieces[order[i]]);
      }
    result.of_cell = std::move(piece_of_cell);
    for (std::uint32_t &piece : result.of_cell)
      if (piece != invalid_index)
        piece = rank[piece];
    return result;
  }

  void
  write_fragments(const std::string &path, const Fragments &fragments)
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
    for (const Fragment &f : fragments.list)
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
