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
    communicator.together([&] {
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
    write_vtu(directory + "/" +
                file_name(times.size(), communicator.rank() / ranks_per_file),
              time,
              piece,
              communicator,
              ranks_per_file);
    times.push_back(time);
    communicator.on_root([this] { write_list(); });
  }

  std::string
  SolutionSeries::file_name(const std::size_t state, const int group) const
  {
    char number[32];
    std::snprintf(number, sizeof(number), "-%05zu", state);
    return name + number +
           (communicator.size() > ranks_per_file ? "." + std::to_string(group) :
                                                   "") +
           ".vtu";
  }

  void
  SolutionSeries::write_list() const
  {
    std::string list = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"1.0\">\n"
                       "<Collection>\n";
    for (std::size_t i = 0; i < times.size(); ++i)
      for (int group = 0; group * ranks_per_file < communicator.size(); ++group)
        list += "<DataSet timestep=\"" + to_text(times[i]) + "\" part=\"" +
                std::to_string(group) + "\" file=\"" + file_name(i, group) +
                "\"/>\n";
    write_file_atomically(directory + "/" + name + ".pvd",
                          list + "</Collection>\n</VTKFile>\n");
  }
} // namespace rift
