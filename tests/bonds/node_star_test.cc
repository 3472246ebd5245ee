#include <rift/bonds/node_star.h>

#include <gtest/gtest.h>

#include "../support/random_cuts.h"

using namespace rift;
using namespace rift::test;

namespace
{
  using Vector = Vector3<double>;

  /** Smallest of all assignments of the free cells, and where they are. */
  struct Smallest
  {
    double           area;
    std::vector<int> sides;
  };

  struct FaceOfStar
  {
    FaceIndex    face;
    unsigned int cells[2];
    double       area;
    Vector       vector;
  };

  struct Star
  {
    std::vector<StarCell>   cells;
    std::vector<int>        sides;
    std::vector<FaceOfStar> faces;
  };

  Star
  star_of(const DiscreteBody &body, const NodeIndex node, const Vector &normal)
  {
    Star         star;
    const Vector origin = body.state.reference[node].vector();
    star.cells          = cells_at_node(body.topology, node);
    for (const StarCell &c : star.cells)
      {
        double lowest = 1e300, highest = -1e300;
        for (unsigned int k = 0; k < n_corners; ++k)
          if (k != c.corner)
            {
              const double height = dot(
                body.state.reference[body.topology.node(c.cell, k)].vector() -
                  origin,
                normal);
              lowest  = std::min(lowest, height);
              highest = std::max(highest, height);
            }
        star.sides.push_back(lowest >= 0 ? 1 : highest <= 0 ? -1 : 0);
      }
    for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
      {
        const Face  &f = body.topology.faces[face];
        FaceOfStar   of_star{face, {0, 0}, 0, {}};
        unsigned int n = 0;
        for (unsigned int i = 0; i < star.cells.size(); ++i)
          for (unsigned int side = 0; side < 2; ++side)
            if (star.cells[i].cell == f.cells[side])
              {
                of_star.cells[side] = i;
                ++n;
              }
        if (n < 2)
          continue;
        Vector x[3];
        for (unsigned int k = 0; k < 3; ++k)
          x[k] =
            body.state
              .reference[body.topology.node(f.cells[0],
                                            face_corners[f.local_faces[0]][k])]
              .vector();
        of_star.vector = .5 * cross(x[1] - x[0], x[2] - x[0]);
        of_star.area   = norm(of_star.vector);
        star.faces.push_back(of_star);
      }
    return star;
  }

  /** By trying all. Faces of `free` cost nothing, those of `barred` cannot be
   * cut. */
  Smallest
  brute_force(const Star                &star,
              const std::set<FaceIndex> &free,
              const std::set<FaceIndex> &barred)
  {
    std::vector<unsigned int> open;
    for (unsigned int i = 0; i < star.sides.size(); ++i)
      if (star.sides[i] == 0)
        open.push_back(i);
    Smallest best{std::numeric_limits<double>::infinity(), {}};
    for (std::uint64_t code = 0; code < (1ull << open.size()); ++code)
      {
        std::vector<int> sides = star.sides;
        for (unsigned int b = 0; b < open.size(); ++b)
          sides[open[b]] = (code >> b & 1) != 0 ? 1 : -1;
        double area = 0;
        for (const FaceOfStar &f : star.faces)
          if (sides[f.cells[0]] != sides[f.cells[1]] && free.count(f.face) == 0)
            area += barred.count(f.face) > 0 ?
                      std::numeric_limits<double>::infinity() :
                      f.area;
        if (area < best.area)
          best = {area, sides};
      }
    return best;
  }

  /** Component of each cell of a star when faces are cut. */
  std::vector<unsigned int>
  components(const Star &star, const std::set<FaceIndex> &cuts)
  {
    std::vector<unsigned int> names(star.cells.size());
    std::iota(names.begin(), names.end(), 0u);
    for (bool changes = true; changes;)
      {
        changes = false;
        for (const FaceOfStar &f : star.faces)
          if (cuts.count(f.face) == 0 && names[f.cells[0]] != names[f.cells[1]])
            {
              changes           = true;
              names[f.cells[0]] = names[f.cells[1]] =
                std::min(names[f.cells[0]], names[f.cells[1]]);
            }
      }
    return names;
  }

  Vector
  random_direction(std::mt19937 &random)
  {
    std::normal_distribution<double> value;
    const Vector v = {{value(random), value(random), value(random)}};
    return (1 / norm(v)) * v;
  }

  bool
  has(const std::vector<int> &sides, const int side)
  {
    return std::find(sides.begin(), sides.end(), side) != sides.end();
  }

