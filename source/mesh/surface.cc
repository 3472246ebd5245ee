#include <rift/mesh/surface.h>

#include <algorithm>

namespace rift
{
  std::vector<NodeIndex>
  surface_nodes(const Topology &topology, const Surface &surface)
  {
    std::vector<NodeIndex> nodes;
    for (const CellFace &face : surface)
      for (const NodeIndex node : face_nodes(topology, face))
        nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }
} // namespace rift
