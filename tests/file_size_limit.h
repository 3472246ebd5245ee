#ifndef rift_tests_file_size_limit_h
#define rift_tests_file_size_limit_h

#include <sys/resource.h>

#include <csignal>

namespace rift
{
  /**
   * Lets writing a file fail after `n_bytes`, as on a full disk, which takes
   * no privilege.
   */
  class FileSizeLimit
  {
  public:
    explicit FileSizeLimit(const rlim_t n_bytes)
      : old_handler(std::signal(SIGXFSZ, SIG_IGN))
    {
      ::getrlimit(RLIMIT_FSIZE, &old_limit);
      rlimit limit   = old_limit;
      limit.rlim_cur = n_bytes;
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }

    ~FileSizeLimit()
    {
      ::setrlimit(RLIMIT_FSIZE, &old_limit);
      std::signal(SIGXFSZ, old_handler);
    }

  private:
    void (*old_handler)(int);
    rlimit old_limit;
  };
} // namespace rift

#endif
