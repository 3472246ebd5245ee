#ifndef rift_bonds_crack_planes_h
#define rift_bonds_crack_planes_h

#include <rift/base/types.h>
#include <rift/base/vector3.h>

#include <unordered_map>
#include <vector>

namespace rift
{
  /** The planes along which nodes have been cut, in the undeformed body. */
  struct CrackPlanes
  {
    /** A plane and the area that was cut along it at a vertex. */
    struct Part
    {
      /** Unit normal, and projected area, m^2. */
      Vector3<double> normal;
      double          area;
    };

    /** Unit normal of the plane for which each face was cut. */
    std::unordered_map<FaceIndex, Vector3<double>> of_faces;

    /** For each vertex at which nodes have been cut, in the order of time. */
    std::unordered_map<VertexIndex, std::vector<Part>> at_vertices;
  };
} // namespace rift

#endif
