#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/base/output_file.h>
#include <rift/io/vtu_output.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>

namespace rift
{
  namespace
  {
    /** What stands in the file before the pieces. */
    std::string
    file_begin(const double time)
    {
      return "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
             "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
             "compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
             "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" "
             "NumberOfTuples=\"1\" format=\"ascii\">" +
             to_text(time) + "</DataArray>\n</FieldData>\n";
    }

    /** Bytes of all that the ranks [first, last) have in `data`. */
    std::size_t
    sum_of_sizes(const std::vector<std::string> &sizes,
                 const int                       first,
                 const int                       last)
    {
      std::size_t sum = 0;
      for (int rank = first; rank < last; ++rank)
        sum += std::stoull(sizes[rank]);
      return sum;
    }

    /**
     * Writes the file of a group of ranks, of which this is the first one. All
     * that the others send is received, even when the disk is full.
     */
    void
    write_pieces(const std::string  &path,
                 const double        time,
                 const std::string  &own_xml,
                 const std::string  &own_data,
                 const Communicator &communicator,
                 const int           end_of_group)
    {
      std::exception_ptr        failure;
      std::optional<AtomicFile> file;
      const auto                attempt = [&](const auto &action) {
        try
          {
            if (!failure)
              action();
          }
        catch (const DiskError &)
          {
            failure = std::current_exception();
          }
      };
      const auto write = [&](const std::string &text) {
        attempt([&] { file->write(text); });
      };
      const auto write_all = [&](const std::string &own) {
        write(own);
        for (int rank = communicator.rank() + 1; rank < end_of_group; ++rank)
          write(communicator.receive(rank));
      };

      attempt([&] { file.emplace(path); });
      write(file_begin(time));
      write_all(own_xml);
      write("</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
      write_all(own_data);
      write("\n</AppendedData>\n</VTKFile>\n");
      attempt([&] { file->commit(); });
      if (failure)
        std::rethrow_exception(failure);
    }
  } // namespace

  void
  write_vtu(const std::string  &path,
            const double        time,
            const Solution     &solution,
            const Communicator &communicator,
            const int           ranks_per_file)
  {
    static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
                  "the files say that their numbers are little-endian");
    const VtuPiece piece(solution);
    const int      rank  = communicator.rank();
    const int      first = rank - rank % ranks_per_file;
    const auto     sizes =
      communicator.all_gather(std::to_string(piece.data().size()));
    const std::string xml = piece.xml(sum_of_sizes(sizes, first, rank));
    communicator.collectively([&] {
      if (rank == first)
        write_pieces(path,
                     time,
                     xml,
                     piece.data(),
                     communicator,
                     std::min(first + ranks_per_file, communicator.size()));
      else
        {
          communicator.send(xml, first);
          communicator.send(piece.data(), first);
        }
    });
  }

  SolutionSeries::SolutionSeries(const std::string  &directory,
                                 const std::string  &name,
                                 const Communicator &communicator,
                                 const int           ranks_per_file)
    : directory(directory)
    , name(name)
    , communicator(communicator)
    , ranks_per_file(ranks_per_file)
  {
  }

  void
  SolutionSeries::write(const double time, const Solution &piece)
  {
    const int n_files =
      (communicator.size() + ranks_per_file - 1) / ranks_per_file;
    write_vtu(directory + "/" +
                file_name(states_so_far.size(),
                          communicator.rank() / ranks_per_file,
                          n_files),
              time,
              piece,
              communicator,
              ranks_per_file);
    states_so_far.push_back({time, n_files});
    communicator.on_root([this] { write_list(); });
  }

  std::string
  SolutionSeries::file_name(const std::size_t state,
                            const int         file,
                            const int         n_files) const
  {
    char number[32];
    std::snprintf(number, sizeof(number), "-%05zu", state);
    return name + number + (n_files > 1 ? "." + std::to_string(file) : "") +
           ".vtu";
  }

  void
  SolutionSeries::write_list() const
  {
    std::string list = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"1.0\">\n"
                       "<Collection>\n";
    for (std::size_t i = 0; i < states_so_far.size(); ++i)
      for (int file = 0; file < states_so_far[i].n_files; ++file)
        list += "<DataSet timestep=\"" + to_text(states_so_far[i].time) +
                "\" part=\"" + std::to_string(file) + "\" file=\"" +
                file_name(i, file, states_so_far[i].n_files) + "\"/>\n";
    write_file_atomically(directory + "/" + name + ".pvd",
                          list + "</Collection>\n</VTKFile>\n");
  }
} // namespace rift
