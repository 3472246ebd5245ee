#ifndef rift_base_signals_h
#define rift_base_signals_h

#include <csignal>
#include <vector>

namespace rift
{
  /**
   * While it lives, signals no longer end the program but are remembered, for
   * the run to stop in good order at the end of a step: those that batch systems
   * send shortly before the time of a job is over (SIGTERM, SIGUSR1, SIGUSR2),
   * SIGXCPU, which comes when the processor time is used up (`ulimit -t`),
   * SIGHUP, when the terminal has gone, and SIGINT, which is Ctrl-C and ends the
   * program at once when a signal is being remembered already. If one of the
   * latter two was ignored before, as in the background of a script or under
   * nohup, it still is.
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
