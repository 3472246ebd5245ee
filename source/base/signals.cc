#include <rift/base/signals.h>

namespace rift
{
  namespace
  {
    constexpr int stop_signals[] =
      {SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU, SIGHUP, SIGINT};

    /** Those that come from a terminal: a script may have put rift beyond it. */
    bool
    may_stay_ignored(const int signal)
    {
      return signal == SIGINT || signal == SIGHUP;
    }

    // A handler gets no argument of ours, and may only touch this type.
    volatile std::sig_atomic_t was_received = 0;

    extern "C" void
    remember_signal(const int signal)
    {
      if (signal == SIGINT && was_received != 0)
        {
          // Comes again when the handler returns, and ends the program.
          std::signal(SIGINT, SIG_DFL);
          std::raise(SIGINT);
        }
      was_received = 1;
    }
  } // namespace

  StopSignals::StopSignals()
  {
    was_received            = 0;
    struct sigaction action = {};
    action.sa_handler       = remember_signal;
    // Calls to the system that wait, such as writing, are not broken off.
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int signal : stop_signals)
      {
        struct sigaction old_action = {};
        sigaction(signal, &action, &old_action);
        if (may_stay_ignored(signal) && old_action.sa_handler == SIG_IGN)
          sigaction(signal, &old_action, nullptr);
        old_actions.push_back(old_action);
      }
  }

  StopSignals::~StopSignals()
  {
    for (std::size_t i = 0; i < old_actions.size(); ++i)
      sigaction(stop_signals[i], &old_actions[i], nullptr);
  }

  bool
  StopSignals::requested() const
  {
    return was_received != 0;
  }
} // namespace rift
