#ifndef rift_base_signals_h
#define rift_base_signals_h

#include <csignal>
#include <vector>

namespace rift
{
  /**
   * While it lives, SIGTERM, SIGUSR1 and SIGINT no longer end the program but
   * are remembered, for the run to stop in good order at the end of a step.
   * Batch systems send the first two shortly before the time of a job is over;
   * the third is Ctrl-C, and ends the program at once when a signal is being
   * remembered already. If it was ignored before, as in the background of a
   * script, it still is.
   *
   * Only one at a time. Ranks may receive a signal at different steps: what
   * follows from it is to be decided together, by Communicator::any().
   */
  class StopSignals
  {
  public:
    StopSignals();

    /** Puts the handlers back that were there before. */
    ~StopSignals();

    StopSignals(const StopSignals &) = delete;
    StopSignals &
    operator=(const StopSignals &) = delete;

    /** Whether one of them has come since the construction. */
    bool
    requested() const;

  private:
    /** What was done before on each signal. */
    std::vector<struct sigaction> old_actions;
  };
} // namespace rift

#endif
