#ifndef rift_app_run_record_h
#define rift_app_run_record_h

#include <rift/base/stage_timer.h>

#include <cstdint>
#include <optional>

namespace rift
{
  /**
   * Decides when the cells are divided anew among the ranks. A division that
   * does not cure the imbalance is not repeated at once: the number of
   * checkpoints that it waits for doubles each time.
   */
  class RepartitionPolicy
  {
  public:
    /** To be asked at each checkpoint.
     * @param is_unbalanced whether ranks have unequal work. */
    bool
    repartitions(const bool is_unbalanced)
    {
      if (!is_unbalanced)
        {
          n_to_wait = 0;
          next_wait = 1;
          return false;
        }
      if (n_to_wait > 0)
        {
          --n_to_wait;
          return false;
        }
      n_to_wait = next_wait;
      next_wait = 2 * next_wait + 1;
      return true;
    }

  private:
    std::uint64_t n_to_wait = 0, next_wait = 1;
  };

  /** What a run knows of itself beyond one division of its cells. */
  struct RunRecord
  {
    /** The times of the stages, and when cells are divided anew. */
    StageTimer        timer;
    RepartitionPolicy division;

    /** Step at which this program has begun to compute; empty before. */
    std::optional<std::uint64_t> first_step;

    /** Wall time of setting up until then, s. */
    double seconds_before_steps = 0;
  };
} // namespace rift

#endif
