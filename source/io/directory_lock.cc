#include <rift/base/exceptions.h>
#include <rift/base/output_file.h>
#include <rift/base/parameter_text.h>
#include <rift/io/directory_lock.h>

#include <sys/file.h>
#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <unistd.h>

namespace rift
{
  namespace
  {
    std::string
    own_name()
    {
      std::array<char, 256> host = {};
      gethostname(host.data(), host.size() - 1);
      return "process " + std::to_string(getpid()) + " on host " + host.data();
    }

    [[noreturn]] void
    refuse(const std::string &directory, const std::string &path)
    {
      std::ifstream file(path);
      std::string   holder;
      std::getline(file, holder);
      throw InputError("The output directory " + directory +
                       " is in use by another run of rift" +
                       (holder.empty() ? "" : ", " + excerpt(holder)) +
                       ". Wait for its end, stop it, or choose another "
                       "directory with --output.");
    }

    /**
     * Whether the file of this name is still the one that is open: the one
     * before may have removed it after it was opened here.
     */
    bool
    is_current(const int descriptor, const std::string &path)
    {
      struct stat opened = {}, named = {};
      return ::fstat(descriptor, &opened) == 0 &&
             ::stat(path.c_str(), &named) == 0 &&
             opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
    }
  } // namespace

  DirectoryLock::DirectoryLock(const std::string &directory)
    : path(directory + "/rift.lock")
  {
    while (true)
      {
        descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor < 0)
          throw_disk_error("create", path, errno);
        const int result = ::flock(descriptor, LOCK_EX | LOCK_NB);
        if (result != 0 && errno == EWOULDBLOCK)
          {
            ::close(descriptor);
            refuse(directory, path);
          }
        if (is_current(descriptor, path))
          break;
        ::close(descriptor);
      }
    // Only for messages: that it cannot be written is no reason to stop.
    const std::string holder = own_name() + '\n';
    if (::ftruncate(descriptor, 0) == 0)
      (void)!::write(descriptor, holder.data(), holder.size());
  }

  DirectoryLock::~DirectoryLock()
  {
    // In this order: what is removed is still locked.
    std::remove(path.c_str());
    ::close(descriptor);
  }
} // namespace rift
