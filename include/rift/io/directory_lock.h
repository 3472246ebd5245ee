#ifndef rift_io_directory_lock_h
#define rift_io_directory_lock_h

#include <string>

namespace rift
{
  /**
   * The right to write results to a directory: as long as it lives, nobody else
   * can have one for the same directory, neither in this process nor in another
   * one, on this machine or on another that shares the disk. It is a lock of the
   * system on the file `rift.lock` in the directory (`flock`) and so vanishes
   * with the process, however that ends.
   *
   * On a file system that has no locks it has no effect.
   */
  class DirectoryLock
  {
  public:
    /**
     * @throws InputError if somebody else has the lock, with the process and the
     *   host.
     * @throws DiskError if the file cannot be created.
     */
    explicit DirectoryLock(const std::string &directory);

    /** Removes the file and gives the lock back. */
    ~DirectoryLock();

    DirectoryLock(const DirectoryLock &) = delete;
    DirectoryLock &
    operator=(const DirectoryLock &) = delete;

  private:
    const std::string path;
    int               descriptor = -1;
  };
} // namespace rift

#endif
