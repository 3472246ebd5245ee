#ifndef rift_io_vtu_piece_h
#define rift_io_vtu_piece_h

#include <rift/base/types.h>
#include <rift/base/vector3.h>

#include <string>
#include <vector>

namespace rift
{
  /**
   * Values at the points or on the cells of a Solution.
   *
   * They are in single precision: an integer is exact up to 16.7 million.
   */
  struct OutputField
  {
    /** With its unit in brackets: "velocity [m/s]". */
    std::string name;

    /**
     * 1 for a scalar, 3 for a vector, 6 for a symmetric tensor in rift's order
     * xx yy zz yz xz xy; the file has VTK's order and names of components.
     */
    unsigned int n_components = 1;

    /** Component c of item i is at `n_components * i + c`. */
    std::vector<float> values;

    /** What ParaView calls the components of a vector; empty: X, Y, Z. */
    std::vector<std::string> components = {};
  };

  /** One state of the solid or of the fracture surfaces. */
  struct Solution
  {
    /** 4: tetrahedra. 3: triangles. */
    unsigned int nodes_per_cell = n_corners;

    /** Coordinates, m, in the undeformed body: ParaView adds the displacement.
     * They are in double precision, which they need at the coordinates of a
     * mine; a field of displacements does not. */
    std::vector<Vector3<double>> points;

    /** Indices into `points`, cell after cell. */
    std::vector<NodeIndex> cells;

    /** Fields of the points and of the cells. */
    std::vector<OutputField> point_data;
    std::vector<OutputField> cell_data;
  };

  /** A Solution as it stands in a .vtu file, its arrays compressed. */
  class VtuPiece
  {
  public:
    /**
     * @throws std::logic_error if sizes do not fit or a cell has a node that
     *   does not exist: an error of the caller, with the field's name.
     */
    explicit VtuPiece(const Solution &solution);

    /** The bytes of all arrays. */
    const std::string &
    data() const
    {
      return compressed_data;
    }

    /** The element `Piece`, for a file in which `begin` bytes of other pieces
     * stand before data(). */
    std::string
    xml(std::size_t begin) const;

  private:
    void
    add_text(const std::string &text);

    /** An array of `n` numbers of VTK's type `type`. */
    template <typename Number>
    void
    add_array(const std::string &type,
              const std::string &attributes,
              const Number      *numbers,
              std::size_t        n);

    /**
     * Appends blocks in VTK's layout: the number of blocks, their size, the
     * size of the last one (0 if it is full), the compressed size of each,
     * then the blocks.
     */
    void
    add_compressed(const char *bytes, std::size_t n_bytes);

    void
    add_cells(const Solution &solution);

    void
    add_field(const OutputField &field);

    std::string compressed_data;

    /** The element, cut where the offset of an array in data() belongs. */
    std::vector<std::string> texts = {""};
    std::vector<std::size_t> offsets;
  };
} // namespace rift

#endif
