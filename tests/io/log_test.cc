#include <rift/base/exceptions.h>
#include <rift/io/log.h>
#include <rift/io/progress.h>

#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

using namespace rift;

TEST(Log, GoesToTerminalAndFile)
{
  const TemporaryDirectory directory;
  std::ostringstream       terminal;
  Log                      log(&terminal);
  log.write("rift 0.1.0");
  log.open(directory / "log.txt");
  log.write("mesh: 12 cells");
  EXPECT_EQ(terminal.str(), "rift 0.1.0\nmesh: 12 cells\n");
  EXPECT_EQ(read_file(directory / "log.txt"), terminal.str());
}

TEST(Log, GoesOnAfterARestart)
{
  const TemporaryDirectory directory;
  for (const char *line : {"first", "second"})
    {
      Log log(nullptr);
      log.write(line);
      log.reopen(directory / "log.txt");
    }
  EXPECT_EQ(read_file(directory / "log.txt"), "first\nsecond\n");
}

TEST(Log, KnowsItsWarningsAfterARestart)
{
  const TemporaryDirectory directory;
  {
    Log log(nullptr);
    log.warn("first");
    log.write("a line with WARNING: inside");
    log.open(directory / "log.txt");
    log.warn("second");
  }
  Log log(nullptr);
  log.warn("second");
  log.reopen(directory / "log.txt");
  log.warn("third");
  log.warn("third");
  const std::vector<std::string> expected = {"second", "first", "third"};
  EXPECT_EQ(log.warnings(), expected);
  EXPECT_EQ(read_file(directory / "log.txt"),
            "WARNING: first\na line with WARNING: inside\nWARNING: second\n"
            "WARNING: second\nWARNING: third\nWARNING: third\n");
}

TEST(Log, WarnsOnceOfASubject)
{
  const TemporaryDirectory directory;
  {
    Log log(nullptr);
    log.open(directory / "log.txt");
    log.warn_once({"the load on \"a\"", " acts on 2 faces"});
    log.warn_once({"the load on \"a\"", " acts on 3 faces"});
  }
  Log log(nullptr);
  log.reopen(directory / "log.txt");
  log.warn_once({"the load on \"a\"", " acts on 4 faces"});
  log.warn_once({"the load on \"b\"", " acts on 5 faces"});
  EXPECT_EQ(read_file(directory / "log.txt"),
            "WARNING: the load on \"a\" acts on 2 faces\n"
            "WARNING: the load on \"b\" acts on 5 faces\n");
}

TEST(Log, Quiet)
{
  const TemporaryDirectory directory;
  Log                      log(nullptr, true);
  EXPECT_FALSE(log.is_interactive());
  log.open(directory / "log.txt");
  log.status("bar");
  log.write("line");
  EXPECT_EQ(read_file(directory / "log.txt"), "line\n");
}

TEST(Log, LineReplacesStatus)
{
  std::ostringstream terminal;
  Log                log(&terminal, true);
  log.status("one");
  log.status("two");
  log.write("line");
  log.write("next");
  EXPECT_EQ(terminal.str(), "\r\033[Kone\r\033[Ktwo\r\033[Kline\nnext\n");
}

TEST(Log, NoStatusInAFile)
{
  std::ostringstream terminal;
  Log                log(&terminal, false);
  log.status("bar");
  EXPECT_EQ(terminal.str(), "");
}

TEST(Log, FullDisk)
{
  Log log(nullptr);
  log.open("/dev/full");
  log.check();
  log.write("x");
  EXPECT_TRUE(log.has_failed());
  EXPECT_EQ(message_of<DiskError>([&] { log.check(); }),
            "Cannot write /dev/full: No space left on device. Make room on "
            "this disk, or write to another one.");
}

namespace
{
  unsigned int
  count_lines(const std::string &text)
  {
    return std::count(text.begin(), text.end(), '\n');
  }
} // namespace

TEST(Progress, LineForEachTenth)
{
  std::ostringstream terminal;
  Log                log(&terminal);
  double             wall = 100;
  Progress           progress(log, 2000000, 0, 0, 1e-4, [&] { return wall; });
  for (unsigned int step = 1; step <= 1000; ++step)
    {
      wall += 0.01;
      progress.update(step, step * 1e-7);
    }
  EXPECT_EQ(count_lines(terminal.str()), 10u);
  // 100 steps of 2 million cells in 1 s, 900 steps to go.
  EXPECT_EQ(terminal.str().substr(0, terminal.str().find('\n')),
            "  10 %  step 100  time 1.000e-05 s  200 M cells/s  ETA 9 s");
}

TEST(Progress, LineEveryHalfMinute)
{
  std::ostringstream terminal;
  Log                log(&terminal);
  double             wall = 0;
  Progress           progress(log, 1000, 0, 0, 1, [&] { return wall; });
  for (unsigned int step = 1; step <= 95; ++step)
    {
      wall += 1;
      progress.update(step, 1e-5 * step);
    }
  EXPECT_EQ(count_lines(terminal.str()), 3u);
}

TEST(Progress, AfterARestart)
{
  std::ostringstream terminal;
  Log                log(&terminal);
  double             wall = 0;
  Progress           progress(log, 1000, 30, 3, 4, [&] { return wall; });
  wall = 10;
  progress.update(40, 3.5);
  EXPECT_EQ(terminal.str(),
            "  87 %  step 40  time 3.500e+00 s  0.001 M cells/s  ETA 10 s\n");
}

TEST(Progress, BarOnATerminal)
{
  std::ostringstream terminal;
  Log                log(&terminal, true);
  double             wall = 0;
  Progress           progress(log, 1000000, 0, 0, 1, [&] { return wall; });
  for (unsigned int step = 1; step <= 50; ++step)
    {
      wall += 1. / 32;
      progress.update(step, 0.01 * step);
    }
  const std::string text = terminal.str();
  EXPECT_EQ(count_lines(text), 0u);
  const unsigned int n_updates = std::count(text.begin(), text.end(), '\r');
  // Every fourth step is more than 0.1 s after the one before.
  EXPECT_EQ(n_updates, 12u);
  const std::string last = text.substr(text.rfind('\r') + 4);
  EXPECT_EQ(last.substr(0, 10), "[=======  ");
  EXPECT_LE(last.size(), 79u);
  progress.finish();
  EXPECT_EQ(terminal.str(), text + "\r\033[K");
}

TEST(Progress, NothingToDo)
{
  std::ostringstream terminal;
  Log                log(&terminal);
  Progress           progress(log, 1, 7, 1, 1, [] { return 0.; });
  progress.update(7, 1);
  EXPECT_EQ(terminal.str(), "");
}

TEST(Progress, Durations)
{
  EXPECT_EQ(duration_text(-1), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(125), "2:05 min");
  EXPECT_EQ(duration_text(3 * 3600 + 20 * 60), "3:20 h");
  EXPECT_EQ(duration_text(2.5 * 86400), "2.5 d");
  EXPECT_EQ(duration_text(1e30), "more than 100 d");
}
