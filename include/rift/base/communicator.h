#ifndef rift_base_communicator_h
#define rift_base_communicator_h

#include <rift/base/bytes.h>

#include <mpi.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace rift
{
  /** A number of bytes as MPI counts them. Throws RunError if it is too large.
   */
  int
  mpi_count(std::size_t n_bytes);

  /** Messages that are under way. */
  class PendingExchange
  {
  public:
    PendingExchange() = default;

    /** Can be moved, but not copied. */
    PendingExchange(PendingExchange &&) noexcept = default;

    /** Waits for its own messages first. */
    PendingExchange &
    operator=(PendingExchange &&other) noexcept;

    /** Waits. */
    ~PendingExchange();

    /** Waits for what each rank has sent. To be called once. */
    std::map<int, std::string>
    finish();

  private:
    friend class Communicator;

    std::map<int, std::string> sent, received;
    std::vector<MPI_Request>   requests;
  };

  /**
   * The ranks that compute a scene together. What is called *collective* must
   * be called on all of them in the same order. `Communicator()` never calls
   * MPI, so that it works where MPI has not been started.
   */
  class Communicator
  {
  public:
    /** This process alone. */
    Communicator() = default;

    /**
     * The ranks of an MPI communicator. This object and its copies use a
     * duplicate, so that their messages never meet those that the program which
     * rift is a part of sends on `original`. Collective.
     */
    explicit Communicator(MPI_Comm original);

    /** The number of this rank, from 0. */
    int
    rank() const
    {
      return own_rank;
    }

    /** Number of ranks. */
    int
    size() const
    {
      return n_ranks;
    }

    /** Rank 0 reads the scene, speaks and writes the histories. */
    bool
    is_root() const
    {
      return own_rank == 0;
    }

    /** For calls of MPI, and of libraries that make them. */
    MPI_Comm
    mpi() const
    {
      return communicator;
    }

    /** Replaces each number by its sum over the ranks. Collective. */
    void
    sum(std::vector<std::int64_t> &numbers) const;

    /** Sum of a number over the ranks. Collective. */
    std::int64_t
    sum(std::int64_t number) const;

    /** Largest of all ranks. Collective. */
    double
    max(double number) const;

    /** Whether the value is true on any rank. Collective. */
    bool
    any(bool value) const;

    /**
     * Sends each of these bytes to the rank of its key; returns what has come
     * from each rank that has sent something. Collective.
     */
    std::map<int, std::string>
    exchange(const std::map<int, std::string> &messages) const;

    /**
     * Begins an exchange in which each rank knows how many bytes come from
     * which ranks: the others need not call. Does not wait.
     */
    PendingExchange
    start_exchange(std::map<int, std::string>        messages,
                   const std::map<int, std::size_t> &sizes) const;

    /** The same for plain data of type T. Collective. */
    template <typename T>
    std::map<int, std::vector<T>>
    exchange(const std::map<int, std::vector<T>> &data) const
    {
      std::map<int, std::string> messages;
      for (const auto &[rank, values] : data)
        messages[rank] = to_bytes(values);
      std::map<int, std::vector<T>> received;
      for (const auto &[rank, bytes] : exchange(messages))
        received[rank] = from_bytes<T>(bytes);
      return received;
    }

    /** The bytes of all ranks, on all ranks, by rank. Collective. */
    std::vector<std::string>
    all_gather(const std::string &bytes) const;

    /**
     * The object of all ranks that comes first, on all ranks. Collective.
     *
     * @tparam T trivially copyable.
     * @param comes_before whether the first of two objects comes before the
     *   second; must tell any two different objects apart.
     */
    template <typename T, typename Function>
    T
    first_of_ranks(const T &own, const Function &comes_before) const
    {
      T first = own;
      for (const std::string &bytes : all_gather(object_to_bytes(own)))
        {
          const T other = object_from_bytes<T>(bytes);
          if (comes_before(other, first))
            first = other;
        }
      return first;
    }

    /** The bytes of all ranks on rank 0; empty elsewhere. Collective. */
    std::vector<std::string>
    gather(const std::string &bytes) const;

    /** The bytes of rank 0 on all ranks. Collective. */
    void
    broadcast(std::string &bytes) const;

    /** Sends bytes, however many, to a rank, which must receive() them. */
    void
    send(const std::string &bytes, int to) const;

    /** Waits for what a rank has sent with send(). */
    std::string
    receive(int from) const;

    /**
     * Calls `take` on rank 0 with the bytes of each rank, however many, in the
     * order of the ranks; one of them is in memory at a time. Collective.
     */
    void
    gather_in_turn(const std::string                              &bytes,
                   const std::function<void(const std::string &)> &take) const;

    /**
     * Calls `f` on each rank; where it throws on any of them, all throw the
     * Error of the lowest of these ranks: as a CollectiveError where there are
     * several. What is no Error becomes one by to_error(). Collective.
     */
    void
    collectively(const std::function<void()> &f) const;

    /** collectively(), but only rank 0 calls `f`. Collective. */
    void
    on_root(const std::function<void()> &f) const;

  private:
    /** Frees the duplicate with the last copy of this object. */
    std::shared_ptr<const MPI_Comm> duplicate;

    MPI_Comm communicator = MPI_COMM_SELF;
    int      own_rank = 0, n_ranks = 1;
  };
} // namespace rift

#endif
