#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/base/output_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
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
  } // namespace

  void
  throw_disk_error(const std::string &action,
                   const std::string &path,
                   const int          error)
  {
    throw DiskError("Cannot " + action + " " + path + ": " +
                    std::strerror(error) + ". " + advice(error));
  }

  OutputFile::OutputFile(const std::string &path)
    : path(path)
    , descriptor(
        ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666))
  {
    if (descriptor < 0)
      throw_disk_error("create", path, errno);
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
          data.remove_prefix(written);
        else if (errno != EINTR)
          throw_disk_error("write", path, errno);
      }
  }

  void
  OutputFile::synchronize()
  {
    // EINVAL: a file of a kind that has nothing to be synchronized.
    while (::fsync(descriptor) != 0 && errno != EINVAL)
      if (errno != EINTR)
        throw_disk_error("write", path, errno);
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
    for (std::size_t i = 0; i < n_columns; ++i)
      buffer += (i > 0 ? "," : "") + csv_cell(columns[i]);
    buffer += '\n';
    flush();
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
} // namespace rift
