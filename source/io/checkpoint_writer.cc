#include <rift/base/bytes.h>
#include <rift/io/checkpoint_set.h>
#include <rift/io/checkpoint_writer.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

namespace rift
{
  namespace
  {
    namespace fs = std::filesystem;

    void
    create_folder(const std::string &path)
    {
      std::error_code error;
      fs::create_directories(path, error);
      if (error)
        throw_disk_error("create the folder", path, error.value());
    }

    void
    rename_path(const std::string &from, const std::string &to)
    {
      if (std::rename(from.c_str(), to.c_str()) != 0)
        throw_disk_error("create", to, errno);
    }

    /** Gives a set that is on the disk its name. */
    void
    publish(const std::string &unfinished, const std::string &path)
    {
      // A set of this name is moved away and not removed, so that there is no
      // moment without one: the reader knows the other name as well.
      if (fs::exists(fs::symlink_status(path)))
        {
          remove_checkpoint_set(path + ".old");
          rename_path(path, path + ".old");
        }
      rename_path(unfinished, path);
    }
  } // namespace

  CheckpointFileId
  write_checkpoint_mesh(const std::string  &output_directory,
                        const Communicator &communicator,
                        const WriteBlocks  &write_blocks)
  {
    const CheckpointFolder folder(output_directory);
    const std::string      unfinished = folder.mesh() + ".tmp";
    CheckpointFileId       id;
    communicator.on_root([&] {
      create_folder(folder.path());
      try
        {
          CheckpointFileWriter file(unfinished);
          write_blocks(file);
          id = file.finish();
        }
      catch (const Error &)
        {
          std::remove(unfinished.c_str());
          throw;
        }
      rename_path(unfinished, folder.mesh());
      synchronize_directory(folder.path());
      synchronize_directory(output_directory);
    });
    std::string bytes = object_to_bytes(id);
    communicator.broadcast(bytes);
    return object_from_bytes<CheckpointFileId>(bytes);
  }

  CheckpointWriter::CheckpointWriter(const std::string      &output_directory,
                                     const Communicator     &communicator,
                                     const CheckpointFileId &mesh,
                                     const unsigned int      n_sets)
    : folder(output_directory)
    , communicator(communicator)
    , mesh(mesh)
    , n_sets(n_sets)
  {
  }

  std::string
  CheckpointWriter::write(const std::uint64_t step,
                          const double        time,
                          const std::string  &parameters,
                          const WriteBlocks  &write_blocks) const
  {
    const std::string  path       = folder.set(step);
    const std::string  unfinished = path + ".tmp";
    CheckpointManifest manifest{step, time, parameters, mesh, {}};
    communicator.on_root([&] { remove_checkpoint_set(unfinished); });
    try
      {
        write_files(unfinished, manifest, write_blocks);
        communicator.on_root([&] {
          CheckpointFileWriter file(unfinished + "/manifest");
          manifest.write(file);
          file.finish();
          synchronize_directory(unfinished);
          publish(unfinished, path);
          synchronize_directory(folder.path());
        });
      }
    catch (const Error &)
      {
        if (communicator.is_root())
          remove_checkpoint_set(unfinished);
        throw;
      }
    std::string failures;
    communicator.on_root([&] { failures = remove_others(step); });
    return failures;
  }

  void
  CheckpointWriter::write_files(const std::string  &unfinished,
                                CheckpointManifest &manifest,
                                const WriteBlocks  &write_blocks) const
  {
    CheckpointFileId id;
    communicator.collectively([&] {
      create_folder(unfinished);
      CheckpointFileWriter file(
        unfinished + "/" +
        checkpoint_rank_file(static_cast<std::size_t>(communicator.rank())));
      write_blocks(file);
      id = file.finish();
    });
    for (const std::string &bytes : communicator.gather(object_to_bytes(id)))
      manifest.ranks.push_back(object_from_bytes<CheckpointFileId>(bytes));
  }

  std::string
  CheckpointWriter::remove_others(const std::uint64_t newest_step) const
  {
    std::string  failures;
    unsigned int n_kept = 0;
    for (const CheckpointFolder::Set &set : folder.sets())
      {
        const bool is_set = set.ending.empty() && set.step <= newest_step;
        if (is_set && n_kept < n_sets)
          ++n_kept;
        else
          failures += remove_checkpoint_set(set.path);
      }
    return failures;
  }
} // namespace rift
