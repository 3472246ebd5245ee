// Cells that know nothing of each other meet, on any number of ranks: against
// all pairs one by one.

#include <rift/base/exceptions.h>
#include <rift/contact/background_octree.h>
#include <rift/contact/rendezvous.h>
#include <rift/contact/separation.h>

#include <gtest/gtest.h>
#include <p4est.h>

#include <algorithm>
#include <random>

using namespace rift;

namespace
{
  const Communicator &
  world()
  {
    static const Communicator communicator(MPI_COMM_WORLD);
    return communicator;
  }

  constexpr double skin = .02;

  /** Global indices of two cells, the smaller first. */
  using NamedPair = std::pair<GlobalCellIndex, GlobalCellIndex>;

  /** Cells of all ranks, with owners at random; the same on all ranks. */
  class Cloud
  {
  public:
    Cloud(const unsigned int seed,
          const unsigned int n_cells,
          const double       size)
      : engine(seed)
    {
      std::uniform_real_distribution<double> uniform(0, 1);
      for (GlobalCellIndex i = 0; i < n_cells; ++i)
        {
          ContactCell cell{};
          cell.cell      = 3 * i + 1;
          cell.owner     = static_cast<int>(engine() % world().size());
          cell.constants = {1. + i, invalid_index};
          Vector3<double> centre;
          for (double &x : centre)
            x = uniform(engine);
          const double      edge      = size * std::pow(uniform(engine), 2);
          const Tetrahedron reference = {
            {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
          for (unsigned int c = 0; c < n_corners; ++c)
            {
              cell.positions[c] = centre + edge * reference[c];
              cell.groups[c]    = n_corners * cell.cell + c;
              cell.behind[c]    = invalid_index;
            }
          cell.margin = skin * uniform(engine);
          // Some cells are bonded.
          if (i % 5 > 0)
            cell.groups[2] = all.back().groups[i % 4];
          all.push_back(cell);
        }
    }

    /** Cells of this rank; empty: all. */
    std::vector<ContactCell>
    own(const std::vector<bool> &is_chosen = {}) const
    {
      std::vector<ContactCell> result;
      for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].owner == world().rank() &&
            (is_chosen.empty() || is_chosen[i]))
          result.push_back(all[i]);
      return result;
    }

    /** The owner and, of every third cell, one more rank. */
    std::vector<int>
    subscribers(const ContactCell &cell) const
    {
      std::vector<int> ranks = {cell.owner};
      const int        other =
        static_cast<int>((cell.cell * 7919u) % (3 * world().size()));
      if (other < world().size() && other != cell.owner)
        ranks.push_back(other);
      std::sort(ranks.begin(), ranks.end());
      return ranks;
    }

    bool
    is_seen(const ContactCell &cell) const
    {
      const std::vector<int> ranks = subscribers(cell);
      return std::count(ranks.begin(), ranks.end(), world().rank()) > 0;
    }

    /** Pairs of which this rank sees a cell, and one is new, one by one; empty
     * lists: all. */
    std::vector<NamedPair>
    brute_force(const std::vector<bool> &is_there = {},
                const std::vector<bool> &is_new   = {}) const
    {
      std::vector<NamedPair> pairs;
      for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
          {
            const ContactCell &a = all[i], &b = all[j];
            if (!is_new.empty() &&
                !(is_there[i] && is_there[j] && (is_new[i] || is_new[j])))
              continue;
            if ((is_seen(a) || is_seen(b)) && !are_bonded(a, b) &&
                boxes_overlap(box_around(a), box_around(b)) &&
                FacePlanes(a.positions).distance_to(b.positions) <=
                  a.margin + b.margin &&
                FacePlanes(b.positions).distance_to(a.positions) <=
                  a.margin + b.margin)
              pairs.emplace_back(a.cell, b.cell);
          }
      return pairs;
    }

    void
    move(const double by, const double stretch)
    {
      for (ContactCell &cell : all)
        for (Vector3<double> &x : cell.positions)
          x = stretch * x + Vector3<double>{{by, -by, 0}};
    }

    /** Moves a cell, some of them far. */
    void
    move(ContactCell &cell)
    {
      const double                           size = engine() % 3 == 0 ? 1 : .05;
      std::uniform_real_distribution<double> uniform(-size, size);
      const Vector3<double>                  by = {
                         {uniform(engine), uniform(engine), uniform(engine)}};
      for (Vector3<double> &x : cell.positions)
        x += by;
    }

    Rendezvous::Subscribers
    subscribers() const
    {
      return [this](const ContactCell &cell) { return subscribers(cell); };
    }

    std::mt19937             engine;
    std::vector<ContactCell> all;
  };

