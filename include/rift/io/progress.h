#ifndef rift_io_progress_h
#define rift_io_progress_h

#include <rift/io/log.h>

#include <cstdint>
#include <functional>
#include <string>

namespace rift
{
  /**
   * Tells how far a run has come: on an interactive terminal a bar in the last
   * line, ten times a second; otherwise a line in the log whenever another
   * tenth of the run is done or half a minute has passed.
   */
  class Progress
  {
  public:
    /** Seconds since some moment in the past. */
    using Clock = std::function<double()>;

    /**
     * The run begins now.
     *
     * @param log        where to tell it; it must outlive this object.
     * @param n_cells    of the whole mesh, for the rate.
     * @param start_step the step now; not 0 after a restart.
     * @param start_time the simulated time now, s.
     * @param end_time   of the simulation, s.
     * @param clock      the time of day, which a test may replace.
     */
    Progress(Log          &log,
             std::uint64_t n_cells,
             std::uint64_t start_step,
             double        start_time,
             double        end_time,
             const Clock  &clock = steady_clock());

    /**
     * To be called after each step; most calls only look at the clock.
     *
     * @param step of the whole simulation.
     * @param time the simulated time, s.
     */
    void
    update(std::uint64_t step, double time);

    /** Takes the bar away. */
    void
    finish();

    /** A clock that never goes back. */
    static Clock
    steady_clock();

  private:
    /** The numbers behind the bar, such as "step 120  time 3.00e-06 s". */
    std::string
    numbers(std::uint64_t step, double fraction, double time) const;

    Log          &log;
    std::uint64_t n_cells;
    std::uint64_t start_step;
    double        start_time;
    double        end_time;
    Clock         clock;
    double        wall_start;

    /** When something was last told, s, and how many tenths were done. */
    double       wall_last;
    unsigned int tenths_last;
  };

  /** A duration for people: "7 s", "2:05 min", "3:20 h", "2.5 d". */
  std::string
  duration_text(double seconds);
} // namespace rift

#endif
