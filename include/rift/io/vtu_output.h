#ifndef rift_io_vtu_output_h
#define rift_io_vtu_output_h

#include <rift/base/communicator.h>
#include <rift/io/vtu_piece.h>

#include <string>
#include <vector>

/**
 * @file
 *
 * Output for ParaView: one .vtu file for each state and a .pvd file that lists
 * them with their times. On many ranks each makes a piece of its own cells, and
 * a state is a file for each group of ranks, with their pieces. A node at which
 * pieces meet stands in each of them.
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
   * Writes one state; the file appears complete or not at all. A state without
   * cells is fine: before the first crack there is no fracture surface.
   *
   * Collective. Each rank gives its piece; `ranks_per_file` ranks after each
   * other, which have the same `path`, make one file. The first of them holds
   * one piece of another at a time.
   *
   * @param time is in the file as ParaView's TimeValue, s.
   *
   * @throws DiskError        on all ranks if a file cannot be written.
   * @throws std::logic_error if sizes do not fit or a cell has a node that
   *   does not exist: an error of the caller, with the field's name.
   */
  void
  write_vtu(const std::string  &path,
            double              time,
            const Solution     &piece,
            const Communicator &communicator   = {},
            int                 ranks_per_file = 1);

  /**
   * The states of a run: NAME.pvd and NAME-00000.vtu, NAME-00001.vtu, ... in
   * one directory, or NAME-00000.0.vtu, NAME-00000.1.vtu, ... for a state of
   * several files. NAME is `solid` or `fracture`: see is_result_file().
   */
  class SolutionSeries
  {
  public:
    /** Writes nothing before write() is called. `ranks_per_file`: see
     * write_vtu(). */
    SolutionSeries(const std::string  &directory,
                   const std::string  &name,
                   const Communicator &communicator   = {},
                   int                 ranks_per_file = 1);

    /**
     * Writes the next state, and then the .pvd anew, so that the results can
     * be opened while the run goes on or after it was killed. Collective.
     *
     * @throws what write_vtu() throws.
     */
    void
    write(double time, const Solution &piece);

    /** One state on the disk: its time, s, and in how many files it is, which
     * is not the same after a restart on another number of ranks. */
    struct WrittenState
    {
      /** Its time, s, and the number of its files. */
      double time;
      int    n_files;
    };

    /** All states so far. */
    const std::vector<WrittenState> &
    states() const
    {
      return states_so_far;
    }

    /**
     * After a restart: goes on behind these states, which states() has told.
     * Later ones that are on the disk will be written over.
     */
    void
    go_on_after(const std::vector<WrittenState> &states)
    {
      states_so_far = states;
    }

  private:
    /** Name of one of the files of a state. */
    std::string
    file_name(std::size_t state, int file, int n_files) const;

    void
    write_list() const;

    const std::string  directory;
    const std::string  name;
    const Communicator communicator;
    const int          ranks_per_file;

    std::vector<WrittenState> states_so_far;
  };
} // namespace rift

#endif