  /** Pairs by name; checks that the cells are those of the cloud. */
  std::vector<NamedPair>
  named(const ContactNeighbourhood &neighbourhood, const Cloud &cloud)
  {
    const auto &cells = neighbourhood.cells;
    for (std::size_t i = 0; i < cells.size(); ++i)
      {
        const ContactCell &original = cloud.all[(cells[i].cell - 1) / 3];
        EXPECT_EQ(cells[i].constants.mass, original.constants.mass);
        EXPECT_EQ(cells[i].owner, original.owner);
        EXPECT_EQ(cells[i].groups, original.groups);
        EXPECT_EQ(cells[i].positions, original.positions);
        EXPECT_TRUE(i == 0 || cells[i - 1].cell < cells[i].cell);
      }
    std::vector<NamedPair> pairs;
    for (const CellPair &pair : neighbourhood.pairs)
      pairs.emplace_back(cells[pair.a].cell, cells[pair.b].cell);
    return pairs;
  }
} // namespace

TEST(Rendezvous, FindsThePairsOfAllRanks)
{
  std::int64_t n_pairs = 0;
  for (unsigned int seed = 0; seed < 40; ++seed)
    {
      // From a few cells, so that ranks have none, to many of all sizes.
      Cloud      cloud(seed, 1 + seed % 40 * 8, .05 + .3 / (1 + seed % 7));
      Rendezvous rendezvous(world(), cloud.subscribers());
      for (const double stretch : {1., 1., .7, 5.})
        {
          const auto expected = cloud.brute_force();
          n_pairs += static_cast<std::int64_t>(expected.size());
          EXPECT_EQ(named(rendezvous.update(cloud.own()), cloud), expected)
            << seed;
          cloud.move(.3, stretch);
        }
    }
  EXPECT_GT(n_pairs, 4000);
}

// Each round has news of some cells: pairs are found if one of them is among
// these, wherever the others have been told of.
TEST(Rendezvous, FindsThePairsOfWhatIsNew)
{
  std::int64_t n_pairs = 0, n_divisions = 0;
  for (unsigned int seed = 0; seed < 12; ++seed)
    {
      Cloud      cloud(seed, 20 + seed % 40 * 40, .05 + .3 / (1 + seed % 7));
      Rendezvous rendezvous(world(), cloud.subscribers());
      // Few are there at first, so that space is divided anew at times.
      std::vector<bool> is_there(cloud.all.size(), false);
      for (unsigned int round = 0; round < 8; ++round)
        {
          std::vector<bool> is_new(cloud.all.size());
          const bool        needs_all = rendezvous.needs_all();
          n_divisions += needs_all ? 1 : 0;
          for (std::size_t i = 0; i < is_new.size(); ++i)
            {
              const bool is_moved = cloud.engine() % 4 == 0;
              if (is_moved)
                cloud.move(cloud.all[i]);
              is_new[i]   = is_moved || (needs_all && is_there[i]);
              is_there[i] = is_there[i] || is_new[i];
            }
          const auto pairs = named(rendezvous.update(cloud.own(is_new)), cloud);
          const auto expected = cloud.brute_force(is_there, is_new);
          n_pairs += static_cast<std::int64_t>(expected.size());
          EXPECT_EQ(pairs, expected) << seed;
        }
    }
  EXPECT_GT(n_pairs, 500);
  EXPECT_GE(n_divisions, world().size() == 1 ? 12 : 24);
}

TEST(Rendezvous, RefusesHeapsOnAllRanks)
{
  Cloud cloud(1, 1000, .1);
  for (ContactCell &cell : cloud.all)
    cell.positions = cloud.all[0].positions;
  Rendezvous rendezvous(world(), cloud.subscribers());
  try
    {
      rendezvous.update(cloud.own());
      FAIL() << "no error";
    }
  catch (const Error &error)
    {
      EXPECT_EQ(error.exit_code, RunError("").exit_code);
      EXPECT_NE(std::string(error.what())
                  .find("the 1000 cells at surfaces have more than 200000 "
                        "pairs that may touch"),
                std::string::npos)
        << error.what();
    }
}

TEST(BackgroundOctree, BalancesPoints)
{
  // Two clouds, one of them a thousandth in size, far from the origin.
  std::mt19937                 engine(world().rank());
  std::normal_distribution<>   normal(0, 1);
  std::vector<Vector3<double>> points;
  for (unsigned int i = 0; i < 6000; ++i)
    {
      const double size = i % 2 ? 1 : 1e-3;
      points.push_back({{1e5 + 10 * size + size * normal(engine),
                         size * normal(engine),
                         size * normal(engine)}});
    }
  const SpaceDivision       division = divide_space(points, world());
  std::vector<std::int64_t> numbers(world().size());
  for (const Vector3<double> &point : points)
    ++numbers[division.rank_of(point)];
  world().sum(numbers);
  for (const std::int64_t number : numbers)
    EXPECT_NEAR(number, 6000, 900);
}

TEST(BackgroundOctree, TakesPointsAtOnePlace)
{
  const std::vector<Vector3<double>> points(200, {{1, 2, 3}});
  EXPECT_LT(divide_space(points, world()).rank_of({{1, 2, 3}}), world().size());
  EXPECT_LT(divide_space({}, world()).rank_of({{1, 2, 3}}), world().size());
}
