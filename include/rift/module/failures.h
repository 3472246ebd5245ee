#ifndef rift_module_failures_h
#define rift_module_failures_h

#include <rift/base/communicator.h>
#include <rift/base/types.h>

#include <optional>
#include <string>

namespace rift
{
  /** Something that has gone wrong in one place, seen by one rank or some. */
  struct Failure
  {
    /** Number of the step, and the cell by which it is known. */
    std::uint64_t   step;
    GlobalCellIndex cell;

    /** What has happened, a clause, and what to do, a sentence. */
    std::string what, advice;
  };

  /**
   * The first failure on this rank. A rank that sees one goes on until all
   * ranks next agree, so that none waits for it in vain.
   */
  class Failures
  {
  public:
    /** Only the first one counts. */
    void
    note(Failure failure)
    {
      if (!first)
        first = std::move(failure);
    }

    /** Whether this rank has noted one. */
    bool
    any() const
    {
      return first.has_value();
    }

    /** The first failure of all ranks: of several in one step that of the
     * smallest cell. Collective. */
    std::optional<Failure>
    first_of_ranks(const Communicator &communicator) const;

  private:
    std::optional<Failure> first;
  };
} // namespace rift

#endif
