#ifndef rift_base_stage_timer_h
#define rift_base_stage_timer_h

#include <array>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace rift
{
  /** The parts of a run whose time is measured, in the order of a step. */
  enum class Stage
  {
    setup,
    insertion,
    internal_forces,
    cohesive_forces,
    contact,
    loads,
    output,
    motion,
    exchange,
    contact_search,
    checkpoints
  };

  /** Number of values of Stage. */
  constexpr std::size_t n_stages = 11;

  /** Its name in summary.json. */
  inline const char *
  name_of(const Stage stage)
  {
    constexpr std::array<const char *, n_stages> names = {{"setup",
                                                           "insertion",
                                                           "internal forces",
                                                           "cohesive forces",
                                                           "contact",
                                                           "loads and damping",
                                                           "ledger and output",
                                                           "kick and drift",
                                                           "exchange",
                                                           "contact search",
                                                           "checkpoints"}};
    return names[static_cast<std::size_t>(stage)];
  }

  /** Whether a rank works by itself in a stage, rather than wait for others. */
  inline bool
  is_local(const Stage stage)
  {
    return stage >= Stage::insertion && stage <= Stage::motion &&
           stage != Stage::output;
  }

  /** Wall time spent in each stage. */
  class StageTimer
  {
  public:
    StageTimer()
      : begin(Clock::now())
    {
    }

    /** Counts the time since the last call, or since the start, to a stage. */
    void
    stop(const Stage stage)
    {
      const auto now = Clock::now();
      sums[static_cast<std::size_t>(stage)] +=
        std::chrono::duration<double>(now - begin).count();
      begin = now;
    }

    /** Seconds of one stage. */
    double
    seconds(const Stage stage) const
    {
      return sums[static_cast<std::size_t>(stage)];
    }

    /** Seconds of all stages in which a rank works by itself. */
    double
    local_seconds() const
    {
      double sum = 0;
      for (std::size_t i = 0; i < n_stages; ++i)
        if (is_local(static_cast<Stage>(i)))
          sum += sums[i];
      return sum;
    }

    /** Names and seconds of the stages that have taken time. */
    std::vector<std::pair<std::string, double>>
    named_seconds() const
    {
      std::vector<std::pair<std::string, double>> result;
      for (std::size_t i = 0; i < n_stages; ++i)
        if (sums[i] > 0)
          result.emplace_back(name_of(static_cast<Stage>(i)), sums[i]);
      return result;
    }

    /** Time of all stages, s. */
    double
    total() const
    {
      double sum = 0;
      for (const double seconds : sums)
        sum += seconds;
      return sum;
    }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point            begin;
    std::array<double, n_stages> sums{};
  };
} // namespace rift

#endif
