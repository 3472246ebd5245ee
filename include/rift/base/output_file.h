#ifndef rift_base_output_file_h
#define rift_base_output_file_h

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/**
 * @file
 *
 * Files that do not lose data in silence. deal.II's writers and a plain
 * std::ofstream go on as if nothing had happened when the disk is full; here
 * each call to the system is checked, and each failure is a DiskError with the
 * path, the system's reason and what to do.
 */
namespace rift
{
  /**
   * Ends the run with a DiskError: "Cannot `action` `path`: reason. Advice.".
   *
   * @param action what failed, such as "write".
   * @param error  the value of `errno` after the failure.
   */
  [[noreturn]] void
  throw_disk_error(const std::string &action,
                   const std::string &path,
                   int                error);

  /**
   * Waits until the names of the files in a folder have reached the disk, new
   * ones and those that have been removed.
   */
  void
  synchronize_directory(const std::string &path);

  /**
   * A file that is written from its start to its end, without a buffer of its
   * own.
   */
  class OutputFile
  {
  public:
    /** Creates the file, or empties the one that is there. */
    explicit OutputFile(const std::string &path);

    /**
     * Goes on with a file that is there, behind its first `length` bytes; what
     * it has more is cut off.
     *
     * @throws InputError if it is missing or shorter.
     */
    OutputFile(const std::string &path, std::uint64_t length);

    OutputFile(const OutputFile &) = delete;
    OutputFile &
    operator=(const OutputFile &) = delete;

    /** Closes the file without a check; close() is the one that checks. */
    ~OutputFile();

    /** Hands all of `data` to the system. */
    void
    write(std::string_view data);

    /** Waits until what has been written has reached the disk. */
    void
    synchronize();

    /** Closes the file; some file systems report a full disk only here. */
    void
    close();

    /** Length of the file in bytes. */
    std::uint64_t
    size() const
    {
      return n_bytes;
    }

  private:
    /** What the system has opened; a name for the constructor. */
    struct Opened
    {
      int descriptor;
    };

    OutputFile(const std::string &path, Opened opened);

    const std::string path;
    int               descriptor;
    std::uint64_t     n_bytes = 0;
  };

  /**
   * A file that comes into being all at once, by commit(), and replaces an
   * older one of its name: a reader sees the old content or the new, never a
   * part. Until then the data are in `path` + ".tmp", which is removed when
   * writing fails or is given up.
   */
  class AtomicFile
  {
  public:
    /** Opens `path` + ".tmp". Throws DiskError. */
    explicit AtomicFile(const std::string &path);
    ~AtomicFile();

    /** Adds data. Throws DiskError. */
    void
    write(std::string_view data);

    /** Brings the data to the disk and gives the file its name. */
    void
    commit();

  private:
    const std::string path;
    const std::string temporary_path;
    OutputFile        file;
    bool              committed = false;
  };

  /** Writes a whole file by way of AtomicFile. */
  void
  write_file_atomically(const std::string &path, std::string_view content);

  /**
   * A table of numbers in a .csv file that grows during a run: one header
   * line, then a row for each call of append(). Numbers are written so that
   * they can be read back exactly.
   */
  class HistoryFile
  {
  public:
    /**
     * Creates the file and writes the header.
     *
     * @param columns what the header says, with the unit in brackets, such as
     *   "time [s]". A name with a comma or a quote is quoted.
     */
    HistoryFile(const std::string              &path,
                const std::vector<std::string> &columns);

    /**
     * Goes on with a file after a restart: rows behind its first `length`
     * bytes, which synchronize() has told, are cut off.
     *
     * @throws InputError if the file is missing, is shorter, or has another
     *   header.
     */
    HistoryFile(const std::string              &path,
                const std::vector<std::string> &columns,
                std::uint64_t                   length);

    /**
     * Writes the rows that are still in memory, but cannot report a failure:
     * call flush() at the end of a run.
     */
    ~HistoryFile();

    /**
     * Adds a row with one value for each column. It comes to the disk with
     * the next flush(), or when much has been collected.
     *
     * @throws std::invalid_argument if the number of values is wrong, which
     *   is an error of the caller.
     */
    void
    append(const std::vector<double> &values);

    /** Writes all rows so far. */
    void
    flush();

    /**
     * Brings all rows so far to the disk.
     *
     * @return the length of the file, for the constructor after a restart.
     */
    std::uint64_t
    synchronize();

  private:
    const std::size_t n_columns;
    OutputFile        file;
    std::string       buffer;
  };
} // namespace rift

#endif
