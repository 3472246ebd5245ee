#ifndef rift_io_vtu_output_h
#define rift_io_vtu_output_h

#include <rift/base/types.h>
#include <rift/base/vector3.h>

#include <string>
#include <utility>
#include <vector>

/**
 * Output for ParaView: one .vtu file for each state and a .pvd file that lists
 * them with their times.
 *
 * rift writes these files itself. deal.II's DataOut gives each cell nodes of
 * its own, so that ParaView cannot see which cells hang together (its
 * connectivity filter is what shows the fragments of a run), has coordinates in
 * single precision, about 3 cm at the coordinates of a mine, and does not
 * notice a full disk. It is also dear. For 1.7 million tetrahedra with
 * displacement, velocity, stress and two scalars, both at zlib's best speed,
 * this writer took 2.2 to 2.7 s, 87 bytes of memory and 33 of disk per cell;
 * deal.II's patches and writer took 10 s, 1050 bytes and 75.
 */
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
  };

  /** One state of the solid or of the fracture surfaces. */
  struct Solution
  {
    /** 4: tetrahedra. 3: triangles. */
    unsigned int nodes_per_cell = n_corners;

    /** Coordinates, m. */
    std::vector<Vector3<double>> points;

    /** Indices into `points`, cell after cell. */
    std::vector<NodeIndex> cells;

    std::vector<OutputField> point_data;
    std::vector<OutputField> cell_data;
  };

  /**
   * Writes one state; the file appears complete or not at all. A state without
   * cells is fine: before the first crack there is no fracture surface.
   *
   * @param time is in the file as ParaView's TimeValue, s.
   *
   * @throws DiskError        if the file cannot be written.
   * @throws std::logic_error if sizes do not fit or a cell has a node that
   *   does not exist: an error of the caller, with the field's name.
   */
  void
  write_vtu(const std::string &path, double time, const Solution &solution);

  /**
   * The states of a run: NAME.pvd and NAME-00000.vtu, NAME-00001.vtu, ... in
   * one directory. NAME is `solid` or `fracture`: see is_result_file().
   */
  class SolutionSeries
  {
  public:
    SolutionSeries(const std::string &directory, const std::string &name);

    /**
     * Writes the next state, and then the .pvd anew, so that the results can
     * be opened while the run goes on or after it was killed.
     *
     * @throws what write_vtu() throws.
     */
    void
    write(double time, const Solution &solution);

  private:
    const std::string directory;
    const std::string name;

    /** Time and file name of each state so far. */
    std::vector<std::pair<double, std::string>> states;
  };
} // namespace rift

#endif
