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
                     const double        start_time,
                     const double        end_time,
                     const Clock        &clock)
    : log(log)
    , n_cells(n_cells)
    , start_time(start_time)
    , end_time(end_time)
    , clock(clock)
    , wall_start(clock())
    , wall_last(wall_start)
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
  Progress::update(const std::uint64_t steps, const double time)
  {
    const double fraction =
      end_time > start_time ?
        std::clamp((time - start_time) / (end_time - start_time), 0., 1.) :
        1.;
    // Steps do not add up to tenths exactly.
    const unsigned int tenths = static_cast<unsigned int>(10 * fraction + 1e-9);
    const double       wall   = clock();

    if (log.is_interactive() ? wall - wall_last < 0.1 :
                               tenths == tenths_last && wall - wall_last < 30)
      return;
    wall_last   = wall;
    tenths_last = tenths;

    const std::string text = numbers(steps, fraction, time);
    if (log.is_interactive())
      log.status(bar(fraction) + text);
    else
      log.write(text);
  }

  std::string
  Progress::numbers(const std::uint64_t steps,
                    const double        fraction,
                    const double        time) const
  {
    const double elapsed = clock() - wall_start;
    std::string  text    = format("%4.0f %%  step %llu  time %.3e s",
                              std::floor(100 * fraction + 1e-9),
                              static_cast<unsigned long long>(steps),
                              time);
    if (elapsed > 0)
      text += format("  %.3g M cells/s", 1e-6 * n_cells * steps / elapsed);
    if (fraction > 0)
      text += "  ETA " + duration_text(elapsed * (1 - fraction) / fraction);
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
