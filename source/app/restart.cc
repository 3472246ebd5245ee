#include <rift/app/restart.h>
#include <rift/base/exceptions.h>
#include <rift/base/parameter_comparison.h>
#include <rift/mesh/mesh_buffer.h>

namespace rift
{
  namespace
  {
    /** What may change between a checkpoint and the scene that goes on. */
    const std::vector<std::string> may_differ = {
      "Title",
      "Checkpoint",
      "Mesh/Partition",
      "Output/Directory",
      "Output/Overwrite",
      "Output/Ranks per file",
      "Time/End time",
      "Time/Largest energy residual"};

    void
    check_same_scene(const Parameters &parameters, const CheckpointSet &set)
    {
      const auto differences =
        parameter_differences(used_parameters(parameters),
                              set.manifest.parameters,
                              may_differ);
      if (differences.empty())
        return;
      std::string text = "the scene is not that of the checkpoint " + set.path;
      for (const std::string &difference : differences)
        text += "\n  " + difference;
      throw InputError(text + "\nGo on with the same parameters, or start anew "
                              "without --restart.");
    }
  } // namespace

  Restart
  read_restart(const Parameters   &parameters,
               const Communicator &communicator,
               Log                &log)
  {
    const CheckpointSet set =
      find_checkpoint(parameters.output.directory, communicator);
    for (const std::string &problem : set.damaged)
      log.warn(problem);
    log.write("Going on from " + set.path);
    check_same_scene(parameters, set);

    Restart restart;
    restart.manifest  = set.manifest;
    restart.mesh_file = set.manifest.mesh;
    communicator.collectively([&] {
      for (std::size_t rank = 0; rank < set.manifest.ranks.size(); ++rank)
        {
          const CheckpointFileReader file = set.read_rank(rank);
          file.merge_into(restart.archive);
          if (rank == 0)
            restart.results = SavedResults::read(file);
        }
      if (communicator.is_root())
        restart.mesh = unpack_mesh(set.read_mesh().read_text("mesh"));
      else
        restart.archive.clear_sums();
    });
    return restart;
  }
} // namespace rift
