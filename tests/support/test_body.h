#ifndef rift_tests_support_test_body_h
#define rift_tests_support_test_body_h

#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

/**
 * Bodies for unit tests and benchmarks, made without deal.II and gmsh and with
 * formulas of their own, so that they are a check of the program's.
 */
namespace rift::test
{
  struct Body
  {
    std::vector<LocalCell>       cells;
    std::vector<Vector3<double>> vertices;
  };

  /** A body ready for the solver. */
  struct DiscreteBody
  {
    Topology          topology;
    ReferenceCellData reference;
    State             state;
  };

  inline double
  signed_volume(const Vector3<double> &a,
                const Vector3<double> &b,
                const Vector3<double> &c,
                const Vector3<double> &d)
  {
    return dot(b - a, cross(c - a, d - a)) / 6;
  }

  /** Position along Morton's curve of a point of the unit cube; any order of
   * points outside. */
  inline std::uint64_t
  morton_key(const Vector3<double> &x)
  {
    std::uint64_t key = 0;
    for (int bit = 19; bit >= 0; --bit)
      for (unsigned int d = 0; d < 3; ++d)
        key =
          2 * key + ((static_cast<std::int64_t>(x[d] * (1 << 20)) >> bit) & 1);
    return key;
  }

  /**
   * A box of n[0] x n[1] x n[2] cubes of edge `h`, each of six tetrahedra.
   * Inner vertices are moved by up to `jitter` times the edge at random.
   */
  inline Body
  make_box(const std::array<unsigned int, 3> &n,
           const double                       h      = 1,
           const double                       jitter = 0,
           const unsigned int                 seed   = 1)
  {
    Body                                   body;
    std::mt19937                           random(seed);
    std::uniform_real_distribution<double> offset(-jitter * h, jitter * h);
    const auto index = [&](unsigned int i, unsigned int j, unsigned int k) {
      return (k * (n[1] + 1) + j) * (n[0] + 1) + i;
    };
    for (unsigned int k = 0; k <= n[2]; ++k)
      for (unsigned int j = 0; j <= n[1]; ++j)
        for (unsigned int i = 0; i <= n[0]; ++i)
          {
            const unsigned int ijk[3] = {i, j, k};
            Vector3<double>    x      = {{i * h, j * h, k * h}};
            for (unsigned int d = 0; d < 3; ++d)
              if (ijk[d] > 0 && ijk[d] < n[d])
                x[d] += offset(random);
            body.vertices.push_back(x);
          }

    const unsigned int permutations[6][3] =
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (unsigned int k = 0; k < n[2]; ++k)
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int i = 0; i < n[0]; ++i)
          for (const auto &p : permutations)
            {
              unsigned int at[3] = {i, j, k};
              LocalCell    cell{0, {}, 0};
              cell.vertices[0] = index(at[0], at[1], at[2]);
              for (unsigned int s = 0; s < 3; ++s)
                {
                  ++at[p[s]];
                  cell.vertices[s + 1] = index(at[0], at[1], at[2]);
                }
              const auto &v = body.vertices;
              if (signed_volume(v[cell.vertices[0]],
                                v[cell.vertices[1]],
                                v[cell.vertices[2]],
                                v[cell.vertices[3]]) < 0)
                std::swap(cell.vertices[2], cell.vertices[3]);
              body.cells.push_back(cell);
            }
    return body;
  }

  /** Sorts cells along a curve and numbers vertices by first touch. */
  inline void
  order(Body &body)
  {
    double size = 0;
    for (const auto &x : body.vertices)
      size = std::max({size, x[0], x[1], x[2]});
    const auto key = [&](const LocalCell &cell) {
      Vector3<double> centre = {{0, 0, 0}};
      for (const auto v : cell.vertices)
        centre += (.2 / size) * body.vertices[v];
      return std::make_pair(cell.material, morton_key(centre));
    };
    std::stable_sort(
      body.cells.begin(),
      body.cells.end(),
      [&](const LocalCell &a, const LocalCell &b) { return key(a) < key(b); });
    std::vector<VertexIndex>     new_index(body.vertices.size(), invalid_index);
    std::vector<Vector3<double>> vertices;
    GlobalCellIndex              i = 0;
    for (LocalCell &cell : body.cells)
      {
        cell.global_index = i++;
        for (VertexIndex &v : cell.vertices)
          {
            if (new_index[v] == invalid_index)
              {
                new_index[v] = vertices.size();
                vertices.push_back(body.vertices[v]);
              }
            v = new_index[v];
          }
      }
    body.vertices = vertices;
  }

  /**
   * Gradients, volumes and masses from closed formulas, of a body whose cells
   * are in order() already.
   */
  inline DiscreteBody
  discretize_ordered(const Body                &body,
                     const std::vector<double> &densities,
                     const int                  own_rank = 0,
                     const std::vector<bool>   &parted   = {})
  {
    DiscreteBody result{Topology(body.cells, body.vertices.size(), own_rank),
                        {},
                        {}};
    Topology    &topology = result.topology;
    if (!parted.empty())
      separate_materials(topology, parted);
    result.reference.resize(topology.n_batches(), ReferenceBatch{});
    result.state.resize(topology.n_nodes());
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      {
        if (topology.is_padding(cell))
          continue;
        Vector3<double> x[4];
        for (unsigned int c = 0; c < 4; ++c)
          x[c] = body.vertices[topology.vertex(cell, c)];
        const double volume = signed_volume(x[0], x[1], x[2], x[3]);
        auto        &batch  = result.reference[cell / batch_size];
        const auto   lane   = cell % batch_size;
        batch.volume[lane]  = volume;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto area =
              cross(x[(c + 1) % 3 + 1] - x[0], x[(c + 2) % 3 + 1] - x[0]);
            for (unsigned int d = 0; d < 3; ++d)
              batch.gradients[c][d][lane] = area[d] / (6 * volume);
          }
        for (unsigned int c = 0; c < 4; ++c)
          {
            const NodeIndex node = topology.node(cell, c);
            for (unsigned int d = 0; d < 3; ++d)
              result.state.reference[node][d] = x[c][d];
            result.state.mass[node] +=
              densities[topology.material(cell)] * volume / 4;
          }
      }
    return result;
  }

  inline DiscreteBody
  discretize(Body                       body,
             const std::vector<double> &densities,
             const std::vector<bool>   &parted = {})
  {
    order(body);
    return discretize_ordered(body, densities, 0, parted);
  }
} // namespace rift::test

#endif
