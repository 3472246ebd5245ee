#ifndef rift_io_probes_h
#define rift_io_probes_h

#include <rift/base/communicator.h>
#include <rift/base/exact_sum.h>
#include <rift/discretization/field_list.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/io/output_parameters.h>
#include <rift/mesh/surface.h>

#include <string>
#include <vector>

namespace rift
{
  /**
   * One number of the solution over time: a component of a field at a point of
   * the undeformed body, interpolated in the cell that holds it, or averaged
   * over a surface by undeformed area, or the force on rigid bodies. A rank
   * computes the part of the cells that it owns; the sum over the ranks does
   * not depend on who owns what.
   */
  class Probe
  {
  public:
    /**
     * Collective.
     *
     * @param surface where the parameters name a boundary: its faces.
     * @throws InputError if the point lies in no cell.
     */
    Probe(const Topology          &topology,
          const ReferenceCellData &reference,
          const State             &state,
          const ProbeParameters   &parameters,
          const Surface           &surface,
          const Communicator      &communicator);

    /** Name and unit: "fspv [m/s]". */
    std::string
    header() const
    {
      return title(parameters.name, parameters.field.unit);
    }

    /**
     * The part of this rank in the value.
     *
     * @throws InputError if nothing in the scene has the field.
     */
    ExactSum
    sum(const Topology &topology, const FieldList &fields) const;

  private:
    /** A cell, and the shares of its corners in the value. */
    struct Sample
    {
      CellIndex                     cell;
      std::array<double, n_corners> weights;
    };

    void
    find_point(const Topology          &topology,
               const ReferenceCellData &reference,
               const State             &state,
               const Communicator      &communicator);

    void
    weigh_surface(const Topology          &topology,
                  const ReferenceCellData &reference,
                  const Surface           &surface,
                  const Communicator      &communicator);

    ProbeParameters     parameters;
    std::vector<Sample> samples;
  };

  /** The values of all probes, on all ranks. Collective. */
  std::vector<double>
  probe_values(const std::vector<Probe> &probes,
               const Topology           &topology,
               const FieldList          &fields,
               const Communicator       &communicator);

  /** Velocity of each node at t_n, m/s; see velocity_at_step(). */
  std::vector<Vector3<double>>
  velocity_at_step(const State &state, double time_step);
} // namespace rift

#endif
