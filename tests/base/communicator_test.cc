#include <rift/base/communicator.h>
#include <rift/base/exceptions.h>

#include <gtest/gtest.h>

#include <new>
#include <optional>
#include <stdexcept>

using namespace rift;

namespace
{
  /** What rank `rank` has to tell: texts of different lengths, one empty. */
  std::string
  text_of(const int rank)
  {
    return std::string(rank % 3, static_cast<char>('a' + rank));
  }
} // namespace

TEST(Communicator, Numbers)
{
  const Communicator all(MPI_COMM_WORLD);
  const int          n = all.size();
  EXPECT_EQ(all.sum(all.rank() + 1), n * (n + 1) / 2);
  EXPECT_EQ(all.max(-1. - all.rank()), -1);
  EXPECT_TRUE(all.any(all.rank() == n - 1));
  EXPECT_FALSE(all.any(false));
  std::vector<std::int64_t> numbers = {1, std::int64_t(all.rank()) << 40};
  all.sum(numbers);
  EXPECT_EQ(numbers[0], n);
  EXPECT_EQ(numbers[1], std::int64_t(n * (n - 1) / 2) << 40);
}

TEST(Communicator, Texts)
{
  const Communicator       all(MPI_COMM_WORLD);
  std::vector<std::string> expected;
  for (int rank = 0; rank < all.size(); ++rank)
    expected.push_back(text_of(rank));
  EXPECT_EQ(all.all_gather(text_of(all.rank())), expected);
  EXPECT_EQ(all.gather(text_of(all.rank())),
            all.is_root() ? expected : std::vector<std::string>());

  std::string text = all.is_root() ? "from the root" : "other";
  all.broadcast(text);
  EXPECT_EQ(text, "from the root");
}

TEST(Communicator, BytesFromOneRankToAnother)
{
  const Communicator all(MPI_COMM_WORLD);
  if (!all.is_root())
    {
      all.send(text_of(all.rank()), 0);
      all.send("second", 0);
      return;
    }
  for (int rank = 1; rank < all.size(); ++rank)
    {
      EXPECT_EQ(all.receive(rank), text_of(rank));
      EXPECT_EQ(all.receive(rank), "second");
    }
}

TEST(Communicator, FirstOfRanks)
{
  const Communicator all(MPI_COMM_WORLD);
  struct Place
  {
    double       value;
    unsigned int name;
  };
  const auto comes_before = [](const Place &a, const Place &b) {
    return a.value > b.value || (a.value == b.value && a.name < b.name);
  };
  for (int best = 0; best < all.size(); ++best)
    {
      const Place first =
        all.first_of_ranks(Place{all.rank() == best ? 2. : 1., 7u + all.rank()},
                           comes_before);
      EXPECT_EQ(first.value, 2);
      EXPECT_EQ(first.name, 7u + best);
    }
  EXPECT_EQ(all.first_of_ranks(Place{1, 9u - all.rank()}, comes_before).name,
            10u - all.size());
}

TEST(Communicator, TextsInTurn)
{
  const Communicator       all(MPI_COMM_WORLD);
  std::vector<std::string> expected, taken;
  for (int rank = 0; rank < all.size(); ++rank)
    expected.push_back(text_of(rank));
  all.gather_in_turn(text_of(all.rank()),
                     [&](const std::string &text) { taken.push_back(text); });
  EXPECT_EQ(taken, all.is_root() ? expected : std::vector<std::string>());
}

TEST(Communicator, NeighboursExchange)
{
  // Each rank tells the next one.
  const Communicator all(MPI_COMM_WORLD);
  const int          next     = (all.rank() + 1) % all.size();
  const int          last     = (all.rank() + all.size() - 1) % all.size();
  const auto         received = all.exchange({{next, text_of(all.rank())}});
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(received.at(last), text_of(last));
}

TEST(Communicator, PairsExchangeWhatTheyExpect)
{
  // Ranks 0 and 1 twice, the others not at all; one message is empty.
  const Communicator all(MPI_COMM_WORLD);
  const int          other = 1 - all.rank();
  if (all.size() == 1)
    return;
  if (other < 0)
    {
      // The sums below
      all.sum(1);
      all.sum(1);
      return;
    }
  for (const std::size_t length : {5, 0})
    {
      const std::string own(length * (1 + all.rank()), 'a');
      PendingExchange   exchange =
        all.start_exchange({{other, own}}, {{other, length * (1 + other)}});
      // It may be moved and left alone while others take place.
      PendingExchange moved;
      moved = std::move(exchange);
      EXPECT_EQ(all.sum(1), all.size());
      const auto received = moved.finish();
      ASSERT_EQ(received.size(), 1u);
      EXPECT_EQ(received.at(other), std::string(length * (1 + other), 'a'));
    }
}

