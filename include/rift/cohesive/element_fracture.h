#ifndef rift_cohesive_element_fracture_h
#define rift_cohesive_element_fracture_h

#include <rift/cohesive/cohesive_force.h>
#include <rift/cohesive/fracture.h>
#include <rift/cohesive/insertion.h>

namespace rift
{
  /** Strengths, insertion and cohesive elements as a module: what breaks. */
  class ElementFracture : public Fracture
  {
  public:
    /**
     * The body, and materials and stiffnesses, both by material index, must
     * outlive this object.
     *
     * @param internal_force finds the cells near their strength; must outlive
     *   this object.
     */
    ElementFracture(Discretization                        &body,
                    InternalForce                         &internal_force,
                    const std::vector<MaterialParameters> &materials,
                    const std::vector<StiffnessMatrix>    &stiffnesses,
                    const CohesiveParameters              &parameters);

    /** The cohesive elements; after prepare(). */
    CohesiveForce &
    cohesive_force()
    {
      return *force;
    }

    std::size_t
    n_faces() const override
    {
      return force->faces().size();
    }

    std::optional<OpenFace>
    open_face(const std::size_t index) const override
    {
      return force->open_face(index);
    }

    std::vector<FaceMeans>
    means(const State &state) const override
    {
      return force->means(state);
    }

    FaceCounts
    count_faces(const Communicator &communicator) const override
    {
      return force->count_faces(communicator);
    }

    void
    leave_failed_faces_to_contact(const std::uint64_t interval,
                                  const double        opening) override
    {
      force->leave_failed_faces_to_contact(interval, opening);
    }

    double
    share_of_stiffness() const override
    {
      // A third for each face of a corner where each may get an element.
      return is_extrinsic() ? 1. / 3 : 0;
    }

    void
    limit_step(StepLimits &limits) const override;

    void
    prepare(Discretization &body, const StepBound &bound) override;

    void
    choose_cuts(const StepContext      &step,
                std::vector<FaceIndex> &faces) override;

    void
    follow_cut(const StepContext &, const TopologyChange &change) override
    {
      force->apply(change);
    }

    void
    update_nodes(const std::vector<VertexIndex> &vertices) override
    {
      force->update_nodes(vertices);
    }

    void
    add_forces(StepContext &step) override
    {
      force->add_to(step.body.state, step.body.activity);
    }

    void
    hold_partings(StepContext &step) override
    {
      step.openings =
        force->hold_partings(step.body.state, step.prescribed_acceleration);
    }

    void
    start_openings(StepContext &step) override
    {
      force->start_openings(step.body.state, std::move(step.openings));
    }

    void
    account(const Discretization &body, EnergyTable &energies) const override;

    void
    save(const Discretization &body, Archive &archive) const override;

    void
    load(const Discretization &body, const Archive &archive) override;

    void
    count_items(const Topology &topology, WorkItems &items) const override;

    /** Whether faces are cut while the run goes on. */
    bool
    is_extrinsic() const
    {
      return parameters.model == CohesiveParameters::Model::extrinsic;
    }

  private:
    Discretization                        &body;
    InternalForce                         &internal_force;
    const std::vector<MaterialParameters> &materials;
    const std::vector<StiffnessMatrix>    &stiffnesses;
    const CohesiveParameters               parameters;

    std::optional<FaceStrengths> strengths;
    std::optional<CohesiveForce> force;

    /** In the extrinsic model. */
    StressBounds             bounds;
    std::optional<Insertion> insertion;
  };
} // namespace rift

#endif
