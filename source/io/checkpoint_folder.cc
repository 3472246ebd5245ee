#include <rift/base/exceptions.h>
#include <rift/base/output_file.h>
#include <rift/io/checkpoint_folder.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <tuple>

namespace rift
{
  namespace
  {
    namespace fs = std::filesystem;

    /** Whether to_string(number) could have written the text. */
    bool
    is_number(const std::string &text, std::uint64_t &number)
    {
      const auto result =
        std::from_chars(text.data(), text.data() + text.size(), number);
      return result.ec == std::errc() && text == std::to_string(number);
    }

    bool
    is_file_of_set(const std::string &name)
    {
      const std::string prefix = "rank-";
      return name == "manifest" ||
             (name.compare(0, prefix.size(), prefix) == 0 &&
              name.size() >= prefix.size() + 5 &&
              name.find_first_not_of("0123456789", prefix.size()) ==
                std::string::npos);
    }

    /** Names in a folder; none and an error if it cannot be read. */
    std::vector<std::string>
    names_in(const std::string &folder, std::error_code &error)
    {
      std::vector<std::string> names;
      fs::directory_iterator   entry(folder, error);
      for (; !error && entry != fs::directory_iterator();
           entry.increment(error))
        names.push_back(entry->path().filename().string());
      return names;
    }
  } // namespace

  CheckpointFolder::CheckpointFolder(const std::string &output_directory)
    : folder(output_directory + "/checkpoint")
  {
  }

  std::vector<CheckpointFolder::Set>
  CheckpointFolder::sets() const
  {
    std::error_code  error;
    const auto       names = names_in(folder, error);
    std::vector<Set> result;
    if (error && error != std::errc::no_such_file_or_directory)
      throw_disk_error("read the folder", folder, error.value());
    for (const std::string &name : names)
      {
        const auto dot = std::min(name.find('.'), name.size());
        Set        set{0, folder + "/" + name, name.substr(dot)};
        if (is_number(name.substr(0, dot), set.step) &&
            (set.ending.empty() || set.ending == ".old" ||
             set.ending == ".tmp") &&
            fs::is_directory(set.path, error))
          result.push_back(set);
      }
    std::sort(result.begin(), result.end(), [](const Set &a, const Set &b) {
      return std::tie(b.step, a.ending) < std::tie(a.step, b.ending);
    });
    return result;
  }

  bool
  CheckpointFolder::is_in_use() const
  {
    return !sets().empty() || fs::exists(fs::symlink_status(mesh()));
  }

  void
  CheckpointFolder::remove() const
  {
    for (const Set &set : sets())
      {
        const std::string failure = remove_checkpoint_set(set.path);
        if (!failure.empty())
          throw DiskError(failure);
      }
    std::error_code error;
    for (const std::string &path : {mesh(), mesh() + ".tmp"})
      {
        fs::remove(path, error);
        if (error)
          throw_disk_error("remove", path, error.value());
      }
    fs::remove(folder, error); // stays if it holds files of others
  }

  std::string
  checkpoint_rank_file(const std::size_t rank)
  {
    char name[32];
    std::snprintf(name, sizeof(name), "rank-%05zu", rank);
    return name;
  }

  std::string
  remove_checkpoint_set(const std::string &path)
  {
    std::error_code error;
    auto            names = names_in(path, error);
    if (error == std::errc::no_such_file_or_directory)
      return "";
    // Without its manifest, what is left of a set is nothing to go on from.
    std::sort(names.begin(), names.end());
    for (const std::string &name : names)
      if (!error && is_file_of_set(name))
        fs::remove(path + "/" + name, error);
    if (!error)
      fs::remove(path, error);
    return error ? "Cannot remove " + path + ": " + error.message() + "." : "";
  }
} // namespace rift
