// Cases of bad input that need no process of their own; see README.md.

#include "../temporary_directory.h"

#include <rift/app/execute.h>
#include <rift/base/exceptions.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <sstream>

using namespace rift;
namespace fs = std::filesystem;

namespace
{
  const fs::path folder = RIFT_SOURCE_DIRECTORY "/tests/failures";

  bool
  has(const std::string &name, const std::string &extension)
  {
    return fs::exists(folder / (name + extension));
  }

  /** The names of all cases that are nothing but a scene and arguments. */
  std::vector<std::string>
  cases()
  {
    std::vector<std::string> names;
    for (const auto &entry : fs::directory_iterator(folder))
      {
        const std::string name = entry.path().stem();
        if (entry.path().extension() == ".error" && !has(name, ".sh") &&
            !has(name, ".ranks") && !has(name, ".limit"))
          names.push_back(name);
      }
    std::sort(names.begin(), names.end());
    return names;
  }

  /** The arguments of rift, beginning with its name. */
  std::vector<std::string>
  arguments_of(const std::string &name)
  {
    std::vector<std::string> arguments = {"rift"};
    if (!has(name, ".args"))
      arguments.push_back(name + ".prm");
    std::istringstream lines(read_file(folder / (name + ".args")));
    for (std::string line; std::getline(lines, line);)
      arguments.push_back(line);
    return arguments;
  }

  /** While it lives, what is written to a file descriptor goes to a file. */
  class Redirection
  {
  public:
    Redirection(std::FILE *stream, const std::string &path)
      : stream(stream)
      , saved(::dup(::fileno(stream)))
    {
      flush();
      std::FILE *file = std::fopen(path.c_str(), "w");
      ::dup2(::fileno(file), ::fileno(stream));
      std::fclose(file);
    }

    ~Redirection()
    {
      flush();
      ::dup2(saved, ::fileno(stream));
      ::close(saved);
    }

  private:
    void
    flush()
    {
      std::cout.flush();
      std::fflush(stream);
    }

    std::FILE *stream;
    const int  saved;
  };

  /** Exit code and words on stderr, as the program `rift` has them. */
  std::string
  run_rift(const std::vector<std::string> &arguments, const std::string &output)
  {
    std::vector<const char *> argv;
    for (const std::string &argument : arguments)
      argv.push_back(argument.c_str());
    ExitCode    code = ExitCode::done;
    std::string said;
    {
      const Redirection out(stdout, output + ".stdout");
      const Redirection err(stderr, output + ".stderr");
      try
        {
          execute(
            std::cout,
            parse_command_line(static_cast<int>(argv.size()), argv.data()));
        }
      catch (const Error &error)
        {
          code = error.exit_code;
          said = std::string("rift: error: ") + error.what() + "\n";
        }
    }
    return std::to_string(static_cast<int>(code)) + "\n" +
           read_file(output + ".stderr") + said;
  }

  class BadInput : public testing::TestWithParam<std::string>
  {
  };
} // namespace

TEST_P(BadInput, IsRefused)
{
  const TemporaryDirectory directory, output;
  for (const auto &entry : fs::directory_iterator(folder))
    {
      const std::string stem = entry.path().stem();
      if (stem == GetParam() || !has(stem, ".error"))
        fs::create_symlink(entry, directory / entry.path().filename());
    }
  const fs::path here = fs::current_path();
  fs::current_path(directory.path);
  const std::string found = run_rift(arguments_of(GetParam()), output / "rift");
  fs::current_path(here);
  EXPECT_EQ(found, read_file(folder / (GetParam() + ".error")))
    << read_file(output / "rift.stdout");
}

INSTANTIATE_TEST_SUITE_P(Failures,
                         BadInput,
                         testing::ValuesIn(cases()),
                         [](const auto &info) { return info.param; });
