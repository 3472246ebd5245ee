#ifndef rift_tests_mesh_bad_mesh_h
#define rift_tests_mesh_bad_mesh_h

#include "../temporary_directory.h"
#include "msh_text.h"

#include <rift/base/exceptions.h>
#include <rift/mesh/gmsh_reader.h>
#include <rift/mesh/mesh_checks.h>

#include <gtest/gtest.h>

#include <string>

namespace rift
{
  /** Reads and checks a file and hands back what is said about it. */
  class BadMesh : public testing::Test
  {
  protected:
    std::string
    message(const std::string &content, const std::string &name = "a.msh")
    {
      write_file(directory / name, content);
      parameters.file = directory / name;
      std::string text =
        message_of<InputError>([&]() { check_mesh(read_mesh(parameters)); });
      // The name of the directory differs from run to run.
      for (auto i = text.find(directory.path); i != text.npos;
           i      = text.find(directory.path))
        text.replace(i, directory.path.size() + 1, "");
      return text;
    }

    std::string
    message(const MshText &text)
    {
      return message(text.str());
    }

    TemporaryDirectory directory;
    MeshParameters     parameters;
  };
} // namespace rift

#endif
