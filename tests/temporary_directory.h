#ifndef rift_tests_temporary_directory_h
#define rift_tests_temporary_directory_h

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace rift
{
  /** A new, empty directory that is removed at the end of a test. */
  class TemporaryDirectory
  {
  public:
    TemporaryDirectory()
      : path((std::filesystem::temp_directory_path() / "rift-XXXXXX").string())
    {
      if (::mkdtemp(path.data()) == nullptr)
        throw std::runtime_error("cannot create " + path);
    }

    ~TemporaryDirectory()
    {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }

    TemporaryDirectory(const TemporaryDirectory &) = delete;
    TemporaryDirectory &
    operator=(const TemporaryDirectory &) = delete;

    /** The path of a file in it. */
    std::string
    operator/(const std::string &name) const
    {
      return path + "/" + name;
    }

    std::string path;
  };

  inline std::string
  read_file(const std::string &path)
  {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }

  inline void
  write_file(const std::string &path, const std::string &content)
  {
    std::ofstream(path, std::ios::binary) << content;
  }

  /** The message of the exception of type `Exception` that `f` throws. */
  template <typename Exception, typename Function>
  std::string
  message_of(const Function &f)
  {
    try
      {
        f();
      }
    catch (const Exception &exception)
      {
        return exception.what();
      }
    return "(nothing was thrown)";
  }
} // namespace rift

#endif
