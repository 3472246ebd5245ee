#include <rift/io/vtu_piece.h>

#include <zlib.h>

#include <algorithm>
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
  } // namespace

  VtuPiece::VtuPiece(const Solution &solution)
  {
    check(solution);
    add_text("<Piece NumberOfPoints=\"" +
             std::to_string(solution.points.size()) + "\" NumberOfCells=\"" +
             std::to_string(solution.cells.size() / solution.nodes_per_cell) +
             "\">\n<Points>\n");
    add_array("Float64",
              "Name=\"Points\" NumberOfComponents=\"3\"",
              solution.points.data(),
              solution.points.size());
    add_text("</Points>\n<Cells>\n");
    add_cells(solution);
    add_text("</Cells>\n<PointData>\n");
    for (const auto &field : solution.point_data)
      add_field(field);
    add_text("</PointData>\n<CellData>\n");
    for (const auto &field : solution.cell_data)
      add_field(field);
    add_text("</CellData>\n</Piece>\n");
  }

  std::string
  VtuPiece::xml(const std::size_t begin) const
  {
    std::string result = texts[0];
    for (std::size_t i = 0; i < offsets.size(); ++i)
      result += std::to_string(begin + offsets[i]) + texts[i + 1];
    return result;
  }

  void
  VtuPiece::add_text(const std::string &text)
  {
    texts.back() += text;
  }

  template <typename Number>
  void
  VtuPiece::add_array(const std::string &type,
                      const std::string &attributes,
                      const Number      *numbers,
                      const std::size_t  n)
  {
    add_text("<DataArray type=\"" + type + "\" " + attributes +
             " format=\"appended\" offset=\"");
    offsets.push_back(compressed_data.size());
    texts.push_back("\"/>\n");
    add_compressed(reinterpret_cast<const char *>(numbers), n * sizeof(Number));
  }

  void
  VtuPiece::add_compressed(const char *bytes, const std::size_t n_bytes)
  {
    const std::size_t n_blocks       = (n_bytes + block_size - 1) / block_size;
    std::vector<std::uint64_t> sizes = {n_blocks,
                                        block_size,
                                        n_bytes % block_size};
    sizes.resize(3 + n_blocks);
    const std::size_t header = compressed_data.size();
    compressed_data.resize(header + 8 * sizes.size());

    std::vector<char> block(compressBound(block_size));
    for (std::size_t i = 0; i < n_blocks; ++i)
      {
        const std::size_t begin = i * block_size;
        uLongf            size  = block.size();
        if (compress2(reinterpret_cast<Bytef *>(block.data()),
                      &size,
                      reinterpret_cast<const Bytef *>(bytes + begin),
                      std::min(block_size, n_bytes - begin),
                      Z_BEST_SPEED) != Z_OK)
          throw std::bad_alloc(); // the only way in which it can fail
        sizes[3 + i] = size;
        compressed_data.append(block.data(), size);
      }
    std::copy_n(reinterpret_cast<const char *>(sizes.data()),
                8 * sizes.size(),
                &compressed_data[header]);
  }

  void
  VtuPiece::add_cells(const Solution &solution)
  {
    constexpr int     vtk_triangle = 5, vtk_tetrahedron = 10;
    const std::size_t n_cells = solution.cells.size() / solution.nodes_per_cell;

    add_array("Int32",
              "Name=\"connectivity\"",
              solution.cells.data(),
              solution.cells.size());

    std::vector<std::int32_t> ends(n_cells);
    for (std::size_t i = 0; i < n_cells; ++i)
      ends[i] = solution.nodes_per_cell * (i + 1);
    add_array("Int32", "Name=\"offsets\"", ends.data(), n_cells);

    const std::vector<std::uint8_t> types(
      n_cells,
      solution.nodes_per_cell == 3 ? vtk_triangle : vtk_tetrahedron);
    add_array("UInt8", "Name=\"types\"", types.data(), n_cells);
  }

  void
  VtuPiece::add_field(const OutputField &field)
  {
    std::string attributes = "Name=" + quote(field.name) +
                             " NumberOfComponents=\"" +
                             std::to_string(field.n_components) + '"';
    for (std::size_t c = 0; c < field.components.size(); ++c)
      attributes +=
        " ComponentName" + std::to_string(c) + "=" + quote(field.components[c]);
    if (field.n_components < 6)
      {
        add_array("Float32",
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
    add_array("Float32",
              attributes + " ComponentName0=\"XX\" ComponentName1=\"YY\""
                           " ComponentName2=\"ZZ\" ComponentName3=\"XY\""
                           " ComponentName4=\"YZ\" ComponentName5=\"XZ\"",
              reordered.data(),
              reordered.size());
  }
} // namespace rift
