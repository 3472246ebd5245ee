#include <rift/base/signals.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{
  using namespace rift;

  volatile std::sig_atomic_t n_received = 0;

  extern "C" void
  count(int)
  {
    n_received = n_received + 1;
  }
} // namespace

TEST(StopSignals, AreRememberedWhileItLives)
{
  for (const int signal : {SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU, SIGHUP, SIGINT})
    {
      std::signal(signal, count);
      n_received = 0;
      {
        const StopSignals signals;
        EXPECT_FALSE(signals.requested());
        std::raise(signal);
        EXPECT_TRUE(signals.requested());
        if (signal != SIGINT)
          std::raise(signal);
        EXPECT_TRUE(signals.requested());
        EXPECT_EQ(n_received, 0);
      }
      std::raise(signal);
      EXPECT_EQ(n_received, 1);
      std::signal(signal, SIG_DFL);
      EXPECT_FALSE(StopSignals().requested());
    }
}

TEST(StopSignals, SecondInterruptEndsTheProgram)
{
  for (const int first : {SIGINT, SIGTERM})
    EXPECT_EXIT(
      {
        const StopSignals signals;
        std::raise(first);
        std::raise(SIGINT);
        std::exit(0);
      },
      testing::KilledBySignal(SIGINT),
      "");
}

TEST(StopSignals, IgnoredSignalsOfATerminalStayIgnored)
{
  for (const int signal : {SIGINT, SIGHUP})
    {
      std::signal(signal, SIG_IGN);
      {
        const StopSignals signals;
        std::raise(signal);
        EXPECT_FALSE(signals.requested());
      }
      EXPECT_EQ(std::signal(signal, SIG_DFL), SIG_IGN);
    }
}

TEST(StopSignals, IgnoredSignalsOfBatchSystemsAreRemembered)
{
  for (const int signal : {SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU})
    {
      std::signal(signal, SIG_IGN);
      {
        const StopSignals signals;
        std::raise(signal);
        EXPECT_TRUE(signals.requested());
      }
      EXPECT_EQ(std::signal(signal, SIG_DFL), SIG_IGN);
    }
}

TEST(StopSignals, LeaveOthersAlone)
{
  std::signal(SIGWINCH, count);
  n_received = 0;
  const StopSignals signals;
  std::raise(SIGWINCH);
  EXPECT_FALSE(signals.requested());
  EXPECT_EQ(n_received, 1);
  std::signal(SIGWINCH, SIG_DFL);
}
