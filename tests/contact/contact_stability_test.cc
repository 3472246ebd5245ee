// That contact adds no more to the squares of frequencies than it may, and not
// much less.

#include <rift/contact/contact_pair.h>
#include <rift/contact/contact_penalty.h>
#include <rift/contact/known_face_states.h>
#include <rift/solid/cell_frequency.h>

#include "../support/single_pair.h"
#include "released_faces.h"
#include <gtest/gtest.h>

#include <random>

using namespace rift;
using namespace rift::test;

namespace
{
  constexpr double density = 2700;

  /** A symmetric matrix for the displacements of nodes. */
  class NodalMatrix
  {
  public:
    explicit NodalMatrix(const std::vector<double> &masses)
      : n(3 * masses.size())
      , entries(n * n)
      , masses(masses)
    {
    }

    double &
    operator()(const NodeIndex    i,
               const unsigned int c,
               const NodeIndex    j,
               const unsigned int d)
    {
      return entries[(3 * i + c) * n + 3 * j + d];
    }

    /** Over the lumped masses, by iteration: from below. */
    double
    largest_eigenvalue() const
    {
      std::mt19937                           random(1);
      std::uniform_real_distribution<double> number(-1, 1);
      std::vector<double>                    mode(n), next(n);
      for (double &x : mode)
        x = number(random);
      double eigenvalue = 0;
      for (unsigned int i = 0; i < 300; ++i)
        {
          double length = 0;
          for (std::size_t r = 0; r < n; ++r)
            {
              next[r] = 0;
              for (std::size_t c = 0; c < n; ++c)
                next[r] += entries[r * n + c] * mode[c] /
                           std::sqrt(masses[r / 3] * masses[c / 3]);
              length += next[r] * next[r];
            }
          eigenvalue = std::sqrt(length);
          for (std::size_t r = 0; r < n; ++r)
            mode[r] = next[r] / eigenvalue;
        }
      return eigenvalue;
    }

  private:
    std::size_t         n;
    std::vector<double> entries, masses;
  };

  /** Pieces of a body that overlap. */
  struct Pieces
  {
    DiscreteBody body;

    /** The piece of each cell. */
    std::vector<std::size_t> piece;

    /** Shift of each piece, m. */
    std::vector<Vector3<double>> shifts;

    StiffnessMatrix elasticity;

    double frequency_squared = 0;

    double
    of_cell(const CellIndex cell) const
    {
      return largest_frequency_squared(body.reference[cell / batch_size],
                                       cell % batch_size,
                                       elasticity,
                                       density);
    }

    std::vector<double>
    masses() const
    {
      std::vector<double> result;
      for (NodeIndex node = 0; node < body.topology.n_nodes(); ++node)
        result.push_back(
          lumped_mass(body.topology, body.reference, {density}, node));
      return result;
    }

    Tetrahedron
    position(const CellIndex cell) const
    {
      Tetrahedron result = corners(body, cell);
      for (Vector3<double> &x : result)
        x += shifts[piece[cell]];
      return result;
    }
  };

  void
  add_elasticity(const Pieces &pieces, NodalMatrix &matrix)
  {
    const Topology &topology = pieces.body.topology;
    for (CellIndex cell = 0; cell < pieces.piece.size(); ++cell)
      {
        const ReferenceBatch &batch  = pieces.body.reference[cell / batch_size];
        const double          volume = batch.volume[cell % batch_size];
        // Strains of a unit displacement of each corner.
        double b[12][6];
        for (unsigned int i = 0; i < 12; ++i)
          {
            const auto   g          = batch.gradient(i / 3, cell % batch_size);
            const double rows[3][6] = {{g[0], 0, 0, 0, g[2], g[1]},
                                       {0, g[1], 0, g[2], 0, g[0]},
                                       {0, 0, g[2], g[1], g[0], 0}};
            std::copy(rows[i % 3], rows[i % 3] + 6, b[i]);
          }
        for (unsigned int i = 0; i < 12; ++i)
          for (unsigned int j = 0; j < 12; ++j)
            for (unsigned int s = 0; s < 6; ++s)
              for (unsigned int t = 0; t < 6; ++t)
                matrix(topology.node(cell, i / 3),
                       i % 3,
                       topology.node(cell, j / 3),
                       j % 3) +=
                  volume * b[i][s] * pieces.elasticity[s][t] * b[j][t];
      }
  }

  using Gradients = std::array<Vector3<double>, 8>;

  Gradients
  gradients(const Overlap &common)
  {
    Gradients result;
    std::copy(common.gradient_a.begin(),
              common.gradient_a.end(),
              result.begin());
    std::copy(common.gradient_b.begin(),
              common.gradient_b.end(),
              result.begin() + 4);
    return result;
  }

