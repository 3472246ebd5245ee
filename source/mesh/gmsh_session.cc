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
        // HXT. On a cylinder of 54,000 cells its smallest altitude, which
        // limits the time step, is 0.36 of the element size; the default
        // (Delaunay) has 0.26, and takes 8 times as long for 800,000 cells.
        {"Mesh.Algorithm3D", 10},
        // The quality below which cells are improved. Smaller altitudes do not
        // grow beyond 0.45, while the time does.
        {"Mesh.OptimizeThreshold", 0.45}};
    for (const auto &option : options)
      gmsh::option::setNumber(option.first, option.second);
  }

  GmshSession::~GmshSession()
  {
    gmsh::finalize();
  }
} // namespace rift
