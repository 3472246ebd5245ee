#include <rift/base/parameter_file.h>
#include <rift/base/parameter_text.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace rift
{
  namespace
  {
    std::string
    joined(const std::string &section, const std::string &name)
    {
      return section.empty() ? name : section + "/" + name;
    }

    std::string
    at(const std::string &file, const unsigned int line)
    {
      return file + ":" + std::to_string(line) + ": ";
    }

    // Throws unless `path` is a file that can be read. `before` precedes the
    // message, `advice` follows it.
    std::ifstream
    open(const std::string &path,
         const std::string &before,
         const std::string &advice)
    {
      const std::string cannot = before + "cannot read \"" + path + "\": ";
      std::error_code   error;
      const auto        status = std::filesystem::status(path, error);
      if (std::filesystem::is_directory(status))
        throw InputError(cannot + "it is a folder. " + advice);
      if (std::filesystem::exists(status) &&
          !std::filesystem::is_regular_file(status))
        throw InputError(cannot + "it is not an ordinary file. " + advice);
      errno = 0;
      std::ifstream stream(path);
      if (!stream)
        throw InputError(cannot + std::strerror(errno) + ". " + advice);
      return stream;
    }

    /** Reads the files of a scene, one inside the other. */
    class Reader
    {
    public:
      std::vector<ParameterEntry>   entries;
      std::vector<ParameterSection> sections;

      void
      read(const std::string &path, const std::string &outer, std::ifstream);

    private:
      // The files that are being read, the innermost last.
      std::vector<std::string> open_files;

      void
      include(const std::string &section,
              const std::string &name,
              const std::string &file,
              const unsigned int line);

      void
      add_entry(const std::string &section,
                const std::string &text,
                const std::string &file,
                const unsigned int line);
    };

    // Throws unless `text`, which `before` tells the place of, is UTF-8, as all
    // must be that is to stand in the files of results.
    void
    check_encoding(const std::string &text,
                   const std::string &before,
                   const std::string &advice)
    {
      const std::size_t position = find_invalid_utf8(text);
      if (position == std::string::npos)
        return;
      char byte[5];
      std::snprintf(byte,
                    sizeof(byte),
                    "0x%02x",
                    static_cast<unsigned char>(text[position]));
      throw InputError(before + "the byte " + byte + " in \"" + excerpt(text) +
                       "\" is not valid UTF-8. " + advice);
    }

    // The next line without comment, joined with those that continue it.
    bool
    next_line(std::ifstream     &stream,
              const std::string &file,
              unsigned int      &first,
              unsigned int      &last,
              std::string       &text)
    {
      text.clear();
      first = last + 1;
      std::string line;
      while (std::getline(stream, line))
        {
          ++last;
          if (last == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
            line.erase(0, 3);
          line.erase(std::min(line.find('#'), line.size()));
          line = simplified(line);
          check_encoding(line,
                         at(file, last),
                         "Save the file as UTF-8, or use ASCII.");
          const bool goes_on = ends_with(line, "\\");
          text += goes_on ? line.substr(0, line.size() - 1) : line;
          if (!goes_on)
            return true;
        }
      if (!text.empty())
        throw InputError(at(file, last) +
                         "the file ends with a backslash, which announces "
                         "another line. Remove it.");
      return false;
    }

    void
    Reader::read(const std::string &path,
                 const std::string &outer,
                 std::ifstream      stream)
    {
      open_files.push_back(path);
      // The subsections that are open here, with the path of each.
      std::vector<ParameterSection> open_sections;
      unsigned int                  first = 0, line = 0;
      std::string                   text;
      while (next_line(stream, path, first, line, text))
        {
          const std::string word = text.substr(0, text.find(' '));
          const std::string rest = simplified(text.substr(word.size()));
          const std::string section =
            open_sections.empty() ? outer : open_sections.back().path;
          if (text.empty())
            continue;
          else if (word == "subsection" && !rest.empty())
            {
              // The slash parts section and name in overrides and messages.
              if (rest.find('/') != std::string::npos)
                throw InputError(at(path, first) + "subsection \"" + rest +
                                 "\": a name cannot have \"/\" in it. "
                                 "Choose another.");
              open_sections.push_back({joined(section, rest), path, first});
              sections.push_back(open_sections.back());
            }
          else if (text == "end")
            {
              if (open_sections.empty())
                throw InputError(at(path, first) +
                                 "this \"end\" closes no subsection. Remove "
                                 "it, or open a subsection before it.");
              open_sections.pop_back();
            }
          else if (word == "set" && text.find('=') != std::string::npos)
            add_entry(section, rest, path, first);
          else if (word == "include" && !rest.empty())
            include(section, rest, path, first);
          else
            throw InputError(
              at(path, first) + "cannot understand \"" + excerpt(text) +
              "\". A line is \"subsection NAME\", \"end\", \"set NAME = "
              "VALUE\", \"include FILE\" or a comment after \"#\".");
        }
      if (stream.bad())
        throw InputError("cannot read \"" + path + "\" to its end.");
      if (!open_sections.empty())
        throw InputError(at(path, open_sections.front().line) +
                         "subsection \"" + open_sections.front().path +
                         "\" is not closed. Write \"end\" after its last "
                         "entry.");
      open_files.pop_back();
    }

    void
    Reader::include(const std::string &section,
                    const std::string &name,
                    const std::string &file,
                    const unsigned int line)
    {
      const std::string path =
        (std::filesystem::path(file).parent_path() / name).string();
      std::ifstream stream =
        open(path, at(file, line), "Paths are relative to the including file.");
      for (const std::string &other : open_files)
        if (std::filesystem::equivalent(other, path))
          throw InputError(at(file, line) + "\"" + path +
                           "\" includes itself. Remove this line.");
      read(path, section, std::move(stream));
    }

    void
    Reader::add_entry(const std::string &section,
                      const std::string &text,
                      const std::string &file,
                      const unsigned int line)
    {
      const std::size_t equals = text.find('=');
      ParameterEntry    entry;
      entry.section = section;
      entry.name    = simplified(text.substr(0, equals));
      entry.value   = simplified(text.substr(equals + 1));
      entry.file    = file;
      entry.line    = line;
      if (entry.name.empty())
        throw InputError(at(file, line) +
                         "a name is missing before \"=\". Write \"set NAME = "
                         "VALUE\".");
      for (const ParameterEntry &other : entries)
        if (other.section == section && other.name == entry.name)
          throw InputError(place_of(entry) + ": this has been set already at " +
                           other.file + ":" + std::to_string(other.line) +
                           " to \"" + excerpt(other.value) +
                           "\". Remove one of the two.");
      entries.push_back(entry);
    }
  } // namespace

  std::string
  place_of(const ParameterEntry &entry)
  {
    const std::string name = joined(entry.section, entry.name);
    return entry.is_override ?
             "--set " + name + "=" + excerpt(entry.value) :
             at(entry.file, entry.line) + name + " = " + excerpt(entry.value);
  }

  ParameterFile::ParameterFile(const std::string              &path,
                               const std::vector<std::string> &overrides)
    : scene(path)
  {
    Reader reader;
    reader.read(path,
                "",
                open(path, "", "Give the path of a scene, a .prm file."));
    all_entries  = std::move(reader.entries);
    all_sections = std::move(reader.sections);
    for (const std::string &text : overrides)
      add_override(text);
  }

  void
  ParameterFile::add_override(const std::string &text)
  {
    check_encoding(text,
                   "--set " + excerpt(text) + ": ",
                   "Use UTF-8 or ASCII.");
    const std::size_t equals = text.find('=');
    const std::string target = text.substr(0, equals);
    const std::size_t slash  = target.rfind('/');
    ParameterEntry    entry;
    entry.is_override = true;
    if (slash != std::string::npos)
      entry.section = simplified(target.substr(0, slash));
    entry.name =
      simplified(target.substr(slash == std::string::npos ? 0 : slash + 1));
    if (equals == std::string::npos || entry.name.empty())
      throw InputError("--set " + excerpt(text) +
                       ": cannot understand this. Write --set "
                       "\"Section/Name=value\".");
    entry.value = simplified(text.substr(equals + 1));

    for (ParameterEntry &other : all_entries)
      if (other.section == entry.section && other.name == entry.name)
        {
          if (other.is_override)
            throw InputError(
              place_of(entry) + ": the command line sets this already to \"" +
              excerpt(other.value) + "\". Remove one of the two.");
          other = entry;
          return;
        }
    all_entries.push_back(entry);
  }

  const std::string &
  ParameterFile::path() const
  {
    return scene;
  }

  const std::vector<ParameterEntry> &
  ParameterFile::entries() const
  {
    return all_entries;
  }

  const std::vector<ParameterSection> &
  ParameterFile::sections() const
  {
    return all_sections;
  }

  std::vector<std::string>
  ParameterFile::names_of(const std::string &kind) const
  {
    std::vector<std::string>      names;
    std::vector<ParameterSection> found;
    for (const ParameterSection &section : all_sections)
      {
        if (section.path.compare(0, kind.size() + 1, kind + " ") != 0 ||
            section.path.find('/') != std::string::npos)
          continue;
        const std::string name = section.path.substr(kind.size() + 1);
        const std::string here = at(section.file, section.line);
        if (const std::string problem = name_problem(name); !problem.empty())
          throw InputError(here + "subsection \"" + section.path +
                           "\": " + problem + ". Choose another.");
        for (const ParameterSection &other : found)
          if (other.path == section.path)
            throw InputError(here + "subsection \"" + section.path +
                             "\" is there already at " + other.file + ":" +
                             std::to_string(other.line) +
                             ". Rename or remove one of the two.");
        found.push_back(section);
        names.push_back(name);
      }
    return names;
  }

  const ParameterEntry *
  ParameterFile::find(const std::string &section, const std::string &name) const
  {
    for (const ParameterEntry &entry : all_entries)
      if (entry.section == section && entry.name == name)
        return &entry;
    return nullptr;
  }

  std::string
  ParameterFile::resolve(const std::string &section,
                         const std::string &name,
                         const std::string &path) const
  {
    const ParameterEntry *entry = find(section, name);
    const std::string    &file =
      entry == nullptr || entry->is_override ? scene : entry->file;
    return (std::filesystem::path(file).parent_path() / path)
      .lexically_normal()
      .string();
  }

  std::string
  ParameterFile::describe(const ParameterError &error) const
  {
    if (const ParameterEntry *entry = find(error.section, error.name))
      return place_of(*entry) + ": " + error.problem;
    std::string place = scene + ": ";
    for (const ParameterSection &section : all_sections)
      if (section.path == error.section)
        place = at(section.file, section.line);
    return place + joined(error.section, error.name) +
           " is not set: " + error.problem;
  }

  void
  ParameterFile::refuse_inert(const std::vector<InertEntries> &inert) const
  {
    for (const InertEntries &group : inert)
      {
        const bool is_switched_off =
          std::any_of(group.causes.begin(),
                      group.causes.end(),
                      [&](const auto &cause) {
                        const ParameterEntry *entry =
                          find(cause.first, cause.second);
                        return entry != nullptr && entry->is_override;
                      });
        for (const std::string &name : group.names)
          if (const ParameterEntry *entry = find(group.section, name))
            if (entry->is_override || !is_switched_off)
              throw ParameterError(group.section,
                                   name,
                                   "this has no effect " + group.reason +
                                     ". Remove it.");
      }
  }
} // namespace rift
