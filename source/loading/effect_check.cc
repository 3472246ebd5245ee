#include <rift/base/exceptions.h>
#include <rift/loading/effect_check.h>

#include <cmath>

namespace rift
{
  namespace
  {
    /** Components of a force that are smaller, relative to it, come from the
     * rounding of the coordinates of the mesh. */
    constexpr double smallest_component = 1e-6;
  } // namespace

  void
  EffectCheck::refuse_idle(const std::string            &name,
                           const std::string            &value,
                           const std::vector<NodeIndex> &nodes,
                           const NodalForce             &force) const
  {
    bool has_effect = false;
    for (std::size_t i = 0; i < nodes.size() && !has_effect; ++i)
      has_effect = moves(nodes[i], force(i));
    if (!body.communicator.any(has_effect))
      throw InputError(name + ": \"" + value +
                       "\" has no effect, since the velocities along its "
                       "forces are prescribed on all nodes that it acts on. "
                       "Remove this entry, or the prescribed velocities.");
  }

  bool
  EffectCheck::moves(const NodeIndex node, const Vector3<double> &force) const
  {
    if (!body.topology.owns_node(node))
      return false;
    for (unsigned int d = 0; d < dim; ++d)
      if (std::abs(force[d]) > smallest_component * norm(force) &&
          !is_prescribed(node, d))
        return true;
    return false;
  }
} // namespace rift
