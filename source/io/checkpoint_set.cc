#include <rift/io/checkpoint_folder.h>
#include <rift/io/checkpoint_set.h>

#include <algorithm>
#include <sstream>

namespace rift
{
  namespace
  {
    /**
     * Reads the manifest of a set and all files that it names. The ranks share
     * them in such a way that the first failure is the same however many they
     * are.
     */
    void
    verify(CheckpointSet      &set,
           const std::uint64_t step,
           const Communicator &communicator)
    {
      const std::string path = set.path + "/manifest";
      set.manifest           = CheckpointManifest::read(path);
      if (set.manifest.step != step)
        throw CheckpointDamaged(path,
                                "is that of step " +
                                  std::to_string(set.manifest.step));
      const std::size_t n_files = 1 + set.manifest.ranks.size();
      const auto        begin   = [&](const std::size_t rank) {
        return n_files * rank / communicator.size();
      };
      for (std::size_t i = begin(communicator.rank());
           i < begin(communicator.rank() + 1);
           ++i)
        i == 0 ? set.read_mesh() : set.read_rank(i - 1);
    }

    /** What is wrong with a set, as a sentence, or an empty text. Collective. */
    std::string
    failure_of(CheckpointSet      &set,
               const std::uint64_t step,
               const Communicator &communicator)
    {
      std::string failure;
      try
        {
          verify(set, step, communicator);
        }
      catch (const CheckpointDamaged &error)
        {
          failure = error.what();
        }
      for (const std::string &of_rank : communicator.all_gather(failure))
        if (!of_rank.empty())
          return of_rank;
      return "";
    }
  } // namespace

  void
  CheckpointManifest::write(CheckpointFileWriter &file) const
  {
    file.write_value("step", step);
    file.write_value("time", time);
    file.write_text("parameters", parameters);
    file.write_value("mesh", mesh);
    file.write("ranks", ranks);
  }

  CheckpointManifest
  CheckpointManifest::read(const std::string &path)
  {
    const CheckpointFileReader file(path);
    CheckpointManifest         result;
    result.step       = file.read_value<std::uint64_t>("step");
    result.time       = file.read_value<double>("time");
    result.parameters = file.read_text("parameters");
    result.mesh       = file.read_value<CheckpointFileId>("mesh");
    result.ranks      = file.read<CheckpointFileId>("ranks");
    return result;
  }

  CheckpointFileReader
  CheckpointSet::read_mesh() const
  {
    return CheckpointFileReader(mesh_path, manifest.mesh);
  }

  CheckpointFileReader
  CheckpointSet::read_rank(const std::size_t writer) const
  {
    return CheckpointFileReader(path + "/" + checkpoint_rank_file(writer),
                                manifest.ranks.at(writer));
  }

  CheckpointSet
  find_checkpoint(const std::string  &output_directory,
                  const Communicator &communicator)
  {
    const CheckpointFolder folder(output_directory);
    // All ranks have to look at the same sets.
    std::string names;
    communicator.on_root([&] {
      for (const CheckpointFolder::Set &set : folder.sets())
        if (set.ending != ".tmp")
          names += std::to_string(set.step) + set.ending + "\n";
    });
    communicator.broadcast(names);

    CheckpointSet      result;
    std::istringstream list(names);
    for (std::string name; std::getline(list, name);)
      {
        result.mesh_path = folder.mesh();
        result.path      = folder.path() + "/" + name;
        const std::string failure =
          failure_of(result, std::stoull(name), communicator);
        if (failure.empty())
          return result;
        // What the sets share, the mesh, is the same failure of each.
        if (std::find(result.damaged.begin(), result.damaged.end(), failure) ==
            result.damaged.end())
          result.damaged.push_back(failure);
      }
    std::string reasons;
    for (const std::string &failure : result.damaged)
      reasons += failure + " ";
    throw InputError("There is no " +
                     std::string(reasons.empty() ? "" : "undamaged ") +
                     "checkpoint in " + folder.path() + ". " + reasons +
                     "Start anew, without --restart; Overwrite = true in "
                     "subsection Output, or another --output, lets it, and "
                     "Interval in steps in subsection Checkpoint makes it "
                     "write checkpoints.");
  }
} // namespace rift