  /** Overlap, by differences, and the spring of friction of a pair. */
  void
  add_pair(const Pieces   &pieces,
           const CellIndex a,
           const CellIndex b,
           const double    penalty,
           NodalMatrix    &matrix)
  {
    std::array<Tetrahedron, 2> x{{pieces.position(a), pieces.position(b)}};
    const Overlap              common = overlap(x[0], x[1]);
    if (common.volume == 0)
      return;
    std::array<NodeIndex, 8> nodes;
    std::array<double, 8>    weights;
    for (unsigned int c = 0; c < 4; ++c)
      {
        nodes[c]       = pieces.body.topology.node(a, c);
        nodes[4 + c]   = pieces.body.topology.node(b, c);
        weights[c]     = common.weights_a[c];
        weights[4 + c] = -common.weights_b[c];
      }
    const double step = 1e-6 * norm(x[0][1] - x[0][0]);
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        {
          double &moved = x[i / 4][i % 4][d], before = moved;
          moved            = before + step;
          const auto above = gradients(overlap(x[0], x[1]));
          moved            = before - step;
          const auto below = gradients(overlap(x[0], x[1]));
          moved            = before;
          for (unsigned int j = 0; j < 8; ++j)
            for (unsigned int e = 0; e < dim; ++e)
              matrix(nodes[j], e, nodes[i], d) +=
                penalty * (above[j][e] - below[j][e]) / (2 * step);
        }
    Vector3<double> force{};
    for (const Vector3<double> &g : common.gradient_a)
      force += penalty * g;
    const double square = dot(force, force);
    if (square == 0)
      return;
    const double spring =
      friction_stiffness_ratio * square / (2 * penalty * common.potential);
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int j = 0; j < 8; ++j)
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int e = 0; e < dim; ++e)
            matrix(nodes[i], d, nodes[j], e) +=
              spring * weights[i] * weights[j] *
              ((d == e) - force[d] * force[e] / square);
  }

  /** Cohesive elements at the faces that have been cut and not released, as
   * stiff as the step allows in each direction (doc/theory.md, section 6). */
  void
  add_elements(const Pieces              &pieces,
               const std::vector<double> &spare,
               NodalMatrix               &matrix)
  {
    const Topology &topology = pieces.body.topology;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      {
        if (topology.face_states[face] != FaceState::failed)
          continue;
        const auto  &cells = topology.faces[face].cells;
        const double third = 1. / 3;
        const double spring =
          .5 * third * std::min(spare[cells[0]], spare[cells[1]]);
        for (const VertexIndex vertex : vertices_of(topology, face))
          {
            NodeIndex nodes[2];
            for (unsigned int s = 0; s < 2; ++s)
              nodes[s] =
                topology.node(cells[s],
                              topology.corner_at_vertex(cells[s], vertex));
            for (unsigned int d = 0; d < dim && nodes[0] != nodes[1]; ++d)
              for (unsigned int i = 0; i < 2; ++i)
                for (unsigned int j = 0; j < 2; ++j)
                  matrix(nodes[i], d, nodes[j], d) += i == j ? spring : -spring;
          }
      }
  }

  /** Whether a cohesive element acts between two cells. */
  bool
  have_element(const Topology &topology, const CellIndex a, const CellIndex b)
  {
    const auto &faces = topology.cell_faces[a];
    return std::any_of(faces.begin(), faces.end(), [&](const FaceIndex face) {
      return face != invalid_index && topology.neighbour(face, a) == b &&
             topology.face_states[face] == FaceState::failed;
    });
  }

  /** The largest frequency squared over the one that the step allows. */
  double
  used_room(const Pieces &pieces)
  {
    const Topology     &topology = pieces.body.topology;
    std::vector<double> spare(topology.n_cell_slots());
    for (CellIndex cell = 0; cell < pieces.piece.size(); ++cell)
      spare[cell] =
        density *
        pieces.body.reference[cell / batch_size].volume[cell % batch_size] / 4 *
        (pieces.frequency_squared - pieces.of_cell(cell));
    const ContactStiffnesses stiffness(topology,
                                       pieces.body.reference,
                                       spare,
                                       1. / 3);
    NodalMatrix              matrix(pieces.masses());
    add_elasticity(pieces, matrix);
    add_elements(pieces, spare, matrix);
    for (CellIndex a = 0; a < pieces.piece.size(); ++a)
      for (CellIndex b = a + 1; b < pieces.piece.size(); ++b)
        if (pieces.piece[a] != pieces.piece[b] && !have_element(topology, a, b))
          add_pair(pieces,
                   a,
                   b,
                   pair_penalty(stiffness.of_cell(a), stiffness.of_cell(b)),
                   matrix);
    return matrix.largest_eigenvalue() / pieces.frequency_squared;
  }

  /**
   * A box that is cut into pieces, which move to its corner by `strain`.
   *
   * @param n_pieces 0: each cell is one.
   * @param factor by which contact may raise the square of the largest frequency
   *   of a loose cell.
   */
  Pieces
  broken_box(const std::array<unsigned int, 3> &n,
             const unsigned int                 n_pieces,
             const double                       strain,
             const double                       factor,
             const unsigned int                 seed)
  {
    Pieces       result{discretize(make_box(n, 1e-3, .2, seed), {density}),
                  {},
                  {},
                  {}};
    Topology    &topology = result.body.topology;
    std::mt19937 random(seed);
    std::vector<Vector3<double>> centres;
    const auto                   centre = [&](const CellIndex cell) {
      Vector3<double> sum{};
      for (const Vector3<double> &x : corners(result.body, cell))
        sum += .25 * x;
      return sum;
    };
    for (unsigned int i = 0; i < n_pieces; ++i)
      centres.push_back(centre(random() % topology.n_cells()));
    for (CellIndex cell = 0; cell < topology.n_cells(); ++cell)
      {
        if (n_pieces == 0)
          centres.push_back(centre(cell));
        const auto distance = [&](const Vector3<double> &x) {
          return norm(x - centre(cell));
        };
        result.piece.push_back(
          std::min_element(centres.begin(),
                           centres.end(),
                           [&](const auto &x, const auto &y) {
                             return distance(x) < distance(y);
                           }) -
          centres.begin());
      }
    for (const Vector3<double> &x : centres)
      result.shifts.push_back(-strain * x);
    std::vector<FaceIndex> cuts;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (result.piece[topology.faces[face].cells[0]] !=
          result.piece[topology.faces[face].cells[1]])
        cuts.push_back(face);
    release(result.body, cuts);

    MaterialParameters granite;
    granite.youngs_modulus = 50e9;
    granite.poissons_ratio = .25;
    result.elasticity      = stiffness_matrix(make_elasticity(granite));
    for (CellIndex cell = 0; cell < topology.n_cells(); ++cell)
      result.frequency_squared =
        std::max(result.frequency_squared, factor * result.of_cell(cell));
    return result;
  }
} // namespace

