#ifndef rift_tests_support_shared_directory_h
#define rift_tests_support_shared_directory_h

#include <rift/base/communicator.h>

#include "../temporary_directory.h"

#include <optional>

namespace rift::test
{
  /** A TemporaryDirectory that all ranks know. Made and removed together. */
  class SharedDirectory
  {
  public:
    explicit SharedDirectory(const Communicator &communicator)
      : communicator(communicator)
    {
      if (communicator.is_root())
        path = directory.emplace().path;
      communicator.broadcast(path);
    }

    ~SharedDirectory()
    {
      communicator.sum(0); // nobody needs it any more
    }

    std::string
    operator/(const std::string &name) const
    {
      return path + "/" + name;
    }

    std::string path;

  private:
    const Communicator                communicator;
    std::optional<TemporaryDirectory> directory;
  };
} // namespace rift::test

#endif
