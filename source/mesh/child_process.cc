#include <rift/base/exceptions.h>
#include <rift/mesh/child_process.h>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <new>
#include <unistd.h>
#include <vector>

namespace rift
{
  namespace
  {
    // The first byte that the child sends.
    constexpr char returned      = 'r';
    constexpr char input_error   = 'i';
    constexpr char failed        = 'f';
    constexpr char out_of_memory = 'm';

    void
    limit_memory(const std::size_t memory_limit)
    {
      // What is mapped already (MPI, sanitizers) comes on top.
      std::size_t   mapped_pages = 0;
      std::ifstream statm("/proc/self/statm");
      statm >> mapped_pages;
      const rlim_t page_size = sysconf(_SC_PAGESIZE);
      const rlim_t physical  = sysconf(_SC_PHYS_PAGES) * page_size;

      rlimit limit;
      getrlimit(RLIMIT_AS, &limit);
      limit.rlim_cur = std::min<rlim_t>(limit.rlim_max,
                                        mapped_pages * page_size +
                                          std::min(physical, memory_limit));
      setrlimit(RLIMIT_AS, &limit);
      // If memory does run short, this process is the one to go.
      std::ofstream("/proc/self/oom_score_adj") << 1000;
    }

    void
    detach_from_parent(const pid_t parent, const std::size_t memory_limit)
    {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != parent)
        _exit(1);
      for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2})
        std::signal(signal, SIG_DFL);
      // Handlers that print a stack trace would only hide what happened.
      for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL})
        std::signal(signal, SIG_DFL);

      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDOUT_FILENO);
      dup2(nowhere, STDERR_FILENO);

      const rlimit no_core_dump = {0, 0};
      setrlimit(RLIMIT_CORE, &no_core_dump);
      limit_memory(memory_limit);
    }

    void
    write_all(const int file, const std::string &bytes)
    {
      for (std::size_t n_written = 0; n_written < bytes.size();)
        {
          const ssize_t n =
            write(file, bytes.data() + n_written, bytes.size() - n_written);
          if (n < 0 && errno != EINTR)
            _exit(1);
          n_written += std::max<ssize_t>(n, 0);
        }
    }

    std::string
    read_all(const int file)
    {
      std::string       bytes;
      std::vector<char> buffer(1 << 16);
      while (true)
        {
          const ssize_t n = read(file, buffer.data(), buffer.size());
          if (n == 0 || (n < 0 && errno != EINTR))
            return bytes;
          if (n > 0)
            bytes.append(buffer.data(), n);
        }
    }

    [[noreturn]] void
    run_child(const std::function<std::string()> &work, const int file)
    {
      std::string answer;
      try
        {
          answer = returned + work();
        }
      catch (const InputError &error)
        {
          answer = std::string(1, input_error) + error.what();
        }
      catch (const std::bad_alloc &)
        {
          answer = out_of_memory;
        }
      catch (const std::exception &error)
        {
          answer = std::string(1, failed) + error.what();
        }
      write_all(file, answer);
      // No destructors and no exit handlers: they belong to the parent.
      _exit(0);
    }

    [[noreturn]] void
    report_death(const int status)
    {
      if (WIFSIGNALED(status))
        {
          const int signal = WTERMSIG(status);
          throw ChildProcessError("was killed by signal " +
                                    std::to_string(signal) + " (" +
                                    strsignal(signal) + ")",
                                  signal);
        }
      throw ChildProcessError("ended early with exit code " +
                                std::to_string(WEXITSTATUS(status)),
                              0);
    }
  } // namespace

  std::string
  run_in_child_process(const std::function<std::string()> &work,
                       const std::size_t                   memory_limit)
  {
    // What is still buffered must not be written by both.
    std::cout.flush();
    std::cerr.flush();
    std::fflush(nullptr);

    int         ends[2];
    const pid_t parent = getpid();
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw RunError(std::string("No pipe to a child process: ") +
                     std::strerror(errno) + ".");
    const pid_t child = fork();
    if (child < 0)
      throw RunError(std::string("No child process: ") + std::strerror(errno) +
                     ".");
    if (child == 0)
      {
        close(ends[0]);
        detach_from_parent(parent, memory_limit);
        run_child(work, ends[1]);
      }

    close(ends[1]);
    std::string answer = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
      ;

    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || answer.empty())
      report_death(status);
    const char kind = answer[0];
    answer.erase(0, 1);
    if (kind == input_error)
      throw InputError(answer);
    if (kind == out_of_memory)
      throw ChildProcessError("ran out of memory", 0);
    if (kind == failed)
      throw ChildProcessError("failed: " + answer, 0);
    return answer;
  }
} // namespace rift
