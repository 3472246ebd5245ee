#ifndef rift_io_probes_h
#define rift_io_probes_h

#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>
#include <rift/io/output_parameters.h>
#include <rift/mesh/surface.h>
#include <rift/solid/internal_force.h>

#include <string>
#include <vector>

namespace rift
{
  /**
   * One number of the solution over time: a component of a field at a point of
   * the undeformed body, interpolated in the cell that holds it, or averaged
   * over a surface by undeformed area.
   */
  class Probe
  {
  public:
    /**
     * @param surface where the parameters name a boundary: its faces.
     * @throws InputError if the point lies in no cell.
     */
    Probe(const Topology          &topology,
          const ReferenceCellData &reference,
          const State             &state,
          const ProbeParameters   &parameters,
          const Surface           &surface);

    /** Name and unit: "fspv [m/s]". */
    const std::string &
    header() const
    {
      return header_text;
    }

    /** @param velocity of each node at the time of `state`, m/s. */
    double
    value(const Topology                     &topology,
          const InternalForce                &internal_force,
          const State                        &state,
          const std::vector<Vector3<double>> &velocity) const;

  private:
    void
    find_point(const Topology          &topology,
               const ReferenceCellData &reference,
               const State             &state);

    void
    weigh_surface(const ReferenceCellData &reference, const Surface &surface);

    /** A corner of a cell and its share in the value. */
    struct Sample
    {
      CellIndex                     cell;
      std::array<double, n_corners> weights;
    };

    ProbeParameters     parameters;
    std::string         header_text;
    std::vector<Sample> samples;
  };

  /**
   * Velocity of each node at t_n, m/s: half a kick after that of
   * `state.velocity`. To be called between the last force and the kick.
   */
  std::vector<Vector3<double>>
  velocity_at_step(const State &state, double time_step);
} // namespace rift

#endif
