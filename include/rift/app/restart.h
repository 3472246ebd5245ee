#ifndef rift_app_restart_h
#define rift_app_restart_h

#include <rift/app/parameters.h>
#include <rift/app/results.h>
#include <rift/app/saved_state.h>
#include <rift/io/log.h>
#include <rift/mesh/mesh_data.h>
#include <rift/time_integration/energy_ledger.h>

namespace rift
{
  /** All of a checkpoint, as a simulation needs it to go on. */
  struct Restart
  {
    CheckpointManifest manifest;
    CheckpointFileId   mesh_file;

    /** On rank 0. */
    MeshData mesh;

    /** Of all ranks together. */
    SavedState state;

    /** Totals of the works; on rank 0. */
    std::vector<ExactSum> works;

    EnergyLedger::Record ledger{};
    SavedResults         results;

    /** s */
    double time_step = 0;

    /** Time that a cohesive face takes in a step over that of a cell. */
    double face_cost = 0;

    /** ContactForce::has_changed(). */
    std::uint64_t have_cracks_changed = 0;
  };

  /**
   * Reads the newest good checkpoint in the output directory of a scene, says
   * in the log what is wrong with newer ones. Collective.
   *
   * @throws InputError if there is none, or if the scene is another one than
   *   that of the checkpoint.
   */
  Restart
  read_restart(const Parameters   &parameters,
               const Communicator &communicator,
               Log                &log);
} // namespace rift

#endif
