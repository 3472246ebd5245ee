#include <rift/io/progress.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace rift
{
  namespace
  {
    /** printf into a string. */
    template <typename... Arguments>
    std::string
    format(const char *pattern, const Arguments... arguments)
    {
      char buffer[128];
      std::snprintf(buffer, sizeof(buffer), pattern, arguments...);
      return buffer;
    }

    unsigned int
    tenths_of(const double fraction)
    {
      // Steps do not add up to tenths exactly.
      return static_cast<unsigned int>(10 * fraction + 1e-9);
    }

    std::string
    bar(const double fraction)
    {
      constexpr int width = 16;
      const int     done  = static_cast<int>(width * fraction);
      return '[' + std::string(done, '=') + std::string(width - done, ' ') +
             ']';
    }
  } // namespace

  Progress::Progress(Log                &log,
                     const std::uint64_t n_cells,
                     const std::uint64_t start_step,
                     const double        start_time,
                     const double        end_time,
                     const Clock        &clock)
    : log(log)
    , n_cells(n_cells)
    , start_step(start_step)
    , start_time(start_time)
    , end_time(end_time)
    , clock(clock)
    , wall_start(clock())
    , wall_last(wall_start)
    , tenths_last(tenths_of(start_time / end_time))
  {
  }

  Progress::Clock
  Progress::steady_clock()
  {
    return [] {
      const auto now = std::chrono::steady_clock::now().time_since_epoch();
      return std::chrono::duration<double>(now).count();
    };
  }

  void
  Progress::update(const std::uint64_t step, const double time)
  {
    const double       fraction = std::min(time / end_time, 1.);
    const unsigned int tenths   = tenths_of(fraction);
    const double       wall     = clock();

    if (log.is_interactive() ? wall - wall_last < 0.1 :
                               tenths == tenths_last && wall - wall_last < 30)
      return;
    wall_last   = wall;
    tenths_last = tenths;

    const std::string text = numbers(step, fraction, time);
    if (log.is_interactive())
      log.status(bar(fraction) + text);
    else
      log.write(text);
  }

  std::string
  Progress::numbers(const std::uint64_t step,
                    const double        fraction,
                    const double        time) const
  {
    const double elapsed = clock() - wall_start;
    std::string  text    = format("%4.0f %%  step %llu  time %.3e s",
                              std::floor(100 * fraction + 1e-9),
                              static_cast<unsigned long long>(step),
                              time);
    if (elapsed > 0)
      text += format("  %.3g M cells/s",
                     1e-6 * n_cells * (step - start_step) / elapsed);
    if (time > start_time)
      text += "  ETA " +
              duration_text(elapsed * (end_time - time) / (time - start_time));
    return text;
  }

  void
  Progress::finish()
  {
    log.status("");
  }

  std::string
  duration_text(const double seconds)
  {
    if (!(seconds < 100 * 86400.))
      return "more than 100 d";
    const auto whole = static_cast<unsigned int>(std::max(seconds, 0.) + 0.5);
    if (whole < 60)
      return format("%u s", whole);
    if (whole < 3600)
      return format("%u:%02u min", whole / 60, whole % 60);
    if (whole < 86400)
      return format("%u:%02u h", whole / 3600, whole % 3600 / 60);
    return format("%.1f d", seconds / 86400);
  }
} // namespace rift