  /** Cuts the stars of a box with some faces cut before and others that cannot
   * be cut.
   * @return how many were compared. */
  unsigned int
  compare(const unsigned int n_cut, const unsigned int percent_barred)
  {
    std::mt19937 random(7);
    unsigned int n_compared = 0;
    for (unsigned int round = 0; round < 80; ++round)
      {
        DiscreteBody body =
          discretize(make_box({{3, 3, 3}}, 1, .2, round), {2641.});
        const NodeIndex     node   = random() % body.topology.n_nodes();
        const Vector        normal = random_direction(random);
        const Star          before = star_of(body, node, normal);
        std::set<FaceIndex> cuts, barred;
        for (unsigned int i = 0; i < n_cut && !before.faces.empty(); ++i)
          cuts.insert(before.faces[random() % before.faces.size()].face);
        for (const FaceOfStar &f : before.faces)
          if (random() % 100 < percent_barred && cuts.count(f.face) == 0)
            barred.insert(f.face);
        if (!cuts.empty())
          cut(body, {cuts.begin(), cuts.end()});
        Star star = star_of(body, node, normal);
        if (star.cells.size() != before.cells.size() || !has(star.sides, 1) ||
            !has(star.sides, -1))
          continue;
        // Cells beside faces that are cut go to their own sides.
        std::vector<int> votes(star.cells.size(), 0);
        for (const FaceOfStar &f : star.faces)
          {
            if (cuts.count(f.face) == 0 ||
                std::abs(dot(f.vector, normal)) < .2 * f.area)
              continue;
            // From the side of the first cell, away from its centre.
            double height[2] = {0, 0};
            for (unsigned int side = 0; side < 2; ++side)
              for (unsigned int k = 0; k < n_corners; ++k)
                height[side] +=
                  dot(body.state
                        .reference[body.topology
                                     .node(star.cells[f.cells[side]].cell, k)]
                        .vector(),
                      f.vector);
            const int up = (height[1] > height[0] ? 1 : -1) *
                           (dot(f.vector, normal) > 0 ? 1 : -1);
            votes[f.cells[0]] -= up;
            votes[f.cells[1]] += up;
          }
        for (unsigned int i = 0; i < votes.size(); ++i)
          if (star.sides[i] == 0 && votes[i] != 0)
            star.sides[i] = votes[i] > 0 ? 1 : -1;
        if (std::count(star.sides.begin(), star.sides.end(), 0) > 18)
          continue;
        const auto result = cut_star(
          body.topology,
          body.reference,
          body.state,
          node,
          normal,
          [&barred](const FaceIndex f) { return barred.count(f) == 0; });
        const Smallest best = brute_force(star, cuts, barred);
        ++n_compared;
        EXPECT_EQ(result.has_value(), std::isfinite(best.area));
        if (!result || !std::isfinite(best.area))
          continue;
        EXPECT_NEAR(result->new_area, best.area, 1e-9);
        std::set<FaceIndex> all = cuts;
        for (const FaceIndex face : result->faces)
          {
            EXPECT_TRUE(all.insert(face).second);
            EXPECT_EQ(barred.count(face), 0u);
          }
        const auto names = components(star, all);
        for (unsigned int i = 0; i < names.size(); ++i)
          for (unsigned int j = 0; j < i; ++j)
            EXPECT_FALSE(star.sides[i] * star.sides[j] == -1 &&
                         names[i] == names[j]);
        // The area that all faces between the sides have on the plane.
        EXPECT_GT(result->projected_area, 0);
        EXPECT_LE(
          result->projected_area,
          result->new_area + 1e-9 + [&] {
            double area = 0;
            for (const FaceOfStar &f : star.faces)
              area += cuts.count(f.face) > 0 ? f.area : 0;
            return area;
          }());
      }
    return n_compared;
  }
} // namespace

TEST(NodeStar, CutIsTheSmallestOfAll)
{
  EXPECT_GT(compare(0, 0), 8u);
}

TEST(NodeStar, FacesThatAreCutAreCarriedOn)
{
  EXPECT_GT(compare(1, 0), 8u);
  EXPECT_GT(compare(2, 0), 8u);
}

TEST(NodeStar, FacesThatCannotBeCutAreNot)
{
  EXPECT_GT(compare(0, 10), 8u);
  EXPECT_GT(compare(1, 30), 8u);
}

// A corner of the body whose cells are all on one side.
TEST(NodeStar, NothingWhereAllCellsAreOnOneSide)
{
  const DiscreteBody body   = discretize(make_box({{2, 2, 2}}), {2641.});
  unsigned int       n_seen = 0;
  for (NodeIndex node = 0; node < body.topology.n_nodes(); ++node)
    if (norm(body.state.reference[node].vector()) < 1e-9)
      {
        ++n_seen;
        EXPECT_FALSE(cut_star(body.topology,
                              body.reference,
                              body.state,
                              node,
                              (1 / std::sqrt(3.)) * Vector{{1, 1, 1}},
                              [](FaceIndex) { return true; }));
      }
  EXPECT_EQ(n_seen, 1u);
}

TEST(NodeStar, NothingWhereNoFaceCanBeCut)
{
  const DiscreteBody body = discretize(make_box({{2, 2, 2}}, 1, .1), {2641.});
  std::mt19937       random(1);
  for (NodeIndex node = 0; node < body.topology.n_nodes(); ++node)
    EXPECT_FALSE(cut_star(body.topology,
                          body.reference,
                          body.state,
                          node,
                          random_direction(random),
                          [](FaceIndex) { return false; }));
}
