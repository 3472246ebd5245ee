#ifndef rift_cohesive_fracture_h
#define rift_cohesive_fracture_h

#include <rift/cohesive/open_faces.h>
#include <rift/module/module.h>

namespace rift
{
  /** What breaks the body, as a module: what others must know of it, whatever
   * its formulation. */
  class Fracture : public Module
  {
  public:
    /** @param topology must outlive this object. */
    explicit Fracture(const Topology &topology)
      : topology(topology)
    {
    }

    Stage
    stage() const override
    {
      return Stage::cohesive_forces;
    }

    /** Number of faces that this rank computes. */
    virtual std::size_t
    n_faces() const = 0;

    /** One of them, by its index in the fields of cohesive faces; nothing if it
     * has not begun to open. */
    virtual std::optional<OpenFace>
    open_face(std::size_t index) const = 0;

    /** Of all these faces, for output. */
    virtual std::vector<FaceMeans>
    means(const State &state) const = 0;

    /** Declares what output can show of its faces.
     * @param fracture null: the names alone. */
    static void
    declare_fields(FieldList &list, const Fracture *fracture);

    void
    declare_fields(FieldList &list) const override
    {
      declare_fields(list, this);
    }

    /** Collective. */
    virtual FaceCounts
    count_faces(const Communicator &communicator) const = 0;

    /**
     * Has failed faces let go when they are open, since contact then resists
     * their overlap.
     *
     * @param interval faces are let go of at the end of so many steps, when
     *   contact looks for pairs.
     * @param opening over the size of the face, of the corner that is open
     *   most.
     */
    virtual void
    leave_failed_faces_to_contact(std::uint64_t interval, double opening) = 0;

    /** What of the room that the time step leaves for added stiffness it takes,
     * at a corner with one face of each kind. */
    virtual double
    share_of_stiffness() const = 0;

    /** The nodes that move as one with another in this step, with itself, as far
     * as is known once all have been cut that are cut in it; those that have just
     * parted may be left out. */
    virtual std::vector<NodeIndex>
    nodes_moving_with(const NodeIndex node) const
    {
      return {node};
    }

  protected:
    /** The body's. */
    const Topology &topology;
  };
} // namespace rift

#endif
