#include <rift/mesh/gmsh_session.h>

#include <fmt/format.h>
#include <gmsh.h>

#include <vector>

namespace rift
{
  GmshSession::GmshSession(const std::map<std::string, double> &numbers)
  {
    std::vector<std::string> arguments = {"rift"};
    for (const auto &number : numbers)
      arguments.insert(
        arguments.end(),
        {"-setnumber", number.first, fmt::format("{:.17g}", number.second)});
    std::vector<char *> pointers;
    for (auto &argument : arguments)
      pointers.push_back(argument.data());
    gmsh::initialize(static_cast<int>(pointers.size()), pointers.data(), false);

    const std::pair<const char *, double> options[] = {
      {"General.Terminal", 0},
      // More threads would make the mesh depend on their number.
      {"General.NumThreads", 1},
      // Delaunay. HXT is faster, but its meshes depend on the addresses that
      // the system gives to memory: no two runs have the same.
      {"Mesh.Algorithm3D", 1}};
    for (const auto &option : options)
      gmsh::option::setNumber(option.first, option.second);
  }

  GmshSession::~GmshSession()
  {
    gmsh::finalize();
  }
} // namespace rift
