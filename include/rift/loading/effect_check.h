#ifndef rift_loading_effect_check_h
#define rift_loading_effect_check_h

#include <rift/module/module.h>

namespace rift
{
  /** Finds loads that cannot have any effect, since the velocities along their
   * forces are prescribed. */
  class EffectCheck
  {
  public:
    /** @param body undeformed. */
    EffectCheck(const Discretization &body, const IsPrescribed &is_prescribed)
      : body(body)
      , is_prescribed(is_prescribed)
    {
    }

    /** A force on the i-th of some nodes; its size does not matter. */
    using NodalForce = std::function<Vector3<double>(std::size_t i)>;

    /**
     * Refuses a load none of whose forces, on any rank, has a component along
     * which its node may move. Collective.
     *
     * @param name of the load, as messages say it: "Boundary top / Pressure".
     * @param value of that entry.
     * @throws InputError on all ranks.
     */
    void
    refuse_idle(const std::string            &name,
                const std::string            &value,
                const std::vector<NodeIndex> &nodes,
                const NodalForce             &force) const;

  private:
    /** Whether a force moves a node that this rank owns. */
    bool
    moves(NodeIndex node, const Vector3<double> &force) const;

    const Discretization &body;
    const IsPrescribed   &is_prescribed;
  };
} // namespace rift

#endif
