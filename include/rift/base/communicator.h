#ifndef rift_base_communicator_h
#define rift_base_communicator_h

#include <mpi.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace rift
{
  /**
   * The ranks that compute a scene together. What is called *collective* must
   * be called on all of them in the same order. A communicator of one rank
   * never calls MPI, so that it works where MPI has not been started.
   */
  class Communicator
  {
  public:
    /** This process alone. */
    Communicator() = default;

    /** @param communicator must outlive this object. */
    explicit Communicator(MPI_Comm communicator);

    int
    rank() const
    {
      return own_rank;
    }

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

    MPI_Comm
    mpi() const
    {
      return communicator;
    }

    /** Replaces each number by its sum over the ranks. Collective. */
    void
    sum(std::vector<std::int64_t> &numbers) const;

    std::int64_t
    sum(std::int64_t number) const;

    /** Largest of all ranks. Collective. */
    double
    max(double number) const;

    bool
    any(bool value) const;

    /**
     * Sends each of these bytes to the rank of its key; returns what has come
     * from each rank that has sent something. Collective.
     */
    std::map<int, std::string>
    exchange(const std::map<int, std::string> &messages) const;

    /**
     * The same where each rank knows how many bytes come from which ranks: the
     * others need not call.
     */
    std::map<int, std::string>
    exchange(const std::map<int, std::string> &messages,
             const std::map<int, std::size_t> &sizes) const;

    /** The bytes of all ranks, on all ranks, by rank. Collective. */
    std::vector<std::string>
    all_gather(const std::string &bytes) const;

    /**
     * The object of all ranks that comes first, on all ranks. Collective.
     *
     * @tparam T trivially copyable.
     * @param comes_before(a, b) must tell any two different objects apart.
     */
    template <typename T, typename Function>
    T
    first_of_ranks(const T &own, const Function &comes_before) const
    {
      static_assert(std::is_trivially_copyable_v<T>);
      T first = own;
      for (const std::string &bytes :
           all_gather({reinterpret_cast<const char *>(&own), sizeof(T)}))
        {
          T other;
          std::memcpy(&other, bytes.data(), sizeof(T));
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
     * Calls `f` on each rank; where it throws an Error on any of them, all
     * throw that of the lowest rank: as a CollectiveError where there are
     * several ranks. Collective.
     */
    void
    together(const std::function<void()> &f) const;

    /** together(), but only rank 0 calls `f`. Collective. */
    void
    on_root(const std::function<void()> &f) const;

  private:
    MPI_Comm communicator = MPI_COMM_SELF;
    int      own_rank = 0, n_ranks = 1;
  };
} // namespace rift

#endif
