#ifndef rift_tests_support_random_cuts_h
#define rift_tests_support_random_cuts_h

#include <rift/mesh/mesh_data.h>
#include <rift/mesh/node_splitter.h>

#include "test_body.h"
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

/**
 * Bodies of random shape, random cuts through them, and an oracle of what the
 * cuts part that knows nothing of rift's topology.
 */
namespace rift::test
{
  using CellVertices = std::vector<std::array<VertexIndex, n_corners>>;
  using Triangle     = std::array<VertexIndex, 3>;

  /** Corners, given by 4 * cell + corner, that share a node have one name. */
  using Partition = std::vector<std::size_t>;

  /** Names by first appearance, so that equal partitions are equal vectors. */
  inline Partition
  canonical(const Partition &names)
  {
    std::map<std::size_t, std::size_t> order;
    Partition                          result;
    for (const std::size_t name : names)
      result.push_back(order.emplace(name, order.size()).first->second);
    return result;
  }

  inline CellVertices
  vertices_of_cells(const std::vector<LocalCell> &cells)
  {
    CellVertices result;
    for (const LocalCell &cell : cells)
      result.push_back(cell.vertices);
    return result;
  }

  /** The vertices of the real cells, in ascending order of their slots. */
  inline CellVertices
  vertices_of_cells(const Topology &topology)
  {
    CellVertices result;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (!topology.is_padding(cell))
        {
          result.push_back({});
          for (unsigned int c = 0; c < n_corners; ++c)
            result.back()[c] = topology.vertex(cell, c);
        }
    return result;
  }

  /**
   * The oracle. Every corner of every cell starts as a node of its own; cells
   * that have three vertices in common that are no cut triangle share their
   * nodes there; that is repeated until nothing changes.
   */
  inline Partition
  brute_force_partition(const CellVertices       &cells,
                        const std::set<Triangle> &cuts)
  {
    std::map<Triangle, std::vector<std::size_t>> triangles;
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      for (unsigned int f = 0; f < n_corners; ++f)
        {
          Triangle t = {{cells[cell][(f + 1) % 4],
                         cells[cell][(f + 2) % 4],
                         cells[cell][(f + 3) % 4]}};
          std::sort(t.begin(), t.end());
          triangles[t].push_back(cell);
        }
    const auto corner = [&](const std::size_t cell, const VertexIndex vertex) {
      const auto &v = cells[cell];
      return 4 * cell + (std::find(v.begin(), v.end(), vertex) - v.begin());
    };

    Partition names(4 * cells.size());
    std::iota(names.begin(), names.end(), std::size_t{0});
    for (bool has_changed = true; has_changed;)
      {
        has_changed = false;
        for (const auto &[triangle, sides] : triangles)
          if (sides.size() == 2 && cuts.count(triangle) == 0)
            for (const VertexIndex vertex : triangle)
              {
                std::size_t &a = names[corner(sides[0], vertex)];
                std::size_t &b = names[corner(sides[1], vertex)];
                has_changed |= a != b;
                a = b = std::min(a, b);
              }
      }
    return canonical(names);
  }

