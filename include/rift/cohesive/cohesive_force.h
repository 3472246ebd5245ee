#ifndef rift_cohesive_cohesive_force_h
#define rift_cohesive_cohesive_force_h

#include <rift/cohesive/cohesive_elements.h>
#include <rift/cohesive/partings.h>

#include <memory>
#include <optional>
#include <vector>

namespace rift
{
  /**
   * The cohesive elements at work.
   *
   * In the extrinsic model a face that has been cut lies idle while its two
   * sides still share all their nodes; it gets an element when the first of its
   * corners parts. In the intrinsic model all faces have one from the start.
   *
   * A face fails when all of its seven points have reached D = 1: nothing is
   * cut off then, so that failing releases no energy and separation has
   * used up the fracture energy times the area. Until contact takes over, a
   * failed face still resists overlap. A face whose sides have moved apart by
   * half of its size has failed in any case and resists nothing.
   */
  class CohesiveForce
  {
  public:
    /**
     * @param parameters the model and the law.
     * @param stiffness_of a face: that of its elastic branch.
     */
    CohesiveForce(Topology                 &topology,
                  const ReferenceCellData  &reference,
                  const FaceStrengths      &strengths,
                  const CohesiveParameters &parameters,
                  PenaltyStiffness          stiffness_of);

    /**
     * Intrinsic model: gives all faces that have been cut their elements. To be
     * called once, before the first step, when all ranks know the nodes of all
     * cells.
     */
    void
    start_all(const State &state);

    /**
     * Takes in what a split has changed: the nodes of the faces around the
     * split nodes, and the nodes that have parted, which hold_partings() will
     * keep together for this step.
     */
    void
    apply(const TopologyChange &change);

    /** Takes in which nodes the faces around these vertices have now. */
    void
    update_nodes(const std::vector<VertexIndex> &vertices)
    {
      cohesive_faces.update_nodes(vertices);
    }

    /**
     * Adds the forces of all faces, after updating their memory. Faces between
     * cells at rest that have no memory are passed over.
     */
    void
    add_to(State &state, const Activity &activity)
    {
      elements->add_to(state, activity);
    }

    /**
     * Holds nodes that have parted in this step together for the rest of it:
     * adds to each the bond force m_A a - f_A with the common acceleration a.
     * To be called when all other forces have been summed.
     *
     * @param prescribed where the motion of nodes is prescribed, the
     *   acceleration of a component of one: that is then the common one, and
     *   the grip takes what is left of the balance.
     * @return the bond forces, shared over the faces between the nodes such
     *   that the mean square of traction is smallest: what start_openings()
     *   needs at the end of the step.
     */
    std::vector<OpeningCorner>
    hold_partings(State &state, const PrescribedAcceleration &prescribed)
    {
      return partings.hold(state, prescribed);
    }

    /**
     * Passes the bond forces to the faces: from the next add_to() on, these
     * hold the sides together. Accelerations then do not jump (doc/theory.md,
     * section 5). To be called once after the drift.
     *
     * @param corners of the faces that this rank needs, in any order.
     */
    void
    start_openings(const State &state, std::vector<OpeningCorner> corners);

    /** The faces that this rank owns and that have opened. */
    CohesiveRecords
    records() const
    {
      return elements->records();
    }

    /**
     * Goes on with faces of which records() has told, on any ranks; the
     * topology must have been cut as it was, and know the states of its faces.
     * Those that this rank does not need are passed over.
     */
    void
    restore(const State &state, const CohesiveRecords &records);

    /**
     * Energies of the faces that this rank owns.
     *
     * @param state as at the last add_to().
     */
    CohesiveEnergy
    energy(const State &state) const
    {
      return elements->energy(state);
    }

    /**
     * Has failed faces let go when they are open, since contact then resists
     * their overlap.
     *
     * @param interval faces are let go of at the end of so many steps, when
     *   contact looks for pairs.
     * @param opening over the size of the face, of the corner that is open
     *   most.
     */
    void
    leave_failed_faces_to_contact(const std::uint64_t interval,
                                  const double        opening)
    {
      cohesive_faces.contact_interval = interval;
      cohesive_faces.contact_opening  = opening;
    }

    /** The faces with a cohesive element. */
    const CohesiveFaces &
    faces() const
    {
      return cohesive_faces;
    }

    /** One of faces(), for the output; nothing if it has not begun to open. */
    std::optional<OpenFace>
    open_face(std::size_t index) const;

    /** For the output, in the order of faces(). */
    std::vector<FaceMeans>
    means(const State &state) const;

    /** Collective. */
    FaceCounts
    count_faces(const Communicator &communicator) const
    {
      return rift::count_faces(topology,
                               elements->count_unresolved(),
                               communicator);
    }

    /** For tests, which know their law: a CohesiveElementsOf it. */
    CohesiveElements &
    elements_of_law()
    {
      return *elements;
    }

  private:
    Topology &topology;

    CohesiveFaces                           cohesive_faces;
    const std::unique_ptr<CohesiveElements> elements;
    Partings                                partings;
  };
} // namespace rift

#endif
