#ifndef rift_bonds_crack_planes_h
#define rift_bonds_crack_planes_h

#include <rift/base/archive.h>
#include <rift/base/vector3.h>
#include <rift/mesh/topology.h>

#include <unordered_map>
#include <unordered_set>
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

    /** Cells that have a cut face whose other cell is not on this rank. */
    std::unordered_set<CellIndex> beside_remote_cuts;

    /** For each vertex at which nodes have been cut, in the order of time. */
    std::unordered_map<VertexIndex, std::vector<Part>> at_vertices;

    /** A face by its two sides, the minus side first. */
    using FaceSides = std::array<FaceName, 2>;

    /** The names of the two sides of a face. */
    static FaceSides
    sides_of(const Topology &topology, FaceIndex face);

    /** The index of a face; where this rank sees one side alone, invalid_index,
     * and beside_remote_cuts has its cell from now on. */
    FaceIndex
    find(const Topology &topology, const FaceSides &sides);

    /** Writes those of the faces and vertices that this rank owns. */
    void
    save(const Topology &topology, Archive &archive) const;

    /** Reads what ranks have saved. */
    void
    load(const Topology &topology, const Archive &archive);
  };
} // namespace rift

#endif
