#ifndef rift_app_saved_state_h
#define rift_app_saved_state_h

#include <rift/base/exact_sum.h>
#include <rift/cohesive/cohesive_force.h>
#include <rift/contact/contact_force.h>
#include <rift/discretization/discretization.h>
#include <rift/io/checkpoint_set.h>
#include <rift/rigid/rigid_bodies.h>
#include <rift/solid/internal_force.h>

#include <vector>

/**
 * What of a body changes in a run, in names that do not depend on which rank
 * has it: a checkpoint goes on with any number of ranks.
 */
namespace rift
{
  /** A node, named by the first of its cells. */
  struct NodeRecord
  {
    GlobalCellIndex cell;
    std::uint32_t   corner;

    /** m and m/s. */
    std::array<double, dim> displacement, velocity;
  };

  /** A face that has been cut. */
  struct CutFaceRecord
  {
    FaceName      face;
    std::uint32_t state;
  };

  /** What one rank stores of what it owns, or what is restored to all. */
  struct SavedState
  {
    std::vector<NodeRecord>        nodes;
    std::vector<CutFaceRecord>     cut_faces;
    CohesiveRecords                cohesive_faces;
    std::vector<ContactPairRecord> contact_pairs;
    std::vector<ContactCellRecord> contact_cells;

    /** Of rank 0; all ranks have the same. */
    std::vector<RigidBodyRecord> rigid_bodies;

    /** InternalForce::hot_cells(). */
    std::vector<GlobalCellIndex> hot_cells;

    /** Cells that have not moved yet; they cost next to nothing. */
    std::vector<GlobalCellIndex> resting_cells;

    void
    write(CheckpointFileWriter &file) const;

    /** Adds what a file has. */
    void
    read(const CheckpointFileReader &file);
  };

  /** @param cohesive_force null without a cohesive model.
   * @param contact null without contact. The rest is left empty. */
  SavedState
  save_body(const Discretization &discretization,
            const InternalForce  &internal_force,
            const Activity       &activity,
            const CohesiveForce  *cohesive_force,
            const ContactForce   *contact);

  /**
   * Cuts an intact body as it was and moves its nodes to where they were.
   * Collective.
   *
   * @param state of all ranks together.
   */
  void
  restore_nodes(const SavedState          &state,
                const std::vector<double> &densities,
                Discretization            &discretization,
                Activity                  &activity);

  /**
   * How much each cell costs in a step, in units of a cell at work.
   *
   * @param face_cost of a cohesive face in the same unit.
   */
  std::vector<double>
  cell_costs(const SavedState &state, std::size_t n_cells, double face_cost);
} // namespace rift

#endif
