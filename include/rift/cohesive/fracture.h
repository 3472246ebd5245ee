#ifndef rift_cohesive_fracture_h
#define rift_cohesive_fracture_h

#include <rift/cohesive/cohesive_force.h>
#include <rift/cohesive/insertion.h>
#include <rift/module/module.h>

namespace rift
{
  /** Strengths, insertion and cohesive elements as a module: what breaks. */
  class Fracture : public Module
  {
  public:
    /**
     * The body, and materials and stiffnesses, both by material index, must
     * outlive this object.
     *
     * @param internal_force finds the cells near their strength; must outlive
     *   this object.
     */
    Fracture(Discretization                        &body,
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

    Stage
    stage() const override
    {
      return Stage::cohesive_forces;
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
    declare_fields(FieldList &list) const override
    {
      CohesiveForce::declare_fields(list, &*force);
    }

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
