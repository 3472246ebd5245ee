#ifndef rift_app_restart_h
#define rift_app_restart_h

#include <rift/app/parameters.h>
#include <rift/app/results.h>
#include <rift/base/archive.h>
#include <rift/io/checkpoint_set.h>
#include <rift/io/log.h>
#include <rift/mesh/mesh_data.h>

namespace rift
{
  /** All of a checkpoint, as a simulation needs it to continue. */
  struct Restart
  {
    /** What the checkpoint says about itself, and its file of the mesh. */
    CheckpointManifest manifest;
    CheckpointFileId   mesh_file;

    /** On rank 0. */
    MeshData mesh;

    /** What all ranks have written. */
    Archive archive;

    /** How far the files of the run had come. */
    SavedResults results;
  };

  /** How much a cell costs in a step, in units of an elastic cell at work;
   * stored where that is not 1. */
  struct CellCost
  {
    /** The cell, by its global index, and its cost. */
    GlobalCellIndex cell;
    float           cost;
  };

  template <>
  struct HasPlainBytes<CellCost> : std::true_type
  {
    static_assert(sizeof(CellCost) == 2 * 4);
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
