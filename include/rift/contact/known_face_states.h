#ifndef rift_contact_known_face_states_h
#define rift_contact_known_face_states_h

#include <rift/mesh/topology.h>

#include <vector>

namespace rift
{
  /** What was known of the states of faces when they were looked at last. */
  class KnownFaceStates
  {
  public:
    /** All faces are taken to be intact. The topology must outlive this
     * object. */
    explicit KnownFaceStates(const Topology &topology);

    /** A face whose state has changed. */
    struct Change
    {
      /** Its index in Topology::faces, and its state then and now. */
      FaceIndex face;
      FaceState before, now;
    };

    /** Looks at the faces. Returns those that have changed. */
    std::vector<Change>
    look();

    /** At the last look. */
    FaceState
    operator[](const FaceIndex face) const
    {
      return states[face];
    }

    /** As if this had been seen at the last look. */
    void
    set(const FaceIndex face, const FaceState state)
    {
      states[face] = state;
    }

  private:
    const Topology        &topology;
    std::vector<FaceState> states;
  };

  /** The three vertices of a face. */
  std::array<VertexIndex, 3>
  vertices_of(const Topology &topology, FaceIndex face);
} // namespace rift

#endif
