#ifndef rift_cohesive_open_faces_h
#define rift_cohesive_open_faces_h

#include <rift/base/communicator.h>
#include <rift/mesh/topology.h>

#include <array>

namespace rift
{
  /** Numbers of faces of the whole body. */
  struct FaceCounts
  {
    /** Faces that have been cut, and those that have begun to open. */
    std::uint64_t inserted = 0, opened = 0;

    /** Faces that have lost all their strength. */
    std::uint64_t failed = 0;

    /** Faces that have opened though the mesh is too coarse for their fracture
     * energy. */
    std::uint64_t too_short = 0;
  };

  /** Counts the faces of the whole body by their states. Collective.
   * @param n_too_short those of this rank. */
  FaceCounts
  count_faces(const Topology     &topology,
              std::size_t         n_too_short,
              const Communicator &communicator);

  /** A face that has begun to open. */
  struct OpenFace
  {
    /** Index in Topology::faces, and its nodes by side and corner. */
    FaceIndex                               face;
    std::array<std::array<NodeIndex, 3>, 2> nodes;
  };

  /** Means over an open face, for output. */
  struct FaceMeans
  {
    /** 0: intact, 1: separated. */
    double damage = 0;

    /** Jumps, m, and tractions, Pa: normal and in magnitude the rest. */
    double opening = 0, slip = 0, normal = 0, shear = 0;

    /** Parts of opening and of sliding in the damage, up to a common factor. */
    double opening_damage = 0, slip_damage = 0;

    /** Times at which it has begun to open, and at which it has failed, s; the
     * latter is negative before. */
    double start_time = 0, failure_time = -1;

    /** Share of sliding in the damage, from 0 to 1. */
    double
    mode() const
    {
      const double total = opening_damage + slip_damage;
      return total > 0 ? slip_damage / total : 0;
    }
  };
} // namespace rift

#endif
