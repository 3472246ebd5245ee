#ifndef rift_io_checkpoint_set_h
#define rift_io_checkpoint_set_h

#include <rift/base/communicator.h>
#include <rift/io/checkpoint_file.h>

#include <string>
#include <vector>

namespace rift
{
  /** What a set says about itself. */
  struct CheckpointManifest
  {
    /** Number of the step at which the run goes on. */
    std::uint64_t step = 0;

    /** Simulated time, s. */
    double time = 0;

    /** Text of the parameters with which the run was computed. */
    std::string parameters;

    /** The file of the mesh that belongs to it. */
    CheckpointFileId mesh;

    /** One file for each rank that has written. */
    std::vector<CheckpointFileId> ranks;

    /** Adds it to a file, from which read() reads it. */
    void
    write(CheckpointFileWriter &file) const;

    /** @throws CheckpointDamaged if it is not whole. */
    static CheckpointManifest
    read(const std::string &path);
  };

  /** A set of files in a CheckpointFolder, from which a run can go on. */
  struct CheckpointSet
  {
    /** Paths of the file of the mesh and of the set, and what the set says
     * about itself. */
    std::string        mesh_path;
    std::string        path;
    CheckpointManifest manifest;

    /** Sentences: what is wrong with the newer ones, if there are any. */
    std::vector<std::string> damaged;

    /** Opens the file of the mesh. Throws CheckpointDamaged if it is not the
     * one that is meant. */
    CheckpointFileReader
    read_mesh() const;

    /** The file of a rank that has written: any rank may read any of them. */
    CheckpointFileReader
    read_rank(std::size_t writer) const;
  };

  /**
   * Looks for the newest set whose files are all good. The ranks share the work
   * of reading them. Collective; all ranks get the same.
   *
   * @throws InputError if there is none, with what is wrong with each.
   */
  CheckpointSet
  find_checkpoint(const std::string  &output_directory,
                  const Communicator &communicator);
} // namespace rift

#endif
