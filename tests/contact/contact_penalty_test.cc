// The stiffness of contact in closed form.

#include <rift/contact/contact_penalty.h>

#include "../support/random_cuts.h"
#include "released_faces.h"
#include <gtest/gtest.h>

#include <limits>

using namespace rift;
using namespace rift::test;

namespace
{
  constexpr double density = 2700, room = 1e12;

  /** Of cells that all have the same room. */
  std::vector<double>
  spare_stiffness(const DiscreteBody &body)
  {
    std::vector<double> result;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      result.push_back(
        density * body.reference[cell / batch_size].volume[cell % batch_size] /
        4 * room);
    return result;
  }

  ContactStiffnesses
  stiffnesses(const DiscreteBody &body, const double share_of_bond = 1. / 3)
  {
    return {body.topology,
            body.reference,
            spare_stiffness(body),
            share_of_bond};
  }

  /** A cell at the top of a box of 4 x 4 cubes of edge `h` that does not touch
   * the edges of the box. */
  CellIndex
  cell_inside_of_top(const DiscreteBody &body, const double h, const double top)
  {
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      {
        unsigned int n_on_top = 0;
        bool         is_inner = !body.topology.is_padding(cell);
        for (const Vector3<double> &x : corners(body, cell))
          {
            n_on_top += std::abs(x[2] - top) < .01 * h;
            for (unsigned int d = 0; d < 2; ++d)
              is_inner &= x[d] > .5 * h && x[d] < 3.5 * h;
          }
        if (is_inner && n_on_top == 3)
          return cell;
      }
    throw std::logic_error("no such cell");
  }
} // namespace

TEST(ContactPenalty, OfALooseRegularTetrahedron)
{
  Body         body;
  const double a              = 2e-3;
  body.vertices               = {{{0, 0, 0}},
                                 {{a, 0, 0}},
                                 {{.5 * a, std::sqrt(.75) * a, 0}},
                                 {{.5 * a, std::sqrt(1. / 12) * a, std::sqrt(2. / 3) * a}}};
  body.cells                  = {{0, {{0, 1, 2, 3}}, 0}};
  const DiscreteBody     cell = discretize(body, {density});
  const ContactStiffness of   = stiffnesses(cell).of_cell(0);
  const double           h    = std::sqrt(2. / 3) * a;
  EXPECT_NEAR(of.height, h, 1e-12 * h);
  // Normals of three faces at a corner: largest eigenvalue of sum n n^T 4/3;
  // of sum (5/7 n n^T + 2/7 I) 38/21.
  const double expected = density * h * room / 4 * 21 / 38;
  // The eigenvalue is a double one: half of the digits.
  EXPECT_NEAR(of.per_area, expected, 1e-8 * expected);
}

TEST(ContactPenalty, OfAFlatSurface)
{
  const double       h        = 2e-3;
  const DiscreteBody body     = discretize(make_box({{4, 4, 2}}, h), {density});
  const CellIndex    cell     = cell_inside_of_top(body, h, 2 * h);
  const auto         of       = stiffnesses(body).of_cell(cell);
  const double       expected = density * h * room / 2;
  EXPECT_NEAR(of.height, h / std::sqrt(2), 1e-12 * h);
  EXPECT_NEAR(of.per_area, expected, 1e-12 * expected);
}

TEST(ContactPenalty, OfTheSidesOfAReleasedCrack)
{
  const double           h    = 2e-3;
  DiscreteBody           body = discretize(make_box({{4, 4, 4}}, h), {density});
  std::vector<FaceIndex> crack;
  for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
    {
      const Triangle t = triangle_of(body.topology, face);
      if (std::all_of(t.begin(), t.end(), [&](const VertexIndex v) {
            return std::abs(body.state.reference[v][2] - 2 * h) < .01 * h;
          }))
        crack.push_back(face);
    }
  const CellIndex cell   = cell_inside_of_top(body, h, 2 * h);
  const double    inside = stiffnesses(body).of_cell(cell).per_area;
  release(body, crack);
  const double expected = density * h * room / 2;
  EXPECT_NEAR(stiffnesses(body).of_cell(cell).per_area,
              expected,
              1e-12 * expected);
  // Inside, about what they have at a flat surface.
  EXPECT_NEAR(inside, expected, .1 * expected);
}

TEST(ContactPenalty, CohesiveElementsHaveTheirShare)
{
  const double    h         = 2e-3;
  DiscreteBody    body      = discretize(make_box({{4, 4, 2}}, h), {density});
  const CellIndex cell      = cell_inside_of_top(body, h, 2 * h);
  const auto     &own_faces = body.topology.cell_faces[cell];
  const double    before    = stiffnesses(body).of_cell(cell).per_area;
  const FaceIndex bonded =
    *std::find_if(own_faces.begin(), own_faces.end(), [](const FaceIndex face) {
      return face != invalid_index;
    });
  for (const FaceState state :
       {FaceState::cut, FaceState::opening, FaceState::failed})
    {
      body.topology.face_states[bonded] = state;
      // Two of the twelve cells around a node lose a third.
      EXPECT_NEAR(stiffnesses(body).of_cell(cell).per_area / before,
                  17. / 18,
                  1e-12);
      EXPECT_EQ(stiffnesses(body, 0).of_cell(cell).per_area, before);
    }
}

TEST(ContactPenalty, NodesAreKnownUntilTheyAreForgotten)
{
  const double    h         = 2e-3;
  DiscreteBody    body      = discretize(make_box({{4, 4, 2}}, h), {density});
  const CellIndex cell      = cell_inside_of_top(body, h, 2 * h);
  const auto     &own_faces = body.topology.cell_faces[cell];

  ContactStiffnesses::KnownNodes known;
  const auto                     of = [&](const bool by_known) {
    return (by_known ? stiffnesses(body).of_cell(cell, known) :
                                           stiffnesses(body).of_cell(cell))
      .per_area;
  };
  const double before = of(false);
  EXPECT_EQ(of(true), before);
  for (const FaceIndex face : own_faces)
    if (face != invalid_index)
      body.topology.face_states[face] = FaceState::cut;
  EXPECT_NE(of(false), before);
  EXPECT_EQ(of(true), before);
  for (unsigned int c = 0; c < n_corners; ++c)
    known.forget(body.topology.node(cell, c));
  EXPECT_EQ(of(true), of(false));
}

TEST(ContactPenalty, OfPairs)
{
  const ContactStiffness a{3e15, 1e-3}, b{1e15, 4e-3},
    wall{std::numeric_limits<double>::infinity(), 1e-3};
  EXPECT_EQ(pair_penalty(a, b), pair_penalty(b, a));
  EXPECT_NEAR(pair_penalty(a, a), 3e15 * 1e-3 / 4, 1e-3);
  // Flat faces: (1/h_a + 1/h_b) p is the stiffness per area.
  EXPECT_NEAR(pair_penalty(a, b) * 1250, 1 / (1 / 3e15 + 1 / 1e15), 1e3);
  EXPECT_NEAR(pair_penalty(a, wall) * 2000, 3e15, 1e3);
}
