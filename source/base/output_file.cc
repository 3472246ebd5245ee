#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/base/output_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <utility>

namespace rift
{
  namespace
  {
    const char *
    advice(const int error)
    {
      switch (error)
        {
        case ENOSPC:
        case EDQUOT:
          return "Make room on this disk, or write to another one.";
        case EFBIG:
          return "Raise the limit on the size of a file (ulimit -f), or "
                 "write to another disk.";
        case EACCES:
        case EPERM:
        case EROFS:
          return "Choose an output directory in which you may write.";
        case ENOENT:
        case ENOTDIR:
          return "Check that its folder exists.";
        default:
          return "Check the disk, or choose another output directory.";
        }
    }

    std::string
    csv_cell(const std::string &text)
    {
      if (text.find_first_of(",\"\n") == std::string::npos)
        return text;
      std::string quoted = "\"";
      for (const char c : text)
        quoted += (c == '"') ? std::string("\"\"") : std::string(1, c);
      return quoted + '"';
    }

    std::string
    csv_header(const std::vector<std::string> &columns)
    {
      std::string header;
      for (std::size_t i = 0; i < columns.size(); ++i)
        header += (i > 0 ? "," : "") + csv_cell(columns[i]);
      return header + '\n';
    }

    /** Says that a file is not what the run before the restart has left. */
    [[noreturn]] void
    throw_unfit(const std::string &path, const std::string &problem)
    {
      throw InputError("Cannot go on with " + path + ": " + problem +
                       ". Put the file back that the run has left there, or "
                       "start anew, without --restart.");
    }

    int
    create_file(const std::string &path)
    {
      const int descriptor =
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
      if (descriptor < 0)
        throw_disk_error("create", path, errno);
      return descriptor;
    }

    int
    open_file(const std::string &path)
    {
      const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
      if (descriptor < 0 && errno == ENOENT)
        throw_unfit(path, "it is missing");
      if (descriptor < 0)
        throw_disk_error("open", path, errno);
      return descriptor;
    }

    /** Calls fsync() and returns its `errno`, 0 if all is well. */
    int
    synchronize_descriptor(const int descriptor)
    {
      // EINVAL: a file of a kind that has nothing to be synchronized.
      while (::fsync(descriptor) != 0 && errno != EINVAL)
        if (errno != EINTR)
          return errno;
      return 0;
    }

    /**
     * Looks at the header before anything is cut off. A file that is missing
     * or too short is left to OutputFile.
     */
    const std::string &
    with_header(const std::string  &path,
                const std::string  &header,
                const std::uint64_t length)
    {
      std::string   start(header.size(), '\0');
      std::ifstream file(path, std::ios::binary);
      file.read(start.data(), start.size());
      start.resize(file.gcount());
      if (length < header.size() || header.compare(0, start.size(), start) != 0)
        throw_unfit(path, "its columns are others than those of this run");
      return path;
    }
  } // namespace

  void
  throw_disk_error(const std::string &action,
                   const std::string &path,
                   const int          error)
  {
    throw DiskError("Cannot " + action + " " + path + ": " +
                    std::strerror(error) + ". " + advice(error));
  }

  void
  synchronize_directory(const std::string &path)
  {
    const int descriptor =
      ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
      throw_disk_error("open the folder", path, errno);
    const int error = synchronize_descriptor(descriptor);
    ::close(descriptor);
    if (error != 0)
      throw_disk_error("write the folder", path, error);
  }

  OutputFile::OutputFile(const std::string &path, const Opened opened)
    : path(path)
    , descriptor(opened.descriptor)
  {
  }

  OutputFile::OutputFile(const std::string &path)
    : OutputFile(path, Opened{create_file(path)})
  {
  }

  OutputFile::OutputFile(const std::string &path, const std::uint64_t length)
    : OutputFile(path, Opened{open_file(path)})
  {
    const off_t found = ::lseek(descriptor, 0, SEEK_END);
    if (found >= 0 && static_cast<std::uint64_t>(found) < length)
      throw_unfit(path,
                  "it has " + std::to_string(found) + " bytes, but had " +
                    std::to_string(length) + " at the checkpoint");
    if (found < 0 || ::ftruncate(descriptor, length) != 0 ||
        ::lseek(descriptor, length, SEEK_SET) < 0)
      throw_disk_error("go on with", path, errno);
    n_bytes = length;
  }

  OutputFile::~OutputFile()
  {
    if (descriptor >= 0)
      ::close(descriptor);
  }

  void
  OutputFile::write(std::string_view data)
  {
    while (!data.empty())
      {
        const ssize_t written = ::write(descriptor, data.data(), data.size());
        if (written >= 0)
          {
            data.remove_prefix(written);
            n_bytes += written;
          }
        else if (errno != EINTR)
          throw_disk_error("write", path, errno);
      }
  }

  void
  OutputFile::synchronize()
  {
    if (const int error = synchronize_descriptor(descriptor))
      throw_disk_error("write", path, error);
  }

  void
  OutputFile::close()
  {
    if (::close(std::exchange(descriptor, -1)) != 0 && errno != EINTR)
      throw_disk_error("write", path, errno);
  }

  AtomicFile::AtomicFile(const std::string &path)
    : path(path)
    , temporary_path(path + ".tmp")
    , file(temporary_path)
  {
  }

  AtomicFile::~AtomicFile()
  {
    if (!committed)
      std::remove(temporary_path.c_str());
  }

  void
  AtomicFile::write(const std::string_view data)
  {
    file.write(data);
  }

  void
  AtomicFile::commit()
  {
    // Without this a power failure could leave the new name on an empty file.
    file.synchronize();
    file.close();
    if (std::rename(temporary_path.c_str(), path.c_str()) != 0)
      throw_disk_error("write", path, errno);
    committed = true;
  }

  void
  write_file_atomically(const std::string &path, const std::string_view content)
  {
    AtomicFile file(path);
    file.write(content);
    file.commit();
  }

  HistoryFile::HistoryFile(const std::string              &path,
                           const std::vector<std::string> &columns)
    : n_columns(columns.size())
    , file(path)
  {
    file.write(csv_header(columns));
  }

  HistoryFile::HistoryFile(const std::string              &path,
                           const std::vector<std::string> &columns,
                           const std::uint64_t             length)
    : n_columns(columns.size())
    , file(with_header(path, csv_header(columns), length), length)
  {
  }

  HistoryFile::~HistoryFile()
  {
    try
      {
        flush();
      }
    catch (const DiskError &)
      {
        // A destructor may not throw; documented.
      }
  }

  void
  HistoryFile::append(const std::vector<double> &values)
  {
    if (values.size() != n_columns)
      throw std::invalid_argument(
        "HistoryFile: a row of " + std::to_string(values.size()) +
        " values in a table of " + std::to_string(n_columns) + " columns");
    for (std::size_t i = 0; i < n_columns; ++i)
      {
        if (i > 0)
          buffer += ',';
        buffer += to_text(values[i]);
      }
    buffer += '\n';

    constexpr std::size_t large = 1 << 16;
    if (buffer.size() >= large)
      flush();
  }

  void
  HistoryFile::flush()
  {
    // Rows that could not be written are given up: a second attempt would
    // repeat the part that did reach the file.
    const std::string rows = std::exchange(buffer, std::string());
    file.write(rows);
  }

  std::uint64_t
  HistoryFile::synchronize()
  {
    flush();
    file.synchronize();
    return file.size();
  }
} // namespace rift