TEST(Communicator, TypedExchange)
{
  // Each rank sends its number to each rank, as often as that says; the first
  // of them gets an empty message.
  const Communicator              all(MPI_COMM_WORLD);
  std::map<int, std::vector<int>> data, expected;
  for (int rank = 0; rank < all.size(); ++rank)
    {
      data[rank].assign(rank, all.rank());
      expected[rank].assign(all.rank(), rank);
    }
  EXPECT_EQ(all.exchange(data), expected);
}

TEST(Communicator, MessagesOfOthersAreNotTaken)
{
  // Messages of the program around, with the same ranks and any tag.
  const Communicator       all(MPI_COMM_WORLD);
  constexpr int            n_tags  = 10;
  const int                next    = (all.rank() + 1) % all.size();
  const int                last    = (all.rank() + all.size() - 1) % all.size();
  const char               foreign = 'f';
  std::vector<MPI_Request> requests(n_tags);
  for (int tag = 0; tag < n_tags; ++tag)
    MPI_Isend(&foreign, 1, MPI_CHAR, next, tag, MPI_COMM_WORLD, &requests[tag]);

  EXPECT_EQ(all.exchange({{next, "o"}}).at(last), "o");
  if (all.size() > 1)
    {
      // One after the other: a large text would wait for its receiver.
      if (all.is_root())
        all.send("own", next);
      EXPECT_EQ(all.receive(last), "own");
      if (!all.is_root())
        all.send("own", next);
    }

  for (int tag = 0; tag < n_tags; ++tag)
    {
      char received = 0;
      MPI_Recv(&received,
               1,
               MPI_CHAR,
               last,
               tag,
               MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
      EXPECT_EQ(received, 'f');
    }
  MPI_Waitall(n_tags, requests.data(), MPI_STATUSES_IGNORE);
}

TEST(Communicator, CopiesOutliveTheFirst)
{
  std::optional<Communicator> first(MPI_COMM_WORLD);
  const Communicator          copy = *first;
  first.reset();
  EXPECT_EQ(copy.sum(1), copy.size());
}

TEST(Communicator, AllThrowTheErrorOfTheLowestRank)
{
  const Communicator all(MPI_COMM_WORLD);
  for (int failing = 0; failing < all.size(); ++failing)
    try
      {
        all.collectively([&] {
          if (all.rank() >= failing)
            throw DiskError("rank " + std::to_string(all.rank()));
        });
        FAIL() << "nothing was thrown";
      }
    catch (const Error &error)
      {
        EXPECT_EQ(error.exit_code, ExitCode::disk_error);
        EXPECT_EQ(error.what(), "rank " + std::to_string(failing));
      }
}

TEST(Communicator, UnforeseenExceptionsReachAll)
{
  const Communicator all(MPI_COMM_WORLD);
  if (all.size() == 1)
    {
      // Alone, nobody else has to learn of it.
      EXPECT_THROW(all.collectively([] { throw std::out_of_range("x"); }),
                   std::out_of_range);
      return;
    }
  const auto expect = [&](const std::string &message, const auto &f) {
    try
      {
        all.collectively([&] {
          if (all.rank() == 1)
            f();
        });
        FAIL() << "nothing was thrown";
      }
    catch (const Error &error)
      {
        EXPECT_EQ(error.exit_code, ExitCode::run_error);
        EXPECT_EQ(error.what(), message);
      }
  };
  expect("rift has failed in a way that it does not foresee. Please report "
         "this: index 5",
         [] { throw std::out_of_range("index 5"); });
  expect("the memory of this machine is too small for this scene. Use larger "
         "elements.",
         [] { throw std::bad_alloc(); });
}

TEST(Communicator, OnlyTheRootActs)
{
  const Communicator all(MPI_COMM_WORLD);
  int                calls = 0;
  all.on_root([&] { ++calls; });
  EXPECT_EQ(calls, all.is_root() ? 1 : 0);
  EXPECT_THROW(all.on_root([] { throw InputError("bad"); }), Error);
}

TEST(Communicator, CountsOfMpi)
{
  EXPECT_EQ(mpi_count(2147483647), 2147483647);
  try
    {
      mpi_count(2147483648u);
      FAIL() << "nothing was thrown";
    }
  catch (const RunError &error)
    {
      EXPECT_STREQ(error.what(),
                   "a rank has 2147483648 bytes to send at once; MPI takes "
                   "2147483647. Start rift on more ranks.");
    }
}
