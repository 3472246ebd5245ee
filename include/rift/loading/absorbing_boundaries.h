#ifndef rift_loading_absorbing_boundaries_h
#define rift_loading_absorbing_boundaries_h

#include <rift/mesh/surface.h>
#include <rift/module/module_with_work.h>

#include <functional>
#include <vector>

namespace rift
{
  /**
   * Surfaces behind which the body goes on for ever: dashpots take in the waves
   * that arrive across them (Lysmer & Kuhlemeyer 1969; doc/theory.md, eq. 32).
   * They act with the mean velocity of the step, so that they neither shorten
   * the time step nor make energy. The dashpots of all surfaces that meet at a
   * node act as one.
   */
  class AbsorbingBoundaries : public ModuleWithWork
  {
  public:
    /** One of the surfaces, and its name in the scene. */
    struct Boundary
    {
      /** The name, for messages, and the faces. */
      std::string name;
      Surface     surface;
    };

    /** Impedance, Pa s/m, of a material for waves along a normal. */
    using Impedance =
      std::function<Matrix3<double>(std::uint16_t          material,
                                    const Vector3<double> &normal)>;

    /** The nodes that others hold to a node, with itself. */
    using MovingAsOne = std::function<std::vector<NodeIndex>(NodeIndex)>;

    /** Takes the impedance of the material of each face along its normal.
     * @param moving_as_one empty if nothing holds nodes together but in the step
     *   in which they part. */
    AbsorbingBoundaries(const Topology          &topology,
                        const ReferenceCellData &reference,
                        std::vector<Boundary>    boundaries,
                        const Impedance         &impedance,
                        MovingAsOne              moving_as_one = {});

    Stage
    stage() const override
    {
      return Stage::loads;
    }

    void
    check_effect(const Discretization &body,
                 const IsPrescribed   &is_prescribed) const override;

    void
    follow_cut(const StepContext &step, const TopologyChange &change) override
    {
      Module::follow_cut(step, change);
      for (const NodeSplit &split : change.splits)
        held.push_back(split.parts);
    }

    void
    update_nodes(const std::vector<VertexIndex> &) override
    {
      update_nodes();
    }

    /** Of nodes that are held together. To be called after add_forces() of all
     * others. */
    void
    add_forces(StepContext &step) override
    {
      if (moving_as_one)
        find_held();
      add_to_held(step.body.state,
                  step.time_step,
                  held,
                  step.prescribed_acceleration);
      held.clear();
    }

    /** Of all other nodes. */
    void
    constrain(StepContext &step) override
    {
      add_to_others(step.body.state,
                    step.time_step,
                    step.prescribed_acceleration);
    }

    void
    count_work(const StepContext &step) override
    {
      count_work(step.body.state, step.time_step);
    }

    /**
     * Adds the forces of the dashpots of nodes that are held together in this
     * step: as if they were one. All forces but those that hold them together
     * and those of constraints are known. First call in the step.
     *
     * @param held sets of such nodes, any number of times.
     * @param prescribed where the motion of nodes is prescribed, the
     *   acceleration of a component of one.
     */
    void
    add_to_held(State                                     &state,
                double                                     time_step,
                const std::vector<std::vector<NodeIndex>> &held,
                const PrescribedAcceleration              &prescribed);

    /** The same of all other nodes, for which all forces but those of
     * constraints are known. */
    void
    add_to_others(State                        &state,
                  double                        time_step,
                  const PrescribedAcceleration &prescribed);

    /**
     * Adds up the energy that goes: to be called between the last force and the
     * kick.
     */
    void
    count_work(const State &state, double time_step);

    /** Takes in nodes that a crack has made. */
    void
    update_nodes();

  private:
    /** A node and its position in `nodes`, or none if it is not there. */
    struct Place
    {
      NodeIndex     node;
      std::uint32_t position;
    };

    Place
    find(NodeIndex node) const;

    /** Finds those of its nodes that others hold together. */
    void
    find_held();

    /** Adds the forces of the dashpots of nodes that move as one. */
    void
    add_to_nodes(const std::vector<Place>     &places,
                 State                        &state,
                 double                        time_step,
                 const PrescribedAcceleration &prescribed);

    const Topology             &topology;
    const std::vector<Boundary> boundaries;

    /** The faces of all surfaces, and what each node of each gets, kg/s. */
    Surface                      faces;
    std::vector<Matrix3<double>> face_dashpots;

    /** Nodes of the faces, ascending; the dashpot of each, kg/s; the force on
     * it, N; whether that has been added in this step. */
    std::vector<NodeIndex>       nodes;
    std::vector<Matrix3<double>> dashpots;
    std::vector<Vector3<double>> forces;
    std::vector<bool>            is_done;

    MovingAsOne moving_as_one;

    /** Sets of nodes that are held together in this step. */
    std::vector<std::vector<NodeIndex>> held;
  };
} // namespace rift

#endif
