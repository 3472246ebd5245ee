#ifndef rift_io_checkpoint_folder_h
#define rift_io_checkpoint_folder_h

#include <cstdint>
#include <string>
#include <vector>

namespace rift
{
  /**
   * The folder `checkpoint` of an output directory, and the names in it:
   *
   *     mesh            what all sets of a run need, written once
   *     1200/           a set: the state at step 1200
   *       rank-00000    the part of each rank that has written
   *       rank-00001
   *       manifest      written last; names all others
   *     1200.old/       a set that was there when step 1200 was written anew
   *     1300.tmp/       a set that has not been finished
   *
   * Nothing that rift does not give its names to is ever removed.
   */
  class CheckpointFolder
  {
  public:
    /** The folder `checkpoint` in a directory of results. Touches nothing. */
    explicit CheckpointFolder(const std::string &output_directory);

    /** Path of the folder. */
    std::string
    path() const
    {
      return folder;
    }

    /** Path of the file of the mesh, which all sets share. */
    std::string
    mesh() const
    {
      return folder + "/mesh";
    }

    /** Path of the set of a step when it is finished. */
    std::string
    set(const std::uint64_t step) const
    {
      return folder + "/" + std::to_string(step);
    }

    /** A folder in which a set is or was meant to be. */
    struct Set
    {
      /** The step in its name, and where it is. */
      std::uint64_t step;
      std::string   path;

      /** What the name ends with: nothing, `.old` or `.tmp`. */
      std::string ending;
    };

    /**
     * All sets, newest first, whether they are any good or not. None if the
     * folder does not exist.
     *
     * @throws DiskError if it cannot be read.
     */
    std::vector<Set>
    sets() const;

    /** Whether there is anything that remove() would remove. */
    bool
    is_in_use() const;

    /**
     * Removes all sets and the mesh, and the folder if it is then empty.
     *
     * @throws DiskError if anything cannot be removed.
     */
    void
    remove() const;

  private:
    const std::string folder;
  };

  /** Name of a rank's file in a set: `rank-00012`. */
  std::string
  checkpoint_rank_file(std::size_t rank);

  /**
   * Removes the files of a set, the manifest first, and then the folder. It is
   * no error if there is none.
   *
   * @return what has failed, as a sentence, or an empty text.
   */
  std::string
  remove_checkpoint_set(const std::string &path);
} // namespace rift

#endif
