// Every scene that comes with rift is one.

#include <rift/app/run.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

using namespace rift;
namespace fs = std::filesystem;

namespace
{
  const fs::path folder = RIFT_SOURCE_DIRECTORY "/prm";

  /** Paths in prm/, as in contact/pile.prm. */
  std::vector<std::string>
  scenes()
  {
    std::vector<std::string> paths;
    for (const auto &entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".prm")
        paths.push_back(fs::relative(entry.path(), folder));
    std::sort(paths.begin(), paths.end());
    return paths;
  }

  /** The mesh of a fine scene takes its time: a coarser one stands for it. */
  std::vector<std::string>
  overrides_of(const std::string &scene)
  {
    for (const std::string fine : {"spalling", "shpb", "barre/block"})
      if (scene.find(fine) != scene.npos)
        return {"Mesh/Element size=8e-3"};
    return {};
  }

  class ScenesOfRift : public testing::TestWithParam<std::string>
  {
  };
} // namespace

TEST_P(ScenesOfRift, AreValid)
{
  std::ostringstream said;
  validate_scene(
    said,
    read_parameters(folder / GetParam(), overrides_of(GetParam())));
  EXPECT_NE(said.str().find("Time step"), std::string::npos) << said.str();
}

INSTANTIATE_TEST_SUITE_P(Folder,
                         ScenesOfRift,
                         testing::ValuesIn(scenes()),
                         [](const auto &info) {
                           std::string name = info.param;
                           name.erase(name.rfind('.'));
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });
