#ifndef rift_contact_background_octree_h
#define rift_contact_background_octree_h

#include <rift/base/communicator.h>
#include <rift/contact/space_division.h>

namespace rift
{
  /**
   * Divides space among the ranks so that about as many points lie in the part
   * of each: an octree of p4est around all points is refined where many of them
   * are and cut into equal stretches of its curve. Collective.
   *
   * @param points of this rank, m.
   */
  SpaceDivision
  divide_space(const std::vector<Vector3<double>> &points,
               const Communicator                 &communicator);
} // namespace rift

#endif
