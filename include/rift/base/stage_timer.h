#ifndef rift_base_stage_timer_h
#define rift_base_stage_timer_h

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace rift
{
  /** Wall time spent in each stage of the step. */
  class StageTimer
  {
  public:
    StageTimer()
      : begin(Clock::now())
    {
    }

    /** Counts the time since the last call, or since the start, to a stage. */
    void
    stop(const std::string &stage)
    {
      const auto   now     = Clock::now();
      const double seconds = std::chrono::duration<double>(now - begin).count();
      begin                = now;
      for (auto &[name, sum] : sums)
        if (name == stage)
          {
            sum += seconds;
            return;
          }
      sums.emplace_back(stage, seconds);
    }

    /** Names and seconds, in the order of their first occurrence. */
    const std::vector<std::pair<std::string, double>> &
    seconds() const
    {
      return sums;
    }

    /** Seconds of one stage. */
    double
    seconds_of(const std::string &stage) const
    {
      for (const auto &[name, sum] : sums)
        if (name == stage)
          return sum;
      return 0;
    }

    double
    total() const
    {
      double sum = 0;
      for (const auto &stage : sums)
        sum += stage.second;
      return sum;
    }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point                           begin;
    std::vector<std::pair<std::string, double>> sums;
  };
} // namespace rift

#endif