  inline Partition
  partition_of(const Topology &topology)
  {
    Partition names;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < n_corners && !topology.is_padding(cell); ++c)
        names.push_back(topology.node(cell, c));
    return canonical(names);
  }

  inline Triangle
  triangle_of(const Topology &topology, const FaceIndex face)
  {
    const Face &f = topology.faces[face];
    Triangle    t;
    for (unsigned int c = 0; c < 3; ++c)
      t[c] = topology.vertex(f.cells[0], face_corners[f.local_faces[0]][c]);
    std::sort(t.begin(), t.end());
    return t;
  }

  /** The interior faces all of whose vertices have x = `x`. */
  inline std::vector<FaceIndex>
  faces_in_plane(const DiscreteBody &body, const double x)
  {
    std::vector<FaceIndex> faces;
    for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
      {
        const Triangle t = triangle_of(body.topology, face);
        if (std::all_of(t.begin(), t.end(), [&](const VertexIndex v) {
              return std::abs(body.state.reference[v][0] - x) < 1e-12;
            }))
          faces.push_back(face);
      }
    return faces;
  }

  /**
   * A box from which cells have been removed at random, so that its surface
   * has every shape, with two materials and the corners of each cell in random
   * order. Where cells only touch, they get a vertex each.
   */
  inline Body
  random_body(std::mt19937 &random)
  {
    const auto pick = [&](unsigned int n) {
      return static_cast<unsigned int>(random() % n);
    };
    Body body =
      make_box({{1 + pick(3), 1 + pick(3), 1 + pick(3)}}, 1, .2, random());
    const unsigned int percent = pick(40);
    for (std::size_t i = body.cells.size(); i-- > 0;)
      if (body.cells.size() > 2 && pick(100) < percent)
        body.cells.erase(body.cells.begin() + i);
    for (LocalCell &cell : body.cells)
      {
        cell.material = pick(2);
        // Three corners turn around a fourth: the volume stays positive.
        const unsigned int          fixed = pick(4);
        std::array<unsigned int, 3> turning;
        for (unsigned int c = 0, i = 0; c < 4; ++c)
          if (c != fixed)
            turning[i++] = c;
        auto &v = cell.vertices;
        for (unsigned int turns = pick(3); turns > 0; --turns)
          {
            std::swap(v[turning[0]], v[turning[1]]);
            std::swap(v[turning[1]], v[turning[2]]);
          }
      }

    const Partition names =
      brute_force_partition(vertices_of_cells(body.cells), {});
    std::vector<Vector3<double>> vertices(
      *std::max_element(names.begin(), names.end()) + 1);
    for (std::size_t corner = 0; corner < names.size(); ++corner)
      {
        VertexIndex &vertex     = body.cells[corner / 4].vertices[corner % 4];
        vertices[names[corner]] = body.vertices[vertex];
        vertex                  = names[corner];
      }
    body.vertices = vertices;
    return body;
  }

  /** Of the two materials, kg/m^3. */
  const std::vector<double> densities = {2641., 1234.};

  /** Cuts faces, and has the state and its masses follow. */
  inline TopologyChange
  cut(DiscreteBody &body, std::vector<FaceIndex> faces)
  {
    std::sort(faces.begin(), faces.end());
    const TopologyChange change = split_nodes(body.topology, faces);
    EXPECT_EQ(change.cut_faces, faces);
    body.state.grow(change);
    for (const NodeSplit &split : change.splits)
      for (const NodeIndex part : split.parts)
        body.state.mass[part] =
          lumped_mass(body.topology, body.reference, densities, part);
    return change;
  }

  /** Cuts faces in the order given, as many at a time as `random` says. */
  inline void
  cut_in_several_calls(DiscreteBody                 &body,
                       const std::vector<FaceIndex> &faces,
                       std::mt19937                 &random)
  {
    for (std::size_t i = 0; i < faces.size();)
      {
        const std::size_t n =
          std::min<std::size_t>(1 + random() % 12, faces.size() - i);
        cut(body, {faces.begin() + i, faces.begin() + i + n});
        i += n;
      }
  }

  inline std::vector<FaceIndex>
  shuffled_faces(const Topology &topology, std::mt19937 &random)
  {
    std::vector<FaceIndex> faces(topology.faces.size());
    std::iota(faces.begin(), faces.end(), 0);
    std::shuffle(faces.begin(), faces.end(), random);
    return faces;
  }

  /** Gives all nodes a random displacement and velocity. */
  inline void
  move_at_random(State &state, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> value(-1, 1);
    for (std::size_t i = 0; i < state.n_nodes(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        {
          state.displacement[i][d] = value(random);
          state.velocity[i][d]     = value(random);
        }
  }
} // namespace rift::test

#endif