/** Elasticity and contact, normal force and friction, of pieces pressed against
 * each other on all sides. */
TEST(ContactStability, LeavesTheRoomThatThereIs)
{
  for (const double strain : {1e-3, 3e-2})
    {
      EXPECT_LT(used_room(broken_box({{2, 1, 1}}, 0, strain, 1.75, 1)), .8);
      EXPECT_LT(used_room(broken_box({{2, 2, 2}}, 2, strain, 1.75, 2)), .8);
      EXPECT_LT(used_room(broken_box({{2, 2, 2}}, 5, strain, 1.75, 3)), .8);
    }
}

/** Beside faces whose cohesive elements still act, cells of both sides meet by
 * their edges and corners, and by faces that have been released. */
TEST(ContactStability, LeavesRoomBesideCohesiveElements)
{
  std::mt19937 random(4);
  for (const double strain : {1e-3, 3e-2})
    for (const unsigned int one_in : {1, 2, 4})
      for (const unsigned int n_pieces : {0, 3})
        {
          Pieces pieces =
            broken_box({{2, 2, 1}}, n_pieces, strain, 1.75, one_in);
          for (FaceState &state : pieces.body.topology.face_states)
            if (state == FaceState::released && random() % one_in == 0)
              state = FaceState::failed;
          EXPECT_LT(used_room(pieces), .9) << one_in << ' ' << n_pieces;
        }
}

/** Pieces that lie in each other so deep that cells behind their surfaces are
 * reached use no more. */
TEST(ContactStability, LeavesRoomForDeepOverlaps)
{
  for (const double strain : {.1, .3, .5})
    EXPECT_LT(used_room(broken_box({{3, 3, 3}}, 2, strain, 300, 1)), .5);
}

/** Nearly alone, contact uses what it may, but for the margin of its bounds. */
TEST(ContactStability, UsesTheRoomThatThereIs)
{
  for (unsigned int seed = 1; seed < 4; ++seed)
    {
      const double loose =
        used_room(broken_box({{2, 1, 1}}, 0, 1e-2, 300, seed));
      EXPECT_LT(loose, 1);
      EXPECT_GT(loose, .5);
      const double large =
        used_room(broken_box({{2, 2, 2}}, 3, 1e-2, 300, seed));
      EXPECT_LT(large, 1);
      EXPECT_GT(large, .3);
    }
}
