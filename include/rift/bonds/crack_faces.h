#ifndef rift_bonds_crack_faces_h
#define rift_bonds_crack_faces_h

#include <rift/cohesive/partings.h>
#include <rift/discretization/state.h>

#include <unordered_map>
#include <vector>

namespace rift
{
  /** A frame that turns with a face: its edges from corner 0 and its unit
   * normal. */
  struct FaceFrame
  {
    /** m, m and 1. */
    Vector3<double> edges[2], normal;

    /** The vector that has these components in the frame. */
    Vector3<double>
    vector(const Vector3<double> &components) const
    {
      return components[0] * edges[0] + components[1] * edges[1] +
             components[2] * normal;
    }

    /** The components of a vector in the frame. */
    Vector3<double>
    components(const Vector3<double> &vector) const;
  };

  /** The faces at a corner of which two nodes have parted. */
  class CrackFaces
  {
  public:
    /** The topology must outlive this object. */
    explicit CrackFaces(const Topology &topology);

    /** A face: its two sides and what has become of it. */
    struct Face
    {
      /** Index in Topology::faces, and the nodes of its corners by side. */
      FaceIndex index;
      NodeIndex nodes[2][3];

      /** Times at which it has begun to open, and at which it has failed, s; the
       * latter is negative before. */
      double start_time, failure_time;

      /** Corners at which all strength is lost, a bit each. */
      std::uint8_t failed;
    };

    /** The place of a face, which gets one if it has none. */
    std::uint32_t
    add(FaceIndex face, double time);

    /** Takes in which nodes the faces around these vertices have now. */
    void
    update_nodes(const std::vector<VertexIndex> &vertices);

    /** The frame of a face now: half-way between its two sides. */
    FaceFrame
    current_frame(const State &state, std::uint32_t place) const;

    /** The frame of a face in the undeformed body. */
    FaceFrame
    undeformed_frame(const State &state, std::uint32_t place) const;

    /** The faces, in the order in which they have begun to open. */
    std::vector<Face> faces;

    /** The place of a face in `faces`; invalid_index if it has none. */
    std::uint32_t
    find(FaceIndex face) const;

  private:
    void
    update_face(Face &face);

    const Topology                              &topology;
    std::unordered_map<FaceIndex, std::uint32_t> place_of_face;
  };
} // namespace rift

#endif
