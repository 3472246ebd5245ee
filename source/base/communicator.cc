#include <rift/base/communicator.h>
#include <rift/base/exceptions.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace rift
{
  namespace
  {
    /** MPI counts bytes with an int: longer texts go in pieces of this. */
    constexpr std::size_t largest_piece = std::numeric_limits<int>::max();

    /** One tag for each way in which messages go between pairs of ranks. */
    constexpr int exchange_tag = 1, bytes_tag = 2;

    MPI_Comm
    duplicate_of(const MPI_Comm original)
    {
      MPI_Comm duplicate;
      MPI_Comm_dup(original, &duplicate);
      return duplicate;
    }

    void
    free_communicator(const MPI_Comm *communicator)
    {
      // Objects of static lifetime outlive MPI, and with it this one.
      int is_finalized = 0;
      MPI_Finalized(&is_finalized);
      MPI_Comm copy = *communicator;
      if (is_finalized == 0)
        MPI_Comm_free(&copy);
      delete communicator;
    }

    /** Texts of all ranks that have come one after the other. */
    std::vector<std::string>
    cut(const std::string &all, const std::vector<int> &counts)
    {
      std::vector<std::string> result;
      std::size_t              begin = 0;
      for (const int count : counts)
        {
          result.push_back(all.substr(begin, count));
          begin += count;
        }
      return result;
    }

    std::vector<int>
    begins_of(const std::vector<int> &counts)
    {
      std::vector<int> begins;
      std::size_t      begin = 0;
      for (const int count : counts)
        {
          begins.push_back(static_cast<int>(begin));
          begin += count;
        }
      if (begin > largest_piece)
        throw RunError("the ranks have " + std::to_string(begin) +
                       " bytes to gather at once; MPI takes " +
                       std::to_string(largest_piece) +
                       ". The mesh is too large.");
      return begins;
    }
  } // namespace

  int
  mpi_count(const std::size_t n_bytes)
  {
    if (n_bytes > largest_piece)
      throw RunError("a rank has " + std::to_string(n_bytes) +
                     " bytes to send at once; MPI takes " +
                     std::to_string(largest_piece) +
                     ". Start rift on more ranks.");
    return static_cast<int>(n_bytes);
  }

  Communicator::Communicator(const MPI_Comm original)
    : duplicate(new MPI_Comm(duplicate_of(original)), free_communicator)
    , communicator(*duplicate)
  {
    MPI_Comm_rank(communicator, &own_rank);
    MPI_Comm_size(communicator, &n_ranks);
  }

  void
  Communicator::sum(std::vector<std::int64_t> &numbers) const
  {
    if (n_ranks > 1)
      MPI_Allreduce(MPI_IN_PLACE,
                    numbers.data(),
                    static_cast<int>(numbers.size()),
                    MPI_INT64_T,
                    MPI_SUM,
                    communicator);
  }

  std::int64_t
  Communicator::sum(const std::int64_t number) const
  {
    std::vector<std::int64_t> numbers = {number};
    sum(numbers);
    return numbers[0];
  }

  double
  Communicator::max(double number) const
  {
    if (n_ranks > 1)
      MPI_Allreduce(MPI_IN_PLACE,
                    &number,
                    1,
                    MPI_DOUBLE,
                    MPI_MAX,
                    communicator);
    return number;
  }

  bool
  Communicator::any(const bool value) const
  {
    return sum(value ? 1 : 0) > 0;
  }

  std::map<int, std::string>
  Communicator::exchange(const std::map<int, std::string> &messages) const
  {
    if (n_ranks == 1)
      return messages;
    // -1 where there is no message, which may also be empty.
    std::vector<int> sent(n_ranks, -1), received(n_ranks);
    for (const auto &[rank, bytes] : messages)
      sent[rank] = mpi_count(bytes.size());
    MPI_Alltoall(sent.data(),
                 1,
                 MPI_INT,
                 received.data(),
                 1,
                 MPI_INT,
                 communicator);
    std::map<int, std::size_t> sizes;
    for (int rank = 0; rank < n_ranks; ++rank)
      if (received[rank] >= 0)
        sizes[rank] = received[rank];
    return start_exchange(messages, sizes).finish();
  }

  PendingExchange &
  PendingExchange::operator=(PendingExchange &&other) noexcept
  {
    finish();
    sent     = std::move(other.sent);
    received = std::move(other.received);
    requests = std::move(other.requests);
    return *this;
  }

  PendingExchange::~PendingExchange()
  {
    finish();
  }

  std::map<int, std::string>
  PendingExchange::finish()
  {
    if (!requests.empty())
      MPI_Waitall(static_cast<int>(requests.size()),
                  requests.data(),
                  MPI_STATUSES_IGNORE);
    requests.clear();
    sent.clear();
    return std::exchange(received, {});
  }

  PendingExchange
  Communicator::start_exchange(std::map<int, std::string>        messages,
                               const std::map<int, std::size_t> &sizes) const
  {
    PendingExchange result;
    if (n_ranks == 1)
      {
        result.received = std::move(messages);
        return result;
      }
    // What is in a map stays in its place when this is moved.
    result.sent = std::move(messages);
    for (const auto &[rank, size] : sizes)
      {
        std::string &bytes = result.received[rank];
        bytes.resize(size);
        result.requests.emplace_back();
        MPI_Irecv(bytes.data(),
                  mpi_count(size),
                  MPI_BYTE,
                  rank,
                  exchange_tag,
                  communicator,
                  &result.requests.back());
      }
    for (const auto &[rank, bytes] : result.sent)
      {
        result.requests.emplace_back();
        MPI_Isend(bytes.data(),
                  mpi_count(bytes.size()),
                  MPI_BYTE,
                  rank,
                  exchange_tag,
                  communicator,
                  &result.requests.back());
      }
    return result;
  }

  std::vector<std::string>
  Communicator::all_gather(const std::string &bytes) const
  {
    if (n_ranks == 1)
      return {bytes};
    const int        count = mpi_count(bytes.size());
    std::vector<int> counts(n_ranks);
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
    const std::vector<int> begins = begins_of(counts);
    std::string all(static_cast<std::size_t>(begins.back()) + counts.back(),
                    '\0');
    MPI_Allgatherv(bytes.data(),
                   count,
                   MPI_BYTE,
                   all.data(),
                   counts.data(),
                   begins.data(),
                   MPI_BYTE,
                   communicator);
    return cut(all, counts);
  }

  std::vector<std::string>
  Communicator::gather(const std::string &bytes) const
  {
    if (n_ranks == 1)
      return {bytes};
    const int        count = mpi_count(bytes.size());
    std::vector<int> counts(n_ranks), begins;
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, communicator);
    begins = begins_of(counts);
    std::string all;
    if (is_root())
      all.resize(static_cast<std::size_t>(begins.back()) + counts.back());
    MPI_Gatherv(bytes.data(),
                count,
                MPI_BYTE,
                all.data(),
                counts.data(),
                begins.data(),
                MPI_BYTE,
                0,
                communicator);
    return is_root() ? cut(all, counts) : std::vector<std::string>();
  }

  void
  Communicator::broadcast(std::string &bytes) const
  {
    if (n_ranks == 1)
      return;
    std::uint64_t size = bytes.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, communicator);
    bytes.resize(size);
    for (std::size_t begin = 0; begin < size; begin += largest_piece)
      MPI_Bcast(bytes.data() + begin,
                static_cast<int>(std::min(largest_piece, size - begin)),
                MPI_BYTE,
                0,
                communicator);
  }

  void
  Communicator::send(const std::string &bytes, const int to) const
  {
    const std::uint64_t size = bytes.size();
    MPI_Send(&size, 1, MPI_UINT64_T, to, bytes_tag, communicator);
    for (std::size_t begin = 0; begin < size; begin += largest_piece)
      MPI_Send(bytes.data() + begin,
               static_cast<int>(std::min(largest_piece, size - begin)),
               MPI_BYTE,
               to,
               bytes_tag,
               communicator);
  }

  std::string
  Communicator::receive(const int from) const
  {
    std::uint64_t size = 0;
    MPI_Recv(&size,
             1,
             MPI_UINT64_T,
             from,
             bytes_tag,
             communicator,
             MPI_STATUS_IGNORE);
    std::string bytes(size, '\0');
    for (std::size_t begin = 0; begin < size; begin += largest_piece)
      MPI_Recv(bytes.data() + begin,
               static_cast<int>(std::min(largest_piece, size - begin)),
               MPI_BYTE,
               from,
               bytes_tag,
               communicator,
               MPI_STATUS_IGNORE);
    return bytes;
  }

  void
  Communicator::gather_in_turn(
    const std::string                              &bytes,
    const std::function<void(const std::string &)> &take) const
  {
    if (!is_root())
      {
        send(bytes, 0);
        return;
      }
    take(bytes);
    for (int rank = 1; rank < n_ranks; ++rank)
      take(receive(rank));
  }

  void
  Communicator::collectively(const std::function<void()> &f) const
  {
    // The exit code and the message; empty where all went well.
    std::string failure;
    try
      {
        f();
      }
    catch (const std::exception &exception)
      {
        if (n_ranks == 1)
          throw;
        const Error error = to_error(exception);
        failure = static_cast<char>('0' + static_cast<int>(error.exit_code)) +
                  std::string(error.what());
      }
    if (n_ranks == 1 || !any(!failure.empty()))
      return;
    for (const std::string &one : all_gather(failure))
      if (!one.empty())
        throw CollectiveError(static_cast<ExitCode>(one[0] - '0'),
                              one.substr(1));
  }

  void
  Communicator::on_root(const std::function<void()> &f) const
  {
    collectively([&] {
      if (is_root())
        f();
    });
  }
} // namespace rift
