#include <rift/base/number_text.h>
#include <rift/base/output_file.h>
#include <rift/io/vtu_output.h>

#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace rift
{
  namespace
  {
    /** Bytes that are compressed at a time. */
    constexpr std::size_t block_size = 1 << 18;

    std::string
    quote(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        switch (c)
          {
          case '&':
            result += "&amp;";
            break;
          case '<':
            result += "&lt;";
            break;
          case '>':
            result += "&gt;";
            break;
          case '"':
            result += "&quot;";
            break;
          default:
            result += c;
          }
      return result + '"';
    }

    void
    append_bytes(const void       *data,
                 const std::size_t n_bytes,
                 std::string      &destination)
    {
      destination.append(static_cast<const char *>(data), n_bytes);
    }

    /**
     * Collects a file: the elements go to `xml`, the arrays that they describe
     * to `data`, compressed.
     */
    struct FileContent
    {
      std::string xml;
      std::string data;

      /** An array of `n` numbers of VTK's type `type`. */
      template <typename Number>
      void
      add_array(const std::string &type,
                const std::string &attributes,
                const Number      *numbers,
                const std::size_t  n)
      {
        xml += "<DataArray type=\"" + type + "\" " + attributes +
               " format=\"appended\" offset=\"" + std::to_string(data.size()) +
               "\"/>\n";
        add_compressed(reinterpret_cast<const Bytef *>(numbers),
                       n * sizeof(Number));
      }

    private:
      /**
       * Appends blocks in VTK's layout: the number of blocks, their size, the
       * size of the last one (0 if it is full), the compressed size of each,
       * then the blocks.
       */
      void
      add_compressed(const Bytef *bytes, const std::size_t n_bytes)
      {
        const std::size_t n_blocks = (n_bytes + block_size - 1) / block_size;
        std::vector<std::uint64_t> sizes = {n_blocks,
                                            block_size,
                                            n_bytes % block_size};
        sizes.resize(3 + n_blocks);

        const std::size_t header = data.size();
        append_bytes(sizes.data(), 8 * sizes.size(), data);

        std::vector<Bytef> compressed(compressBound(block_size));
        for (std::size_t block = 0; block < n_blocks; ++block)
          {
            const std::size_t begin = block * block_size;
            uLongf            size  = compressed.size();
            if (compress2(compressed.data(),
                          &size,
                          bytes + begin,
                          std::min(block_size, n_bytes - begin),
                          Z_BEST_SPEED) != Z_OK)
              throw std::bad_alloc(); // the only way in which it can fail
            sizes[3 + block] = size;
            append_bytes(compressed.data(), size, data);
          }
        std::copy_n(reinterpret_cast<const char *>(sizes.data()),
                    8 * sizes.size(),
                    &data[header]);
      }
    };

    void
    require(const bool condition, const std::string &message)
    {
      if (!condition)
        throw std::logic_error("write_vtu: " + message);
    }

    void
    check(const std::vector<OutputField> &fields, const std::size_t n_items)
    {
      for (const auto &field : fields)
        {
          require(field.n_components == 1 || field.n_components == 3 ||
                    field.n_components == 6,
                  "field " + field.name + " has " +
                    std::to_string(field.n_components) +
                    " components instead of 1, 3 or 6");
          require(field.values.size() == field.n_components * n_items,
                  "field " + field.name + " has " +
                    std::to_string(field.values.size()) +
                    " values instead of " +
                    std::to_string(field.n_components * n_items));
        }
    }

    void
    check(const Solution &solution)
    {
      const auto &cells = solution.cells;
      require(solution.nodes_per_cell == 3 || solution.nodes_per_cell == 4,
              "cells have " + std::to_string(solution.nodes_per_cell) +
                " nodes instead of 3 or 4");
      require(cells.size() % solution.nodes_per_cell == 0,
              "the last cell is incomplete");
      const auto largest = std::max_element(cells.begin(), cells.end());
      require(cells.empty() || *largest < solution.points.size(),
              "a cell has a node that does not exist");
      check(solution.point_data, solution.points.size());
      check(solution.cell_data, cells.size() / solution.nodes_per_cell);
    }

    void
    add_field(const OutputField &field, FileContent &file)
    {
      const std::string attributes = "Name=" + quote(field.name) +
                                     " NumberOfComponents=\"" +
                                     std::to_string(field.n_components) + '"';
      if (field.n_components < 6)
        {
          file.add_array("Float32",
                         attributes,
                         field.values.data(),
                         field.values.size());
          return;
        }

      // VTK's order is xx yy zz xy yz xz.
      constexpr unsigned int vtk_order[6] = {0, 1, 2, 5, 3, 4};
      std::vector<float>     reordered(field.values.size());
      for (std::size_t i = 0; i < reordered.size(); ++i)
        reordered[i] = field.values[i - i % 6 + vtk_order[i % 6]];
      file.add_array("Float32",
                     attributes +
                       " ComponentName0=\"XX\" ComponentName1=\"YY\""
                       " ComponentName2=\"ZZ\" ComponentName3=\"XY\""
                       " ComponentName4=\"YZ\" ComponentName5=\"XZ\"",
                     reordered.data(),
                     reordered.size());
    }

    void
    add_cells(const Solution &solution, FileContent &file)
    {
      constexpr int     vtk_triangle = 5, vtk_tetrahedron = 10;
      const std::size_t n_cells =
        solution.cells.size() / solution.nodes_per_cell;

      file.add_array("Int32",
                     "Name=\"connectivity\"",
                     solution.cells.data(),
                     solution.cells.size());

      std::vector<std::int32_t> offsets(n_cells);
      for (std::size_t i = 0; i < n_cells; ++i)
        offsets[i] = solution.nodes_per_cell * (i + 1);
      file.add_array("Int32", "Name=\"offsets\"", offsets.data(), n_cells);

      const std::vector<std::uint8_t> types(
        n_cells,
        solution.nodes_per_cell == 3 ? vtk_triangle : vtk_tetrahedron);
      file.add_array("UInt8", "Name=\"types\"", types.data(), n_cells);
    }

    FileContent
    collect(const double time, const Solution &solution)
    {
      FileContent file;
      file.xml =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
        "compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
        "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" "
        "NumberOfTuples=\"1\" format=\"ascii\">" +
        to_text(time) + "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"" +
        std::to_string(solution.points.size()) + "\" NumberOfCells=\"" +
        std::to_string(solution.cells.size() / solution.nodes_per_cell) +
        "\">\n<Points>\n";
      file.add_array("Float64",
                     "Name=\"Points\" NumberOfComponents=\"3\"",
                     solution.points.data(),
                     solution.points.size());
      file.xml += "</Points>\n<Cells>\n";
      add_cells(solution, file);
      file.xml += "</Cells>\n<PointData>\n";
      for (const auto &field : solution.point_data)
        add_field(field, file);
      file.xml += "</PointData>\n<CellData>\n";
      for (const auto &field : solution.cell_data)
        add_field(field, file);
      file.xml += "</CellData>\n</Piece>\n</UnstructuredGrid>\n"
                  "<AppendedData encoding=\"raw\">\n_";
      return file;
    }
  } // namespace

  void
  write_vtu(const std::string &path,
            const double       time,
            const Solution    &solution)
  {
    static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
                  "the files say that their numbers are little-endian");
    check(solution);
    const FileContent content = collect(time, solution);

    AtomicFile file(path);
    file.write(content.xml);
    file.write(content.data);
    file.write("\n</AppendedData>\n</VTKFile>\n");
    file.commit();
  }

  SolutionSeries::SolutionSeries(const std::string &directory,
                                 const std::string &name)
    : directory(directory)
    , name(name)
  {
  }

  void
  SolutionSeries::write(const double time, const Solution &solution)
  {
    char number[32];
    std::snprintf(number, sizeof(number), "-%05zu.vtu", states.size());
    const std::string file_name = name + number;
    write_vtu(directory + "/" + file_name, time, solution);
    states.emplace_back(time, file_name);

    std::string list = "<?xml version=\"1.0\"?>\n"
                       "<VTKFile type=\"Collection\" version=\"1.0\">\n"
                       "<Collection>\n";
    for (const auto &[time_of_state, file] : states)
      list += "<DataSet timestep=\"" + to_text(time_of_state) +
              "\" part=\"0\" file=" + quote(file) + "/>\n";
    write_file_atomically(directory + "/" + name + ".pvd",
                          list + "</Collection>\n</VTKFile>\n");
  }
} // namespace rift
