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
          cell.constants = {1, 1. + i, invalid_index};
          Vector3<double> centre;
          for (double &x : centre)
            x = uniform(engine);
          const double      edge      = size * std::pow(uniform(engine), 2);
          const Tetrahedron reference = {
            {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}};
          for (unsigned int c = 0; c < n_corners; ++c)
            {
              cell.motion.positions[c] = centre + edge * reference[c];
              cell.nodes[c]            = n_corners * cell.cell + c;
              cell.bonded[c]           = invalid_index;
            }
          // Some cells are bonded.
          if (i % 5 > 0)
            cell.nodes[2] = all.back().nodes[i % 4];
          all.push_back(cell);
        }
    }

    std::vector<ContactCell>
    own() const
    {
      std::vector<ContactCell> result;
      for (const ContactCell &cell : all)
        if (cell.owner == world().rank())
          result.push_back(cell);
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

    /** Pairs of which this rank sees a cell, one by one. */
    std::vector<Rendezvous::NamedPair>
    brute_force() const
    {
      std::vector<Rendezvous::NamedPair> pairs;
      for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
          {
            const ContactCell &a = all[i], &b = all[j];
            if ((is_seen(a) || is_seen(b)) && !are_bonded(a, b) &&
                boxes_overlap(box_around(a.motion.positions, skin / 2),
                              box_around(b.motion.positions, skin / 2)) &&
                FacePlanes(a.motion.positions)
                    .distance_to(b.motion.positions) <= skin &&
                FacePlanes(b.motion.positions)
                    .distance_to(a.motion.positions) <= skin)
              pairs.emplace_back(a.cell, b.cell);
          }
      return pairs;
    }

    void
    move(const double by, const double stretch)
    {
      for (ContactCell &cell : all)
        for (Vector3<double> &x : cell.motion.positions)
          x = stretch * x + Vector3<double>{{by, -by, 0}};
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
  std::vector<Rendezvous::NamedPair>
  named(const ContactNeighbourhood &neighbourhood, const Cloud &cloud)
  {
    const auto &cells = neighbourhood.cells;
    for (std::size_t i = 0; i < cells.size(); ++i)
      {
        const ContactCell &original = cloud.all[(cells[i].cell - 1) / 3];
        EXPECT_EQ(cells[i].constants.mass, original.constants.mass);
        EXPECT_EQ(cells[i].owner, original.owner);
        EXPECT_EQ(cells[i].nodes, original.nodes);
        EXPECT_TRUE(i == 0 || cells[i - 1].cell < cells[i].cell);
      }
    std::vector<Rendezvous::NamedPair> pairs;
    for (const BoxPair &pair : neighbourhood.pairs)
      pairs.emplace_back(cells[pair.first].cell, cells[pair.second].cell);
    return pairs;
  }
} // namespace

TEST(Rendezvous, FindsThePairsOfAllRanks)
{
  std::int64_t n_pairs = 0;
  for (unsigned int seed = 0; seed < 120; ++seed)
    {
      // From a few cells, so that ranks have none, to many of all sizes.
      Cloud      cloud(seed, 1 + seed % 40 * 8, .05 + .3 / (1 + seed % 7));
      Rendezvous rendezvous(world(), cloud.subscribers());
      for (const double stretch : {1., 1., .7, 5.})
        {
          const auto expected = cloud.brute_force();
          n_pairs += static_cast<std::int64_t>(expected.size());
          EXPECT_EQ(named(rendezvous.search(cloud.own(), skin), cloud),
                    expected)
            << seed;
          cloud.move(.3, stretch);
        }
    }
  EXPECT_GT(n_pairs, 16000);
}

TEST(Rendezvous, JoinsPairsThatAreKnown)
{
  for (unsigned int seed = 0; seed < 100; ++seed)
    {
      Cloud                              cloud(seed, 100, .1);
      std::vector<Rendezvous::NamedPair> all, expected;
      for (const ContactCell &a : cloud.all)
        for (const ContactCell &b : cloud.all)
          if (a.cell < b.cell && cloud.engine() % 50 == 0)
            {
              all.emplace_back(a.cell, b.cell);
              if (cloud.is_seen(a) || cloud.is_seen(b))
                expected.push_back(all.back());
            }
      const Rendezvous rendezvous(world(), cloud.subscribers());
      EXPECT_EQ(named(rendezvous.join(cloud.own(), all), cloud), expected);
      EXPECT_FALSE(expected.empty());
    }
}

TEST(Rendezvous, RefusesHeapsOnAllRanks)
{
  Cloud cloud(1, 1000, .1);
  for (ContactCell &cell : cloud.all)
    cell.motion = cloud.all[0].motion;
  Rendezvous rendezvous(world(), cloud.subscribers());
  try
    {
      rendezvous.search(cloud.own(), skin);
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
