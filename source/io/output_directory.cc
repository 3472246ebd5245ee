#include <rift/base/exceptions.h>
#include <rift/base/output_file.h>
#include <rift/io/checkpoint_folder.h>
#include <rift/io/output_directory.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <vector>

namespace rift
{
  namespace
  {
    namespace fs = std::filesystem;

    bool
    ends_with(const std::string &text, const std::string &ending)
    {
      return text.size() >= ending.size() &&
             text.compare(text.size() - ending.size(), ending.size(), ending) ==
               0;
    }

    /**
     * Whether `name` is `series`, a number of five digits or more, and `.vtu`;
     * the number of a group of ranks may stand before that: solid-00000.1.vtu.
     */
    bool
    is_state_of(const std::string &series, const std::string &name)
    {
      const std::string start = series + "-", ending = ".vtu";
      if (name.compare(0, start.size(), start) != 0 || !ends_with(name, ending))
        return false;
      const auto begin      = name.begin() + start.size();
      const auto end        = name.end() - ending.size();
      const auto dot        = std::find(begin, end, '.');
      const auto are_digits = [](const auto first, const auto last) {
        return std::all_of(first, last, [](const unsigned char c) {
          return std::isdigit(c);
        });
      };
      return dot - begin >= 5 && are_digits(begin, dot) &&
             (dot == end || (end - dot > 1 && are_digits(dot + 1, end)));
    }

    bool
    was_written_by_rift(const fs::path &parameters)
    {
      std::ifstream file(parameters);
      std::string   first_line;
      std::getline(file, first_line);
      return first_line == parameters_marker;
    }

    void
    check_name(const std::string &directory)
    {
      if (directory.empty())
        throw InputError("The name of the output directory is empty. Set "
                         "Output / Directory or give --output.");
    }

    /** That the scene of a user is not written over. */
    void
    check_parameters(const std::string &directory)
    {
      const fs::path  path = fs::path(directory) / "parameters.prm";
      std::error_code error;
      const auto      status = fs::symlink_status(path, error);
      if (fs::exists(status) && !fs::is_directory(status) &&
          !was_written_by_rift(path))
        throw InputError("rift would write " + path.string() +
                         ", but there is a file of that name that no earlier "
                         "run has left. Rename it, or choose another output "
                         "directory.");
    }

    /**
     * The results of an older run, in order of their names; its checkpoints
     * count as one.
     */
    std::vector<fs::path>
    find_results(const std::string &directory)
    {
      std::vector<fs::path>  results;
      std::error_code        error;
      fs::directory_iterator entry(directory, error);
      for (; !error && entry != fs::directory_iterator();
           entry.increment(error))
        if (is_result_file(entry->path().filename().string()) &&
            !fs::is_directory(entry->symlink_status()))
          results.push_back(entry->path());
      if (error)
        throw_disk_error("read the output directory", directory, error.value());
      const CheckpointFolder checkpoints(directory);
      if (checkpoints.is_in_use())
        results.push_back(checkpoints.path());
      std::sort(results.begin(), results.end());
      return results;
    }

    /** Only an attempt tells; permission bits say nothing on some disks. */
    void
    check_writable(const std::string &directory)
    {
      AtomicFile attempt(directory + "/rift");
      attempt.write("x");
    }
  } // namespace

  bool
  is_result_file(const std::string &name)
  {
    // A run that was killed may have left an unfinished file.
    if (ends_with(name, ".tmp"))
      return is_result_file(name.substr(0, name.size() - 4));

    for (const char *own : {"solid.pvd",
                            "fracture.pvd",
                            "probes.csv",
                            "energy.csv",
                            "fragments.csv",
                            "summary.json",
                            "parameters.prm",
                            "log.txt"})
      if (name == own)
        return true;
    return is_state_of("solid", name) || is_state_of("fracture", name);
  }

  void
  create_output_directory(const std::string &directory)
  {
    check_name(directory);
    std::error_code error;
    const auto      status = fs::status(directory, error);
    if (fs::exists(status) && !fs::is_directory(status))
      throw InputError("The output directory " + directory +
                       " is a file. Choose another name in Output / "
                       "Directory or with --output.");
    fs::create_directories(directory, error);
    if (error)
      throw_disk_error("create the output directory", directory, error.value());
  }

  void
  check_output_directory(const std::string &directory, const bool overwrite)
  {
    create_output_directory(directory);
    const auto results = find_results(directory);
    check_parameters(directory);

    if (!results.empty() && !overwrite)
      throw InputError(
        "The output directory " + directory +
        " holds results of an older run: " + std::to_string(results.size()) +
        (results.size() == 1 ? " file, " : " files, the first is ") +
        results.front().filename().string() +
        ". Choose another directory with --output, or set Output / Overwrite "
        "to true to replace them.");

    check_writable(directory);
  }

  void
  prepare_output_directory(const std::string &directory, const bool overwrite)
  {
    check_output_directory(directory, overwrite);
    const CheckpointFolder checkpoints(directory);
    for (const auto &path : find_results(directory))
      {
        std::error_code error;
        if (path == checkpoints.path())
          checkpoints.remove();
        else
          fs::remove(path, error);
        if (error)
          throw_disk_error("remove", path.string(), error.value());
      }
  }

  void
  remove_results_of_end(const std::string &directory)
  {
    for (const char *name : {"fragments.csv", "summary.json"})
      {
        const fs::path  path = fs::path(directory) / name;
        std::error_code error;
        fs::remove(path, error);
        if (error)
          throw_disk_error("remove", path.string(), error.value());
      }
  }

  void
  reopen_output_directory(const std::string &directory)
  {
    check_name(directory);
    std::error_code error;
    if (!fs::is_directory(directory, error))
      throw InputError("There is no output directory " + directory +
                       " in which a run could go on. Start it without "
                       "--restart.");
    check_parameters(directory);
    check_writable(directory);
  }
} // namespace rift
