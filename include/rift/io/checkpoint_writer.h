#ifndef rift_io_checkpoint_writer_h
#define rift_io_checkpoint_writer_h

#include <rift/base/communicator.h>
#include <rift/io/checkpoint_file.h>
#include <rift/io/checkpoint_folder.h>

#include <functional>
#include <string>

namespace rift
{
  /** Writes the blocks of one file. */
  using WriteBlocks = std::function<void(CheckpointFileWriter &)>;

  /**
   * Writes what all sets of a run need and what never changes, on rank 0.
   * Collective.
   *
   * @return what the file is known by, on all ranks.
   * @throws DiskError if it cannot be written.
   */
  CheckpointFileId
  write_checkpoint_mesh(const std::string  &output_directory,
                        const Communicator &communicator,
                        const WriteBlocks  &write_blocks);

  /** Writes the sets of a run. */
  class CheckpointWriter
  {
  public:
    /**
     * @param mesh   what write_checkpoint_mesh() has returned or, after a
     *   restart, the manifest says.
     * @param n_sets how many are kept, at least 1.
     */
    CheckpointWriter(const std::string      &output_directory,
                     const Communicator     &communicator,
                     const CheckpointFileId &mesh,
                     unsigned int            n_sets);

    /**
     * Writes a set, each rank its own file. It comes into being all at once,
     * when everything has reached the disk. Then the oldest sets are removed,
     * and so is what a killed run has left unfinished, and sets of later
     * steps, which must be damaged: the run would have gone on from them.
     * Collective.
     *
     * @return on rank 0, what could not be removed, as sentences for the log;
     *   it will be tried again after the next set.
     * @throws DiskError if the set cannot be written; those that were there
     *   stay as they are.
     */
    std::string
    write(std::uint64_t      step,
          double             time,
          const std::string &parameters,
          const WriteBlocks &write_blocks) const;

  private:
    void
    write_files(const std::string  &unfinished,
                CheckpointManifest &manifest,
                const WriteBlocks  &write_blocks) const;

    std::string
    remove_others(std::uint64_t newest_step) const;

    const CheckpointFolder folder;
    const Communicator     communicator;
    const CheckpointFileId mesh;
    const unsigned int     n_sets;
  };
} // namespace rift

#endif
